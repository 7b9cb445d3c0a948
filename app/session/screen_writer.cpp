#include "app/session/screen_writer.h"

#include <algorithm>
#include <numeric>

namespace touchline {
namespace {

constexpr const char* choice_hint = "Press Select to choose this, Up or Down to move.";
constexpr const char* only_hint = "Press Select to choose this.";
constexpr const char* change_hint = "Press Select to change it.";
constexpr const char* switch_hint = "Press Select to choose this, or move on.";

/// Two switches have no Up and Down.
const char* hint_of_choice(const VisitWorld& world) {
    return has_keys(world) ? choice_hint : switch_hint;
}

}  // namespace

std::string ScreenWriter::words(const char* english) const {
    return language.text("visit", english);
}

void ScreenWriter::title(const char* english) {
    screen.title = words(english);
}

void ScreenWriter::sentence(const char* english) {
    told(words(english));
}

void ScreenWriter::told(const std::string& text) {
    add_sentence(screen.text, text);
}

void ScreenWriter::item(VisitItem item, const char* english, const std::string& value,
                        const char* hint) {
    screen.items.push_back({static_cast<int>(item), ItemRole::choice, words(english), value,
                            words(hint != nullptr ? hint : hint_of_choice(world))});
}

void ScreenWriter::toggle(VisitItem item, const char* english, bool is_on, const char* hint) {
    screen.items.push_back({static_cast<int>(item), ItemRole::toggle, words(english),
                            words(is_on ? "on" : "off"),
                            words(hint != nullptr ? hint : change_hint)});
}

void ScreenWriter::setting(VisitItem item) {
    const ValueList list = values_of(visit, world, item);
    std::string value = list.names[std::min(list.chosen, list.names.size() - 1)];
    // "Volume, 4 of 7": nothing else here tells how many there are.
    if (item == VisitItem::volume || item == VisitItem::rate) {
        value = language.text("screen", "{0} of {1}",
                              {std::to_string(list.chosen + 1), std::to_string(list.names.size())});
    }
    screen.items.push_back({static_cast<int>(item), ItemRole::setting, name_of(item, language),
                            value, words(change_hint)});
}

void ScreenWriter::row(std::size_t number, const std::string& name, const std::string& value) {
    screen.items.push_back({static_cast<int>(VisitItem::entry) + static_cast<int>(number),
                            ItemRole::choice, name, value, words(hint_of_choice(world))});
}

void ScreenWriter::list(std::size_t count, const std::function<ListRow(std::size_t)>& row_at,
                        const char* hint) {
    constexpr std::size_t page = list_page;
    const auto wanted = static_cast<std::size_t>(std::max(visit.visitor.path.back().about, 0));
    const std::size_t first = count == 0 ? 0 : std::min(wanted, (count - 1) / page * page);
    const std::size_t end = std::min(first + page, count);
    if (count > page) {
        told(language.text(
            "page", "Page {0} of {1}",
            {std::to_string(first / page + 1), std::to_string((count + page - 1) / page)}));
    }
    for (std::size_t i = first; i < end; ++i) {
        const ListRow shown = row_at(i);
        row(shown.number, shown.name, shown.value);
        screen.items.back().hint = words(hint);
    }
    if (end < count) item(VisitItem::next_ten, "The next ten");
    if (first > 0) item(VisitItem::ten_before, "The ten before");
}

void ScreenWriter::list(const std::vector<ListRow>& rows, const char* hint) {
    list(
        rows.size(), [&rows](std::size_t place) { return rows[place]; }, hint);
}

void ScreenWriter::back(const char* english) {
    item(VisitItem::back, english);
}

void ScreenWriter::mind_the_only_item() {
    if (screen.items.size() != 1) return;
    std::string& hint = screen.items.front().hint;
    if (hint != words(hint_of_choice(world))) return;
    const bool is_back = screen.items.front().id == static_cast<int>(VisitItem::back);
    hint = words(is_back ? "Press Select to go back." : only_hint);
}

std::string told_trouble(TroubleKind kind, const std::string& sentence, const Language& language) {
    if (!sentence.empty()) return sentence;
    switch (kind) {
        case TroubleKind::device:
            return language.text("visit",
                                 "The handle has no force. It does not answer. You can still "
                                 "listen; please tell the staff.");
        case TroubleKind::sound:
            return language.text("speech", "There is no sound. Please call the staff.");
        case TroubleKind::camera:
            return language.text("visit",
                                 "The camera does not answer. Choose other pictures, or "
                                 "tell the staff.");
        case TroubleKind::stick:
            return language.text("visit",
                                 "The USB stick cannot be read. Pull it out and put it in again.");
    }
    return {};
}

const std::vector<GalleryTitle>& gallery_of(const ScreenWriter& sheet) {
    static const std::vector<GalleryTitle> none;
    if (sheet.world.gallery.empty()) return none;
    const std::size_t last = sheet.world.gallery.size() - 1;
    return sheet.world.gallery[std::min(sheet.visit.visitor.sound.language, last)];
}

std::vector<std::size_t> gallery_order(const ScreenWriter& sheet) {
    constexpr int ungraded = 6;
    const auto& gallery = gallery_of(sheet);
    std::vector<std::size_t> numbers(gallery.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
        return gallery[a].difficulty.value_or(ungraded) < gallery[b].difficulty.value_or(ungraded);
    });
    return numbers;
}

}  // namespace touchline
