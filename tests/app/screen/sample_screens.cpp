#include "tests/app/screen/sample_screens.h"

#include "app/session/keys.h"

#include <stdexcept>
#include <utility>

namespace touchline {

namespace {

ScreenItem choice(std::string name) {
    ScreenItem item;
    item.name = std::move(name);
    return item;
}

ScreenItem with_value(ItemRole role, std::string name, std::string value) {
    ScreenItem item;
    item.role = role;
    item.name = std::move(name);
    item.value = std::move(value);
    return item;
}

SpokenScreen languages_screen(const Language& language) {
    SpokenScreen screen{language.text("key", "next language"), "", {}, 1, ScreenView::none};
    for (const Language& each : every_language()) screen.items.push_back(choice(each.name()));
    return screen;
}

SpokenScreen fault_screen(const Language& language) {
    return {language.text("fault", "The handle kept shaking."),
            language.text("fault", "Hold it firmly, choose softer outlines and press Space twice."),
            {choice(language.text("key", "say it again")),
             choice(language.text("key", "softer outlines")), choice(language.text("key", "quit"))},
            0,
            ScreenView::none};
}

SpokenScreen settings_screen(const Language& language) {
    return {language.text("panel", "Picture"),
            "",
            {with_value(ItemRole::setting, language.text("panel", "Stiffness"),
                        language.text("stiffness", "very soft")),
             with_value(ItemRole::setting, language.text("panel", "Mode"),
                        language.text("mode", "stay on line")),
             with_value(ItemRole::setting, language.text("panel", "Detail"),
                        language.text("detail", "silhouette")),
             with_value(ItemRole::toggle, language.text("panel", "Sound"),
                        language.text("force", "off")),
             choice(language.text("key", "next picture"))},
            1,
            ScreenView::picture};
}

SpokenScreen camera_screen(const Language& language) {
    SpokenScreen screen = settings_screen(language);
    screen.view = ScreenView::camera;
    screen.items.resize(2);
    screen.focus = 0;
    return screen;
}

SpokenScreen keys_screen(const Language& language) {
    SpokenScreen screen{language.text("panel", "Keys"), "", {}, 7, ScreenView::none};
    for (const KeyRow& row : key_table())
        screen.items.push_back(with_value(ItemRole::text,
                                          language.text("key name", std::string(row.name)),
                                          language.text("key", std::string(row.words))));
    return screen;
}

/// Nothing to choose, and more than one page in large letters.
SpokenScreen text_screen(const Language& language) {
    SpokenScreen screen{language.text("fault", "The force is off."), "", {}, {}, ScreenView::none};
    for (const KeyRow& row : key_table())
        screen.text += language.text("key", std::string(row.words)) + ". ";
    return screen;
}

SpokenScreen long_list(const Language& language) {
    constexpr int count = 500;
    SpokenScreen screen{language.counted("count", "{0} picture", "{0} pictures", count),
                        language.text("fault", "You can go on exploring without force."),
                        {},
                        count - 3,
                        ScreenView::none};
    for (int i = 1; i <= count; ++i)
        screen.items.push_back(choice(
            language.text("page", "Page {0} of {1}", {std::to_string(i), std::to_string(count)})));
    return screen;
}

/// As files of a stick are named.
SpokenScreen long_words(const Language& language) {
    const std::string word =
        "Rindfleischetikettierungs\xC3\xBC"
        "berwachungsaufgaben\xC3\xBC"
        "bertragungsgesetz_2024-11-23_final_final.svg";
    return {word,
            word + word,
            {choice(word), with_value(ItemRole::setting, language.text("panel", "Mode"), word),
             with_value(ItemRole::toggle, word + word + word, word)},
            2,
            ScreenView::picture};
}

}  // namespace

std::vector<Language> every_language() {
    const auto codes = languages_in(TOUCHLINE_CATALOGUES);
    if (!codes) throw std::runtime_error(codes.error().line);
    std::vector<Language> languages;
    for (const std::string& code : *codes) {
        auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        if (!language) throw std::runtime_error(language.error().line);
        languages.push_back(std::move(*language));
    }
    return languages;
}

std::vector<NamedScreen> sample_screens(const Language& language) {
    return {{"languages", languages_screen(language)}, {"fault", fault_screen(language)},
            {"settings", settings_screen(language)},   {"camera", camera_screen(language)},
            {"keys", keys_screen(language)},           {"text", text_screen(language)},
            {"long list", long_list(language)},        {"long words", long_words(language)}};
}

std::string stretched(const std::string& text) {
    constexpr int letters_each = 5;  // then two more
    std::string longer;
    int letters = 0;
    for (const char c : text) {
        longer += c;
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (is_letter && ++letters % letters_each == 0) longer += "\xC3\x8B\xC3\xB6";  // Ëö
    }
    return longer;
}

SpokenScreen stretched(SpokenScreen screen) {
    screen.title = stretched(screen.title);
    screen.text = stretched(screen.text);
    for (ScreenItem& item : screen.items) {
        item.name = stretched(item.name);
        item.value = stretched(item.value);
    }
    return screen;
}

}  // namespace touchline
