// What a visitor can set. Every setting is a list of named values.
#include "app/session/status.h"
#include "app/session/visit_work.h"
#include "audio-cues/speech/speech_rate.h"

#include <algorithm>
#include <array>
#include <string>

namespace touchline {
namespace {

// In the order of their enumerations or steps.
constexpr std::array modes{"wall", "groove", "ridge", "sticky line"};
constexpr std::array amounts{"none of them", "short ones", "all of them"};
constexpr std::array sizes{"ordinary", "large", "larger", "largest"};
constexpr std::array palettes{"light letters on dark", "dark letters on light",
                              "warm letters on dark", "low glare"};

template <std::size_t count>
std::vector<std::string> named(const Language& language, const char* context,
                               const std::array<const char*, count>& texts) {
    std::vector<std::string> names;
    for (const char* text : texts) names.push_back(language.text(context, text));
    return names;
}

/// Without "of 7", which the place on the screen says already.
std::vector<std::string> stepped(const Language& language, std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t step = 1; step <= count; ++step)
        names.push_back(language.text("speech", "Step {0}", {std::to_string(step)}));
    return names;
}

std::vector<std::string> stiffness_names(const Language& language) {
    std::vector<std::string> names;
    for (const StiffnessStep& step : stiffness_steps) {
        names.push_back(language.text("stiffness", std::string(step.name)));
    }
    return names;
}

std::vector<std::string> language_names(const VisitWorld& world) {
    std::vector<std::string> names;
    for (const Language& language : world.languages) names.push_back(language.name());
    return names;
}

void choose_language(VisitWork& work, std::size_t language) {
    work.visitor.sound.language = language;
    open_unasked(work);
}

void choose_detail(VisitWork& work, int detail) {
    work.visitor.detail = detail;
    const LoadPicture& felt = work.visitor.felt->order;
    if (felt.detail == detail && !work.visitor.loading) return;
    open_again(work, felt, LoadReason::detail);
}

}  // namespace

std::string name_of(VisitItem setting, const Language& language) {
    switch (setting) {
        case VisitItem::language:
            return language.text("visit", "Language");
        case VisitItem::volume:
            return language.text("visit", "Volume");
        case VisitItem::rate:
            return language.text("visit", "Speaking speed");
        case VisitItem::sounds:
            return language.text("visit", "Sounds");
        case VisitItem::text_size:
            return language.text("visit", "Size of letters");
        case VisitItem::palette:
            return language.text("visit", "Contrast");
        case VisitItem::detail:
            return language.text("visit", "Detail");
        case VisitItem::mode:
            return language.text("visit", "Kind of line");
        case VisitItem::stiffness:
            return language.text("visit", "Firmness");
        case VisitItem::held_shape:
            return language.text("visit", "Shape in the hand");
        default:
            return {};
    }
}

ValueList values_of(const Visit& visit, const VisitWorld& world, VisitItem setting) {
    const Language& language = language_of(visit, world);
    const Visitor& visitor = visit.visitor;
    switch (setting) {
        case VisitItem::language:
            return {language_names(world), visitor.sound.language};
        case VisitItem::volume:
            return {stepped(language, world.rules.volume_steps), visitor.sound.volume};
        case VisitItem::rate:
            return {stepped(language, speech_rates_per_minute.size()), visitor.sound.rate};
        case VisitItem::sounds:
            return {named(language, "visit", amounts),
                    static_cast<std::size_t>(visitor.sound.amount)};
        case VisitItem::text_size:
            return {named(language, "visit", sizes), visitor.look.text_size};
        case VisitItem::palette:
            return {named(language, "visit", palettes), visitor.look.palette};
        case VisitItem::detail:
            return {named(language, "detail", detail_names),
                    static_cast<std::size_t>(std::clamp(visitor.detail, 1, 5) - 1)};
        case VisitItem::mode:
            return {named(language, "mode", modes), static_cast<std::size_t>(visitor.feel.mode)};
        case VisitItem::stiffness:
            return {stiffness_names(language), visitor.feel.stiffness};
        case VisitItem::held_shape:
            return {named(language, "shape", shape_names),
                    static_cast<std::size_t>(visitor.feel.shape)};
        default:
            return {};
    }
}

void choose_value(VisitWork& work, VisitItem setting, std::size_t value) {
    Visitor& visitor = work.visitor;
    leave(work);
    switch (setting) {
        case VisitItem::language:
            choose_language(work, value);
            break;
        case VisitItem::volume:
            visitor.sound.volume = value;
            break;
        case VisitItem::rate:
            visitor.sound.rate = value;
            break;
        case VisitItem::sounds:
            visitor.sound.amount = static_cast<CueAmount>(value);
            break;
        case VisitItem::text_size:
            visitor.look.text_size = value;
            break;
        case VisitItem::palette:
            visitor.look.palette = value;
            break;
        case VisitItem::detail:
            choose_detail(work, static_cast<int>(value) + 1);
            break;
        case VisitItem::mode:
            visitor.feel.mode = static_cast<Mode>(value);
            break;
        case VisitItem::stiffness:
            visitor.feel.stiffness = value;
            break;
        case VisitItem::held_shape:
            visitor.feel.shape = static_cast<HeldShape>(value);
            break;
        default:
            break;
    }
    // If work began, its result is said later.
    if (open_screen(work) != VisitScreen::opening) say_item(work);
}

void change_volume(VisitWork& work, int change) {
    const Language& language = language_of(work);
    std::size_t& volume = work.visitor.sound.volume;
    const std::size_t last = work.world.rules.volume_steps - 1;
    const bool is_at_end = change > 0 ? volume >= last : volume == 0;
    if (is_at_end) {
        cue(work, ScreenEvent::list_end);
        shake(work, HandlePattern::edge);
        return say(work, language.text("speech", change > 0 ? "This is the loudest."
                                                            : "This is the softest."));
    }
    volume = change > 0 ? volume + 1 : volume - 1;
    cue(work, ScreenEvent::key_taken);
    say(work, language.text("speech", "Volume {0} of {1}",
                            {std::to_string(volume + 1), std::to_string(last + 1)}));
}

void change_rate(VisitWork& work, int change) {
    const Language& language = language_of(work);
    std::size_t& rate = work.visitor.sound.rate;
    const std::size_t last = speech_rates_per_minute.size() - 1;
    const bool is_at_end = change > 0 ? rate >= last : rate == 0;
    cue(work, is_at_end ? ScreenEvent::list_end : ScreenEvent::key_taken);
    if (is_at_end) {
        return say(work, language.text("speech", change > 0 ? "This is the fastest."
                                                            : "This is the slowest."));
    }
    rate = change > 0 ? rate + 1 : rate - 1;
    say(work, language.text("speech", "Speaking speed {0} of {1}",
                            {std::to_string(rate + 1), std::to_string(last + 1)}));
}

void reset_settings(VisitWork& work) {
    const Visitor first = new_visitor(work.site, work.world);
    const std::size_t language = work.visitor.sound.language;
    work.visitor.sound = first.sound;
    work.visitor.sound.language = language;  // or the visitor would understand nothing more
    work.visitor.look = first.look;
    work.visitor.feel = first.feel;
}

void follow_settings(VisitWork& work, const Settings& before) {
    const Settings& now = work.world.settings;
    if (now.mode != before.mode) work.visitor.feel.mode = static_cast<Mode>(now.mode);
    if (now.detail == before.detail) return;
    work.visitor.detail = now.detail;
    open_unasked(work);
}

}  // namespace touchline
