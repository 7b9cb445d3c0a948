#include "app/operator/operator_turn.h"
#include "config/settings/setting_rows.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

constexpr int hours_step_min = 15;

const SettingRow& row_at(std::size_t index) {
    return setting_rows()[index];
}

bool is_of_row(OperatorItem item) {
    return item == OperatorItem::setting || item == OperatorItem::hours_begin ||
           item == OperatorItem::hours_end || item == OperatorItem::hours_are_set;
}

std::vector<std::string> offered_languages(const Settings& settings) {
    return languages_in_text(settings.languages).value_or(std::vector<std::string>{});
}

Settings with_languages(Settings settings, const std::vector<std::string>& codes) {
    settings.languages.clear();
    for (const std::string& code : codes)
        settings.languages += (settings.languages.empty() ? "" : " ") + code;
    const bool is_first_offered =
        std::find(codes.begin(), codes.end(), settings.first_language) != codes.end();
    if (!is_first_offered) settings.first_language = codes.front();
    return settings;
}

/// Keeps the last language: a kiosk without one is mute.
Settings with_language_switched(const Settings& settings, const std::string& code) {
    auto codes = offered_languages(settings);
    const auto found = std::find(codes.begin(), codes.end(), code);
    if (found == codes.end())
        codes.push_back(code);
    else if (codes.size() > 1)
        codes.erase(found);
    return with_languages(settings, codes);
}

Settings with_next_language(Settings settings, bool is_up) {
    const auto codes = offered_languages(settings);
    const auto found = std::find(codes.begin(), codes.end(), settings.first_language);
    if (found == codes.end()) return settings;
    const auto count = static_cast<std::ptrdiff_t>(codes.size());
    const auto at =
        std::clamp<std::ptrdiff_t>(found - codes.begin() + (is_up ? 1 : -1), 0, count - 1);
    settings.first_language = codes[static_cast<std::size_t>(at)];
    return settings;
}

/// Turns around the clock; the end is 24:00 rather than 0:00.
Settings with_hours_turned(const Settings& settings, const ItemMeaning& meaning, bool is_up) {
    const SettingRow& row = row_at(meaning.index);
    auto hours = hours_in(std::get<std::string>(value_of(settings, row)));
    if (!hours) return settings;
    const bool is_begin = meaning.item == OperatorItem::hours_begin;
    int& minute = is_begin ? hours->begin_min : hours->end_min;
    do {
        minute += is_up ? hours_step_min : minutes_a_day - hours_step_min;
        minute %= minutes_a_day;
        if (!is_begin && minute == 0) minute = minutes_a_day;
    } while (hours->begin_min == hours->end_min);
    return with_value(settings, row, hours_text(*hours)).value_or(settings);
}

Settings with_quiet_switched(const Settings& settings, const SettingRow& row) {
    const bool is_set = !std::get<std::string>(value_of(settings, row)).empty();
    return with_value(settings, row, std::string(is_set ? "" : "18:00-22:00")).value_or(settings);
}

OutputProfile& output_at(SoundSettings& sound, std::size_t index) {
    return index == 0 ? sound.headset : sound.speaker;
}

/// Steps to the next value if it fits all others; else changes nothing.
SoundSettings with_sound_turned(const SoundSettings& sound, const ItemMeaning& meaning,
                                bool is_up) {
    SoundSettings changed = sound;
    OutputProfile& output = output_at(changed, meaning.index);
    const double sign = is_up ? 1.0 : -1.0;
    if (meaning.item == OperatorItem::volume)
        output.default_dB += sign * output.step_dB;
    else
        output.full_scale_dB += sign;
    return check(output) ? changed : sound;
}

bool is_of_sound(OperatorItem item) {
    return item == OperatorItem::volume || item == OperatorItem::loudness;
}

bool is_ceiling(const ItemMeaning& meaning) {
    return meaning.item == OperatorItem::setting &&
           row_at(meaning.index).field == SettingField(&Settings::force_ceiling_N);
}

ItemMeaning focused(const OperatorTurn& turn) {
    const auto items = operator_items(turn.step.state, turn.world);
    return turn.step.state.focus < items.size() ? meaning_of(items[turn.step.state.focus])
                                                : ItemMeaning{};
}

/// Turning it on asks first; turning it off does not.
bool lets_more_in(const Settings& before, const Settings& after) {
    return after.more_file_systems && !before.more_file_systems;
}

void switch_to(OperatorTurn& turn, const Settings& settings) {
    turn.state().settings = settings;
    if (lets_more_in(turn.world.settings, settings)) return turn.ask(Question::file_systems);
    turn.say_item();
    turn.order(WriteSettings{settings});
}

/// True if it was a setting that is switched at once.
bool switch_value(OperatorTurn& turn, const ItemMeaning& meaning) {
    const Settings& settings = turn.state().settings;
    switch (meaning.item) {
        case OperatorItem::setting: {
            const SettingRow& row = row_at(meaning.index);
            if (!std::holds_alternative<bool Settings::*>(row.field)) return false;
            switch_to(turn, stepped(settings, row, true));
            return true;
        }
        case OperatorItem::hours_are_set:
            switch_to(turn, with_quiet_switched(settings, row_at(meaning.index)));
            return true;
        case OperatorItem::language:
            switch_to(turn,
                      with_language_switched(settings, turn.world.languages[meaning.index].code));
            return true;
        case OperatorItem::profile: {
            Settings changed = settings;
            const bool is_none = meaning.index >= turn.world.profiles.size();
            changed.profile = is_none ? "" : turn.world.profiles[meaning.index].name;
            switch_to(turn, changed);
            return true;
        }
        default:
            return false;
    }
}

bool can_be_held(const ItemMeaning& meaning) {
    switch (meaning.item) {
        case OperatorItem::setting:
            return !std::holds_alternative<std::string Settings::*>(row_at(meaning.index).field);
        case OperatorItem::hours_begin:
        case OperatorItem::hours_end:
        case OperatorItem::first_language:
        case OperatorItem::volume:
        case OperatorItem::loudness:
            return true;
        default:
            return false;
    }
}

Settings turned_settings(const Settings& settings, const ItemMeaning& meaning, bool is_up) {
    if (meaning.item == OperatorItem::setting)
        return stepped(settings, row_at(meaning.index), is_up);
    if (meaning.item == OperatorItem::first_language) return with_next_language(settings, is_up);
    return with_hours_turned(settings, meaning, is_up);
}

void say_end(OperatorTurn& turn) {
    turn.say(turn.words("It goes no further."));
}

}  // namespace

bool select_value(OperatorTurn& turn, const ItemMeaning& meaning) {
    const bool is_bound =
        is_of_row(meaning.item) && is_set_by_profile(meaning.index, turn.state(), turn.world);
    if (is_bound) {
        turn.say(turn.words("The profile in use sets this. Choose another profile to change it."));
        return true;
    }
    if (switch_value(turn, meaning)) return true;
    if (!can_be_held(meaning)) return false;
    turn.state().is_held = true;
    turn.say(turn.words("Press Up for more, Down for less, Select to save it."));
    return true;
}

void turn_value(OperatorTurn& turn, const ItemMeaning& meaning, bool is_up) {
    Operator& state = turn.state();
    if (is_of_sound(meaning.item)) {
        const SoundSettings sound = with_sound_turned(state.sound, meaning, is_up);
        const bool is_same = sound == state.sound;
        state.sound = sound;
        return is_same ? say_end(turn) : turn.say_value();
    }
    const Settings settings = turned_settings(state.settings, meaning, is_up);
    if (!conflicts(settings).empty())
        return turn.say(turn.words("That does not go together with another setting."));
    if (settings == state.settings) return say_end(turn);
    state.settings = settings;
    const bool waits_for_yes =
        is_ceiling(meaning) && settings.force_ceiling_N > turn.world.settings.force_ceiling_N;
    if (!waits_for_yes) turn.order(SetSettings{settings});
    turn.say_value();
}

bool release_value(OperatorTurn& turn) {
    Operator& state = turn.state();
    if (!state.is_held) return true;
    const ItemMeaning meaning = focused(turn);
    state.is_held = false;
    if (is_ceiling(meaning) &&
        state.settings.force_ceiling_N > turn.world.settings.force_ceiling_N) {
        turn.ask(Question::ceiling);
        return false;
    }
    turn.say(turn.words("Saved."));  // why it could not be saved comes after it, and replaces it
    if (is_of_sound(meaning.item)) {
        turn.order(WriteSound{state.sound});
    } else {
        turn.order(WriteSettings{state.settings});
    }
    return true;
}

}  // namespace touchline
