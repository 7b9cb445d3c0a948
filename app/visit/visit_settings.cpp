// What a visitor can set for ears and eyes, and the page of a setting's values.
#include "app/visit/visit_menu.h"
#include "audio-cues/speech/speech_input.h"

#include <array>
#include <string>

namespace touchline {
namespace {

constexpr NamedValues<3> amounts{"visit", {"none of them", "short ones", "all of them"}};
constexpr NamedValues<4> sizes{"visit", {"ordinary", "large", "larger", "largest"}};
constexpr NamedValues<4> palettes{"visit",
                                  {"light letters on dark", "dark letters on light",
                                   "warm-coloured letters on dark", "low glare"}};

/// Without "of 7", which the place on the screen says already.
std::vector<std::string> stepped(const Language& language, std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t step = 1; step <= count; ++step)
        names.push_back(language.text("speech", "Step {0}", {std::to_string(step)}));
    return names;
}

std::vector<std::string> volume_names(const VisitWorld& world, const Language& language) {
    return stepped(language, world.rules.volume_steps);
}

std::vector<std::string> rate_names(const VisitWorld& /*world*/, const Language& language) {
    return stepped(language, speech_rates_per_minute.size());
}

std::vector<std::string> language_names(const VisitWorld& world, const Language& /*language*/) {
    std::vector<std::string> names;
    for (const Language& language : world.languages) names.push_back(language.name());
    return names;
}

void choose_language(VisitWork& work, std::size_t language) {
    work.visitor.sound.language = language;
    open_unasked(work);
}

/// Says first how speech comes back, for a visitor who hears nothing cannot ask.
void tell_speech(VisitWork& work) {
    if (work.visitor.sound.is_speech_on) return say_item(work);
    say(work, language_of(work).text("speech", "Speech is off. Press Help to turn it on again."));
}

const VisitItemRow& setting_of(const Visitor& visitor) {
    return setting_row(static_cast<VisitItem>(visitor.path.back().about));
}

void write_values_title(VisitSheet& sheet) {
    sheet.title(setting_of(sheet.visitor()).name);
}

void write_values(VisitSheet& sheet) {
    const auto& setting = std::get<VisitSetting>(setting_of(sheet.visitor()).does);
    const std::vector<std::string> names = setting.names(sheet.world, sheet.language);
    const std::size_t chosen = setting.value.chosen(sheet.visitor());
    for (std::size_t row = 0; row < names.size(); ++row)
        sheet.row(row, names[row], row == chosen ? sheet.words("chosen") : std::string());
}

void choose_value(VisitWork& work, std::size_t value, const std::string& /*name*/) {
    const auto& setting = std::get<VisitSetting>(setting_of(work.visitor).does);
    leave(work);
    setting.value.choose(work, value);
    // If work began, its result is said later.
    if (open_screen(work) != VisitScreen::opening) say_item(work);
}

using S = VisitScreen;
using I = VisitItem;

constexpr auto settings_screens = std::to_array<VisitScreenRow>({
    {.screen = S::settings, .title = "Settings", .back_item = "Back"},
    {.screen = S::values, .write = write_values_title},
});

constexpr auto settings_items = std::to_array<VisitItemRow>({
    {S::settings, I::volume, "Volume",
     VisitSetting{volume_names, kept_in<&Visitor::sound, &SoundWanted::volume>}},
    {S::settings, I::rate, "Speaking speed",
     VisitSetting{rate_names, kept_in<&Visitor::sound, &SoundWanted::rate>}},
    {S::settings, I::language, "Language",
     VisitSetting{language_names,
                  {kept_value<&Visitor::sound, &SoundWanted::language>, choose_language}}},
    {S::settings, I::sounds, "Sounds",
     VisitSetting{named<amounts>, kept_in<&Visitor::sound, &SoundWanted::amount>}},
    {S::settings, I::mono, "The same sound in both ears",
     VisitSwitch{kept_in<&Visitor::sound, &SoundWanted::is_mono>}},
    {S::settings, I::speech, "Speech",
     VisitSwitch{kept_in<&Visitor::sound, &SoundWanted::is_speech_on>, 1, tell_speech}},
    {S::settings, I::text_size, "Size of letters",
     VisitSetting{named<sizes>, kept_in<&Visitor::look, &LookWanted::text_size>}},
    {S::settings, I::palette, "Contrast",
     VisitSetting{named<palettes>, kept_in<&Visitor::look, &LookWanted::palette>}},
    {S::settings, I::screen, "Screen", VisitSwitch{kept_in<&Visitor::look, &LookWanted::is_off>, 0},
     "When it is off, nobody can read along."},
    {S::settings, I::reset, "Reset the settings", S::confirm},
    {S::settings, I::start_over, "Start over", S::confirm, "Ends your visit and begins a new one."},
    {S::values, I::entry, "", VisitList{write_values, choose_value}},
});

}  // namespace

VisitMenu settings_menu() {
    return {settings_screens, settings_items};
}

void take(VisitWork& work, const SettingsChanged& change) {
    const Settings& now = work.world.settings;
    if (now.mode != change.before.mode) work.visitor.feel.mode = now.mode;
    if (now.detail == change.before.detail) return;
    work.visitor.detail = now.detail;
    open_unasked(work);
}

}  // namespace touchline
