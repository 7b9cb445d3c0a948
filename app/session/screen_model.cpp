#include "app/session/screen_model.h"

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

void add_sentence(std::string& text, const std::string& sentence) {
    if (sentence.empty()) return;
    if (!text.empty()) {
        const char end = text.back();
        text += end == '.' || end == '?' || end == '!' ? " " : ". ";
    }
    text += sentence;
}

std::string spoken_item(const SpokenScreen& screen, std::size_t item, const Language& language) {
    const ScreenItem& shown = screen.items.at(item);
    std::string sentence = shown.name;
    add(sentence, shown.value);
    add(sentence, words_of(shown.role, language));
    add(sentence, language.text("screen", "{0} of {1}",
                                {std::to_string(item + 1), std::to_string(screen.items.size())}));
    return sentence;
}

std::string spoken_screen(const SpokenScreen& screen, const Language& language) {
    std::string text = screen.title;
    add_sentence(text, screen.text);
    if (screen.focus) add_sentence(text, spoken_item(screen, *screen.focus, language));
    return text;
}

std::optional<FocusMove> move_focus(const SpokenScreen& screen, bool is_down) {
    const std::size_t count = screen.items.size();
    if (count == 0) return std::nullopt;
    if (!screen.focus) return FocusMove{is_down ? 0 : count - 1, false};
    const std::size_t at = *screen.focus;
    if (is_down) return FocusMove{(at + 1) % count, at + 1 == count};
    return FocusMove{(at + count - 1) % count, at == 0};
}

}  // namespace touchline
