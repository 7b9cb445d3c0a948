#include "app/visit/screen_model.h"

#include <algorithm>
#include <string>

namespace touchline {
namespace {

std::string words_of(ItemRole role, const Language& language) {
    switch (role) {
        case ItemRole::setting:
        case ItemRole::toggle:
            return language.text("screen", "setting");
        case ItemRole::text:
        case ItemRole::choice:
            break;
    }
    return {};
}

void add(std::string& sentence, const std::string& part) {
    if (part.empty()) return;
    if (!sentence.empty()) sentence += ", ";
    sentence += part;
}

}  // namespace

void set_focus(SpokenScreen& screen, std::size_t wanted) {
    screen.focus.reset();
    if (!screen.items.empty()) screen.focus = std::min(wanted, screen.items.size() - 1);
}

std::optional<std::size_t> place_of(const std::vector<ScreenItem>& items, int id) {
    const auto found = std::ranges::find(items, id, &ScreenItem::id);
    if (found == items.end()) return std::nullopt;
    return static_cast<std::size_t>(found - items.begin());
}

void add_sentence(std::string& text, const std::string& sentence) {
    if (sentence.empty()) return;
    if (!text.empty()) {
        const char end = text.back();
        text += end == '.' || end == '?' || end == '!' ? " " : ". ";
    }
    text += sentence;
}

std::string told_place_among(std::size_t number, std::size_t count, const Language& language) {
    if (count <= 1) return {};
    return language.text("screen", "{0} of {1}", {std::to_string(number), std::to_string(count)});
}

std::string told_place(const SpokenScreen& screen, std::size_t item, const Language& language) {
    const bool has_places = std::ranges::any_of(
        screen.items, [](const ScreenItem& each) { return each.place.has_value(); });
    if (has_places) return screen.items.at(item).place.value_or(std::string());
    return told_place_among(item + 1, screen.items.size(), language);
}

std::string spoken_item(const SpokenScreen& screen, std::size_t item, const Language& language) {
    const ScreenItem& shown = screen.items.at(item);
    std::string sentence = shown.name;
    add(sentence, shown.value);
    add(sentence, words_of(shown.role, language));
    add(sentence, told_place(screen, item, language));
    return sentence;
}

std::string spoken_screen(const SpokenScreen& screen, const Language& language) {
    return told_screen(screen, language).words;
}

void add_sentence(SpokenText& text, const SpokenText& sentence) {
    add_sentence(text.words, sentence.words);
    const std::size_t begin = text.words.size() - sentence.words.size();
    for (const RecordedSpan& span : sentence.recorded)
        text.recorded.push_back({begin + span.begin, begin + span.end, span.recording});
}

SpokenText told_title(const SpokenScreen& screen) {
    return {screen.title, screen.title_recording};
}

SpokenText told_text(const SpokenScreen& screen) {
    SpokenText text(screen.text);
    text.recorded = screen.text_recorded;
    return text;
}

SpokenText told_item(const SpokenScreen& screen, std::size_t item, const Language& language) {
    SpokenText text(spoken_item(screen, item, language));
    const ScreenItem& shown = screen.items.at(item);
    if (shown.recording) text.recorded.push_back({0, shown.name.size(), shown.recording});
    return text;
}

SpokenText told_screen(const SpokenScreen& screen, const Language& language) {
    SpokenText text = told_title(screen);
    add_sentence(text, told_text(screen));
    if (screen.focus) add_sentence(text, told_item(screen, *screen.focus, language));
    return text;
}

std::vector<KeyRole> acting_keys(const SpokenScreen& screen) {
    std::vector<KeyRole> keys;
    if (screen.takes_any_key) return keys;
    if (screen.items.size() > 1 || screen.is_turning) keys = {KeyRole::up, KeyRole::down};
    keys.push_back(KeyRole::back);
    keys.push_back(KeyRole::repeat);
    if (screen.focus) keys.push_back(KeyRole::select);
    keys.push_back(KeyRole::help);
    return keys;
}

std::optional<FocusMove> move_focus(const SpokenScreen& screen, bool is_down) {
    const std::size_t count = screen.items.size();
    if (count == 0) return std::nullopt;
    if (!screen.focus) return FocusMove{is_down ? 0 : count - 1, false};
    const std::size_t at = *screen.focus;
    if (is_down) return FocusMove{(at + 1) % count, at + 1 == count};
    return FocusMove{(at + count - 1) % count, at == 0};
}

std::optional<std::size_t> jump_focus(const SpokenScreen& screen, bool is_down) {
    if (!screen.focus) return std::nullopt;
    constexpr std::size_t jump = items_on_screen - 1;
    const std::size_t at = *screen.focus;
    const std::size_t last = screen.items.size() - 1;
    const std::size_t to = is_down ? std::min(at + jump, last) : at - std::min(at, jump);
    return to == at ? std::nullopt : std::optional(to);
}

}  // namespace touchline
