#include "tests/app/screen/sample_screens.h"

#include "config/settings/setting_rows.h"

#include <array>
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
    SpokenScreen screen{language.text("visit", "Language"), "", {}, 1, ScreenView::none};
    for (const Language& each : every_language()) screen.items.push_back(choice(each.name()));
    return screen;
}

SpokenScreen fault_screen(const Language& language) {
    return {language.text("fault", "The handle kept shaking."),
            language.text(
                "fault",
                "Hold it firmly and choose softer lines. If it does not stop, call the staff."),
            {choice(language.text("visit", "Tell me again")),
             choice(language.text("visit", "Firmness")), choice(language.text("visit", "Finish"))},
            0,
            ScreenView::none};
}

SpokenScreen settings_screen(const Language& language) {
    return {language.text("visit", "Settings"),
            "",
            {with_value(ItemRole::setting, language.text("visit", "Firmness"),
                        language.text("stiffness", "very soft")),
             with_value(ItemRole::setting, language.text("visit", "Kind of line"),
                        language.text("mode", "sticky line")),
             with_value(ItemRole::setting, language.text("visit", "Detail"),
                        language.text("detail", "silhouette")),
             with_value(ItemRole::toggle, language.text("visit", "Speech"),
                        language.text("visit", "off")),
             choice(language.text("visit", "Another picture"))},
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
    constexpr std::array keys{
        std::pair{"Up", "Goes to the previous item."},
        std::pair{"Down", "Goes to the next item."},
        std::pair{"Back", "Leaves a screen. Press it again to leave the help."},
        std::pair{"Repeat", "Repeats the last words. Press it twice for the whole screen."},
        std::pair{"Select", "Chooses the item."},
        std::pair{"Help", "Explains the keys. Press it again to call the staff."},
        std::pair{"Louder", "Raises the volume."},
        std::pair{"Softer", "Lowers the volume."}};
    SpokenScreen screen{language.text("visit", "Try the keys"), "", {}, 7, ScreenView::none};
    for (const auto& [name, use] : keys)
        screen.items.push_back(
            with_value(ItemRole::text, language.text("visit", name), language.text("visit", use)));
    return screen;
}

/// A screen without items whose text takes more than one page in large letters.
SpokenScreen text_screen(const Language& language) {
    SpokenScreen screen{language.text("fault", "The force is off."), "", {}, {}, ScreenView::none};
    for (const SettingRow& row : setting_rows())
        screen.text += language.text("setting", std::string(row.help)) + ' ';
    return screen;
}

SpokenScreen long_list(const Language& language) {
    constexpr int count = 500;
    SpokenScreen screen{language.counted("count", "{0} picture", "{0} pictures", count),
                        language.text("fault", "Hold it still. The force comes back by itself."),
                        {},
                        count - 3,
                        ScreenView::none};
    for (int i = 1; i <= count; ++i)
        screen.items.push_back(choice(
            language.text("page", "Page {0} of {1}", {std::to_string(i), std::to_string(count)})));
    return screen;
}

/// Long words, as in the names of files on a stick.
SpokenScreen long_words(const Language& language) {
    const std::string word =
        "Rindfleischetikettierungs\xC3\xBC"
        "berwachungsaufgaben\xC3\xBC"
        "bertragungsgesetz_2024-11-23_final_final.svg";
    return {
        word,
        word + word,
        {choice(word), with_value(ItemRole::setting, language.text("visit", "Kind of line"), word),
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
    constexpr int letters_each = 5;  // then two are added
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
