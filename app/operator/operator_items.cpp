// What is on each of the operator's screens.
#include "app/operator/operator_menu.h"
#include "app/operator/setting_words.h"
#include "config/settings/setting_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

constexpr int ids_an_item = 1000;
constexpr std::size_t shown_days = 31;

/// Items of one screen, in the order in which they are added.
struct List {
    const Operator& state;
    const OperatorWorld& world;
    std::vector<ScreenItem> items;

    [[nodiscard]] std::string words(std::string_view english) const {
        return world.language.text("operator", std::string(english));
    }

    void add(OperatorItem item, std::size_t index, ItemRole role, std::string name,
             std::string value = "", std::string hint = "") {
        items.push_back(
            {id_of({item, index}), role, std::move(name), std::move(value), std::move(hint)});
    }

    void add_places() {
        for (const PlaceRow& row : place_rows())
            if (row.is_listed && row.parent == state.place)
                add(OperatorItem::place, static_cast<std::size_t>(row.place), ItemRole::choice,
                    words(row.title));
    }

    void add_actions() {
        for (const ActionRow& row : action_rows())
            if (row.place == state.place)
                add(OperatorItem::action, static_cast<std::size_t>(row.action), ItemRole::choice,
                    words(row.name), "", row.hint.empty() ? "" : words(row.hint));
    }

    [[nodiscard]] std::string hint_of(std::size_t index, const SettingRow& row) const {
        return is_set_by_profile(index, state, world) ? words("The profile in use sets this.")
                                                      : setting_help(row, world.language);
    }

    void add_setting(std::size_t index, const SettingRow& row) {
        const bool is_switch = std::holds_alternative<bool Settings::*>(row.field);
        const bool is_text = std::holds_alternative<std::string Settings::*>(row.field);
        add(OperatorItem::setting, index,
            is_switch ? ItemRole::toggle
            : is_text ? ItemRole::text
                      : ItemRole::setting,
            setting_name(row, world.language),
            felt_value(state.settings, row, world.kiosk.bounds, world.language),
            hint_of(index, row));
    }

    void add_hours(std::size_t index, const SettingRow& row) {
        const std::string text = std::get<std::string>(value_of(state.settings, row));
        const std::string hint = hint_of(index, row);
        const std::string name = setting_name(row, world.language);
        const auto hours = hours_in(text);
        if (row.text == TextKind::quiet)
            add(OperatorItem::hours_are_set, index, ItemRole::toggle, name,
                world.language.text("setting", hours ? "on" : "off"), hint);
        if (!hours) return;
        add(OperatorItem::hours_begin, index, ItemRole::setting,
            world.language.text("operator", "{0}, from", {name}),
            time_in_words(hours->begin_min, world.language), hint);
        add(OperatorItem::hours_end, index, ItemRole::setting,
            world.language.text("operator", "{0}, until", {name}),
            time_in_words(hours->end_min, world.language), hint);
    }

    void add_languages(const SettingRow& row) {
        const auto offered =
            languages_in_text(state.settings.languages).value_or(std::vector<std::string>{});
        for (std::size_t i = 0; i < world.languages.size(); ++i) {
            const bool is_on =
                std::find(offered.begin(), offered.end(), world.languages[i].code) != offered.end();
            add(OperatorItem::language, i, ItemRole::toggle, world.languages[i].name,
                world.language.text("setting", is_on ? "on" : "off"),
                setting_help(row, world.language));
        }
    }

    void add_first_language(const SettingRow& row) {
        std::string name = state.settings.first_language;
        for (const OfferedLanguage& language : world.languages)
            if (language.code == name) name = language.name;
        add(OperatorItem::first_language, 0, ItemRole::setting, setting_name(row, world.language),
            name, setting_help(row, world.language));
    }

    void add_row(std::size_t index, const SettingRow& row) {
        if (row.text == TextKind::languages) return add_languages(row);
        if (row.text == TextKind::language) return add_first_language(row);
        if (row.text == TextKind::hours || row.text == TextKind::quiet)
            return add_hours(index, row);
        add_setting(index, row);
    }

    void add_settings() {
        const std::string_view table = row_of(state.place).table;
        const auto rows = setting_rows();
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].table == table) add_row(i, rows[i]);
    }

    void add_volumes() {
        const std::array outputs{&state.sound.headset, &state.sound.speaker};
        const std::array volumes{"Headphones at the start", "Speaker at the start"};
        const std::array loudness{"Headphones, loudest tone as measured",
                                  "Speaker, loudest tone as measured"};
        const auto decibels = [this](double level_dB) {
            return world.language.measured("unit", "{0} decibel", "{0} decibels",
                                           std::round(level_dB));
        };
        for (std::size_t i = 0; i < outputs.size(); ++i)
            add(OperatorItem::volume, i, ItemRole::setting, words(volumes[i]),
                decibels(outputs[i]->default_dB), words("Every visit begins with this volume."));
        for (std::size_t i = 0; i < outputs.size(); ++i)
            add(OperatorItem::loudness, i, ItemRole::setting, words(loudness[i]),
                decibels(outputs[i]->full_scale_dB),
                words("Set it with a sound meter; all volumes follow it."));
    }

    void add_profiles() {
        const auto is_used = [this](const std::string& name) {
            return state.settings.profile == name ? words("in use") : std::string();
        };
        for (std::size_t i = 0; i < world.profiles.size(); ++i)
            add(OperatorItem::profile, i, ItemRole::choice,
                world.language.text("profile", world.profiles[i].name),
                is_used(world.profiles[i].name));
        add(OperatorItem::profile, world.profiles.size(), ItemRole::choice, words("No profile"),
            is_used(""));
    }

    void add_kinds() {
        if (!world.kiosk.kind)
            return add(OperatorItem::fact, 0, ItemRole::text,
                       words("No handle with motors is plugged in."));
        const auto rows = kind_rows();
        for (std::size_t i = 0; i < rows.size(); ++i)
            add(OperatorItem::kind, i, ItemRole::choice,
                world.language.text("kind", std::string(rows[i].name)),
                *world.kiosk.kind == rows[i].profile ? words("in use") : "",
                world.language.text("kind", std::string(rows[i].hint)));
    }

    void add_test(TestStep step) {
        constexpr std::array verdicts{"not tested yet", "passed", "failed"};
        const auto index = static_cast<std::size_t>(step);
        const auto verdict = static_cast<std::size_t>(state.test.verdicts[index]);
        const TestStepRow& row = row_of(step);
        add(OperatorItem::test, index, ItemRole::choice,
            world.language.text("test", std::string(row.name)),
            world.language.text("test", verdicts[verdict]),
            world.language.text("test", std::string(row.does)));
    }

    void add_tests() {
        for (std::size_t i = 0; i < test_step_count; ++i) add_test(static_cast<TestStep>(i));
    }

    void add_status() {
        const auto lines = health_lines(world.kiosk.health, world.language);
        for (std::size_t i = 0; i < lines.size(); ++i)
            add(OperatorItem::fact, i, ItemRole::text, lines[i].name, lines[i].value);
        for (const TestStep step : {TestStep::sound_left, TestStep::sound_right, TestStep::motors})
            add_test(step);
    }

    void add_counters() {
        const Counts counted = total_of(world.days);
        const std::array facts{std::pair{"Visits", counted.visits},
                               std::pair{"Pictures of the gallery", counted.gallery_pictures},
                               std::pair{"Pictures of USB sticks", counted.stick_pictures},
                               std::pair{"Photos of the camera", counted.camera_pictures},
                               std::pair{"Minutes of visits", counted.minutes},
                               std::pair{"Faults", counted.faults}};
        for (std::size_t i = 0; i < facts.size(); ++i)
            add(OperatorItem::fact, i, ItemRole::text, words(facts[i].first),
                std::to_string(facts[i].second));
    }

    [[nodiscard]] std::string day_in_words(std::chrono::sys_days day) const {
        const int days_ago = static_cast<int>((world.kiosk.today - day).count());
        if (days_ago == 0) return words("today");
        if (days_ago == 1) return words("yesterday");
        return world.language.counted("operator", "{0} day ago", "{0} days ago", days_ago);
    }

    [[nodiscard]] std::string counts_in_words(const Counts& counts) const {
        const auto counted = [this](const char* context, const char* one, const char* many,
                                    std::uint64_t count) {
            return world.language.counted(
                context, one, many, static_cast<int>(std::min<std::uint64_t>(count, 1'000'000)));
        };
        const std::uint64_t pictures =
            counts.gallery_pictures + counts.stick_pictures + counts.camera_pictures;
        return counted("operator", "{0} visit", "{0} visits", counts.visits) + ", " +
               counted("count", "{0} picture", "{0} pictures", pictures) + ", " +
               counted("operator", "{0} minute", "{0} minutes", counts.minutes) + ", " +
               counted("operator", "{0} fault", "{0} faults", counts.faults);
    }

    /// The newest first. A day that the clock has not reached is in the table only.
    void add_days() {
        for (auto day = world.days.rbegin(); day != world.days.rend(); ++day)
            if (day->day <= world.kiosk.today && items.size() < shown_days)
                add(OperatorItem::fact, items.size(), ItemRole::text, day_in_words(day->day),
                    counts_in_words(day->counts));
    }

    void add_texts(OperatorItem item, ItemRole role, const std::vector<std::string>& texts) {
        for (std::size_t i = 0; i < texts.size(); ++i) add(item, i, role, texts[i]);
    }

    void add_pin() {
        const int count = static_cast<int>(state.pin.taken.size());
        add(OperatorItem::fact, 0, ItemRole::text, words("Entered so far"),
            world.language.counted("operator", "{0} digit", "{0} digits", count));
    }

    void add_answers() {
        add(OperatorItem::no, 0, ItemRole::choice, world.language.text("test", "No"));
        add(OperatorItem::yes, 0, ItemRole::choice, world.language.text("test", "Yes"));
    }

    void add_own() {
        switch (state.place) {
            case OperatorPlace::pin:
            case OperatorPlace::new_pin:
            case OperatorPlace::new_pin_again:
            case OperatorPlace::key_pin:
                return add_pin();
            case OperatorPlace::status:
                return add_status();
            case OperatorPlace::volume:
                return add_volumes();
            case OperatorPlace::profiles:
                return add_profiles();
            case OperatorPlace::kind:
                return add_kinds();
            case OperatorPlace::self_test:
                return add_tests();
            case OperatorPlace::live:
                return add_texts(OperatorItem::fact, ItemRole::text, world.kiosk.live);
            case OperatorPlace::library:
                return add_texts(OperatorItem::on_stick, ItemRole::choice, world.on_stick);
            case OperatorPlace::several:
                return add_texts(OperatorItem::house_file, ItemRole::choice, world.house_files);
            case OperatorPlace::bundle:
            case OperatorPlace::way_back:
            case OperatorPlace::house_key:
            case OperatorPlace::own_key:
                return add_texts(OperatorItem::fact, ItemRole::text, world.house_lines);
            case OperatorPlace::counters:
                return add_counters();
            case OperatorPlace::days:
                return add_days();
            case OperatorPlace::question:
                return add_answers();
            default:
                return;
        }
    }
};

const char* told_urgency(Urgency worst) {
    switch (worst) {
        case Urgency::trouble:
            return "Something does not work.";
        case Urgency::remark:
            return "Everything a visitor needs is working.";
        case Urgency::none:
            break;
    }
    return "Everything works.";
}

std::string own_text(const Operator& state, const OperatorWorld& world) {
    const auto words = [&](std::string_view english) {
        return english.empty() ? "" : world.language.text("operator", std::string(english));
    };
    std::string text = words(row_of(state.place).text);
    if (state.place == OperatorPlace::question) text = words(row_of(state.question).text);
    if (state.place == OperatorPlace::library && world.on_stick.empty())
        text = words(
            "Put in a USB stick with packs of pictures. A network file for Touchline can be on it "
            "too.");
    if (state.place == OperatorPlace::several && world.house_files.empty())
        add_sentence(text, words("Put in a USB stick with a bundle or a house key."));
    if (state.place == OperatorPlace::bundle && world.house_lines.empty())
        text = words("This kiosk is as the bundle says.");
    if (state.place == OperatorPlace::days)
        text =
            world.days.empty()
                ? words("Nothing was counted yet.")
                : world.language.text("operator", "At most {0} days are listed. The table has all.",
                                      {std::to_string(shown_days)});
    if (state.place == OperatorPlace::status) {
        const auto lines = health_lines(world.kiosk.health, world.language);
        text = words(told_urgency(lines.front().urgency)) + ' ' + text;
    }
    if (is_of_pin(state.place) && !world.kiosk.is_private)
        add_sentence(text, words("Each press clicks. Plug in headphones to hear the digits."));
    return text;
}

}  // namespace

ItemMeaning meaning_of(const ScreenItem& item) {
    return {static_cast<OperatorItem>(item.id / ids_an_item),
            static_cast<std::size_t>(item.id % ids_an_item)};
}

int id_of(const ItemMeaning& meaning) {
    return static_cast<int>(meaning.item) * ids_an_item + static_cast<int>(meaning.index);
}

std::vector<ScreenItem> operator_items(const Operator& state, const OperatorWorld& world) {
    List list{state, world, {}};
    if (state.place == OperatorPlace::self_test) list.add_actions();
    list.add_places();
    if (!row_of(state.place).table.empty()) list.add_settings();
    list.add_own();
    if (state.place != OperatorPlace::self_test) list.add_actions();
    return std::move(list.items);
}

bool is_set_by_profile(std::size_t row, const Operator& state, const OperatorWorld& world) {
    for (const OfferedProfile& profile : world.profiles)
        if (profile.name == state.settings.profile)
            return std::find(profile.rows.begin(), profile.rows.end(), row) != profile.rows.end();
    return false;
}

SpokenScreen operator_screen(const Operator& state, const OperatorWorld& world) {
    SpokenScreen screen;
    if (state.place == OperatorPlace::key_wizard)
        screen = wizard_screen(state.wizard, world.language);
    else if (state.place == OperatorPlace::test_step)
        screen = test_screen(state.test, world.language);
    else {
        screen.title = world.language.text("operator", std::string(row_of(state.place).title));
        screen.text = own_text(state, world);
        screen.items = operator_items(state, world);
        set_focus(screen, state.focus);
        screen.is_turning = state.is_held || is_of_pin(state.place);
    }
    add_sentence(screen.text, state.note);
    if (state.place == OperatorPlace::live) screen.view = ScreenView::picture;
    return screen;
}

}  // namespace touchline
