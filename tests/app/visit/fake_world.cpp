#include "tests/app/visit/fake_world.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace touchline {
namespace {

std::vector<Language> read_all() {
    std::vector<Language> languages;
    const auto codes = languages_in(TOUCHLINE_CATALOGUES).value();
    for (const std::string& code : codes) {
        auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        if (!language) {
            std::cerr << language.error().line << '\n';
            std::abort();
        }
        languages.push_back(*language);
    }
    return languages;
}

std::vector<GalleryTitle> twelve_pictures(const std::string& code) {
    std::vector<GalleryTitle> pictures;
    for (int i = 1; i <= 12; ++i) {
        const auto grade = i % 6 == 0 ? std::nullopt : std::optional(6 - i % 6);
        pictures.push_back({"Picture " + std::to_string(i) + " " + code, "From the side.", grade});
    }
    return pictures;
}

}  // namespace

const std::vector<Language>& all_languages() {
    static const std::vector<Language> languages = read_all();
    return languages;
}

PictureFacts fake_facts(const LoadPicture& order) {
    const std::string code = all_languages()[order.language].code();
    PictureFacts facts;
    facts.title = "Thing " + std::to_string(order.index) + " " + code;
    facts.description = "From the side, its head to the left.";
    facts.parts = {{"Body " + code, {-0.03, 0.02}, {0.0, 0.0}, 1, 0},
                   {"Tail " + code, {0.04, -0.02}, {0.04, -0.01}, 2, 1}};
    facts.outline_count = 2 + order.detail;
    if (order.source == PictureSource::stick) facts.place = {order.page, 2, order.view, 3};
    return facts;
}

PictureFacts facts_of_drawing(const TactileMap& map) {
    PictureFacts facts;
    facts.title = map.title;
    facts.outline_count = static_cast<int>(map.outlines.size());
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const Outline& outline = map.outlines[i];
        facts.parts.push_back({outline.label, outline.points.front(), outline.points.front(), 1,
                               static_cast<int>(i)});
    }
    return facts;
}

FakeHouse::FakeHouse(VisitRules house_rules) : rules(std::move(house_rules)) {
    for (const Language& language : languages) gallery.push_back(twelve_pictures(language.code()));
    settings.offers_shapes = true;
    settings.offers_drawing = true;
    VisitStep first = start_visit(world());
    visit = std::move(first.visit);
    orders = std::move(first.orders);
    apply(CameraChanged{true});
    wait(0.05);  // the clock is told
}

void FakeHouse::carry_out_load(const LoadPicture& order) {
    if (loads_fail) {
        due_.push_back({now_s + load_s, PictureFailed{order.request, {}}});
    } else {
        due_.push_back({now_s + load_s, PictureReady{order.request, fake_facts(order)}});
    }
}

void FakeHouse::carry_out(const VisitOrder& order) {
    if (const auto* said = std::get_if<Utterance>(&order)) {
        transcript.push_back({now_s, said->language, said->text, said->priority});
        sounded_s = now_s;
    }
    if (std::holds_alternative<GiveCue>(order)) sounded_s = now_s;
    if (const auto* load = std::get_if<LoadPicture>(&order)) carry_out_load(*load);
    if (const auto* felt = std::get_if<FeelDrawing>(&order))
        due_.push_back({now_s, PictureReady{felt->request, facts_of_drawing(felt->map)}});
    if (std::holds_alternative<PrintSheet>(order))
        due_.push_back({now_s + print_s, SheetEnded{print_end}});
    if (std::holds_alternative<Capture>(order)) due_.push_back({now_s + 0.5, CameraCaptured{}});
    if (const auto* guide = std::get_if<Guide>(&order)) {
        is_leading = guide->kind != GuideKind::stop;
        std::erase_if(
            due_, [](const Due& due) { return std::holds_alternative<GuidanceEnded>(due.event); });
        if (is_leading) due_.push_back({now_s + lead_s, GuidanceEnded{}});
    }
}

void FakeHouse::apply(const VisitEvent& event) {
    if (std::holds_alternative<GuidanceEnded>(event)) is_leading = false;
    VisitStep next = step(visit, event, world());
    visit = std::move(next.visit);
    orders = std::move(next.orders);
    for (const VisitOrder& order : orders) carry_out(order);
    all_orders.insert(all_orders.end(), orders.begin(), orders.end());
}

void FakeHouse::press(std::initializer_list<KeyRole> roles) {
    for (const KeyRole role : roles) press(role);
}

void FakeHouse::come_due() {
    for (std::size_t i = 0; i < due_.size();) {
        if (due_[i].time_s > now_s) {
            ++i;
            continue;
        }
        const VisitEvent event = due_[i].event;
        due_.erase(due_.begin() + static_cast<std::ptrdiff_t>(i));
        apply(event);
        i = 0;
    }
}

void FakeHouse::wait(double seconds) {
    const double end_s = now_s + seconds;
    while (now_s < end_s) {
        now_s = std::min(now_s + 0.05, end_s);
        apply(Tick{now_s});
        come_due();
    }
}

bool FakeHouse::find(const std::string& name) {
    const std::size_t count = screen().items.size();
    for (std::size_t tries = 0; tries <= count; ++tries) {
        const SpokenScreen now = screen();
        if (now.focus && now.items[*now.focus].name == name) return true;
        press(KeyRole::down);
    }
    return false;
}

bool FakeHouse::choose(const std::string& name) {
    if (!find(name)) return false;
    press(KeyRole::select);
    return true;
}

bool FakeHouse::choose_picture(const std::string& name) {
    if (choose(name)) return true;
    for (std::size_t i = 0; i < screen().items.size(); ++i) {
        const SpokenScreen now = screen();
        const std::string place = now.items[*now.focus].place.value_or("");
        if (!place.empty() && !place.starts_with("picture ")) {
            press(KeyRole::select);
            if (choose_picture(name)) return true;
            press(KeyRole::back);
        }
        press(KeyRole::down);
    }
    return false;
}

bool FakeHouse::has_said(const std::string& part, std::size_t from) const {
    return std::any_of(
        transcript.begin() + static_cast<std::ptrdiff_t>(from), transcript.end(),
        [&](const HeardText& heard) { return heard.text.find(part) != std::string::npos; });
}

std::string FakeHouse::last_said() const {
    return transcript.empty() ? std::string() : transcript.back().text;
}

}  // namespace touchline
