// Tests every screen of the operator: walked in each language, left by few keys, set up from
// nothing by six keys, and with random keys.
#include "app/operator/operator_menu.h"
#include "app/operator/pin.h"
#include "app/operator/setting_words.h"
#include "config/settings/setting_rows.h"
#include "tests/app/operator/operator_rig.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <map>
#include <queue>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using R = KeyRole;
using P = OperatorPlace;

constexpr std::array six_roles{R::up, R::down, R::back, R::repeat, R::select, R::help};

std::vector<Language> all_languages() {
    std::vector<Language> languages;
    const auto codes = languages_in(TOUCHLINE_CATALOGUES);
    for (const std::string& code : codes.value())
        languages.push_back(Language::load(TOUCHLINE_CATALOGUES, code).value());
    return languages;
}

/// A world without disk: orders have no effect.
OperatorWorld still_world(const Language& language) {
    OperatorWorld world{language};
    world.now_s = 100.0;
    world.has_pin = true;
    world.settings.quiet_hours = "18:00-22:00";
    world.keys = default_keys();
    world.languages = {{"en", "English"}, {"de", "Deutsch"}};
    world.profiles = {{"child", {0, 1}}, {"expert", {}}};
    world.on_stick = {"Castles"};
    world.house_files = {"all kiosks"};
    world.house_lines = {"Profile school: new", "Pack Castles: new"};
    world.kiosk.live = {"0.5 N"};
    world.kiosk.kind = "2diy-gen2";
    return world;
}

/// Returns all that tells two states of the screens apart, except values; leaves out what belongs
/// to another screen.
auto key_of(const Operator& state) {
    const bool is_test = state.place == P::test_step;
    const bool is_wizard = state.place == P::key_wizard;
    const SelfTest test = is_test ? state.test : SelfTest{};
    const KeyWizard wizard = is_wizard ? state.wizard : KeyWizard{};
    const PinEntry pin = is_of_pin(state.place) ? state.pin : PinEntry{};
    return std::tuple(
        state.place, state.focus, state.is_held,
        state.place == P::question ? state.question : Question::ceiling,
        std::tuple(test.phase, test.step, test.focus, std::popcount(test.pressed), test.is_all),
        std::tuple(wizard.role, wizard.first.has_value()), std::tuple(pin.taken.size(), pin.digit));
}

using Key = decltype(key_of(Operator{}));

Operator at_home(const OperatorWorld& world) {
    Operator state;
    state.place = P::home;
    state.settings = world.settings;
    state.last_key_s = world.now_s;
    return state;
}

OperatorStep pressed(const Operator& state, R role, const OperatorWorld& world) {
    const PhysicalKey key = keys_of(world.keys, role).front();
    return step_operator(state, KeyStruck{key, role}, world);
}

/// The screens of what was looked at after this order.
std::vector<P> looked_at_after(const OperatorOrder& order) {
    if (std::holds_alternative<LookAtHouseFile>(order)) return {P::bundle, P::house_key};
    if (std::holds_alternative<LookAtWayBack>(order)) return {P::way_back};
    if (std::holds_alternative<ShowHouseKey>(order)) return {P::own_key};
    return {};
}

/// Returns what one key leads to, and what the kiosk's answer to an order then leads to.
std::vector<Operator> next_states(const Operator& state, R role, const OperatorWorld& world) {
    const OperatorStep step = pressed(state, role, world);
    std::vector<Operator> found{step.state};
    for (const OperatorOrder& order : step.orders)
        for (const P place : looked_at_after(order))
            found.push_back(step_operator(step.state, HouseLooked{place}, world).state);
    for (const OperatorOrder& order : step.orders)
        if (const auto* run = std::get_if<RunTest>(&order))
            for (const bool has_passed : {false, true})
                found.push_back(
                    step_operator(step.state, TestAnswered{run->step, has_passed, ""}, world)
                        .state);
    return found;
}

std::map<Key, Operator> all_states(const OperatorWorld& world) {
    std::map<Key, Operator> known;
    std::queue<Operator> open;
    const auto add = [&](const Operator& state) {
        const bool is_typed_far = state.pin.taken.size() > 4 || state.pin.digit.value_or(0) > 1;
        if (is_typed_far || state.wizard.learnt.bindings.size() > 2) return;
        if (known.emplace(key_of(state), state).second) open.push(state);
    };
    add(at_home(world));
    Operator asked = at_home(world);
    asked.place = P::pin;
    add(asked);
    while (!open.empty()) {
        const Operator state = open.front();
        open.pop();
        if (state.place == P::closed) continue;
        for (const R role : six_roles)
            for (const Operator& next : next_states(state, role, world)) add(next);
    }
    return known;
}

/// Returns the presses until `is_there` holds; nothing if that takes more than `most`.
template <class Condition>
std::optional<int> presses_until(const Operator& start, const OperatorWorld& world, int most,
                                 const Condition& is_there) {
    Operator by_back = start;
    for (int count = 0; count <= most; ++count) {
        if (is_there(by_back)) return count;
        by_back = pressed(by_back, R::back, world).state;
    }
    std::vector<Operator> now{start};
    for (int count = 0; count <= most; ++count) {
        std::vector<Operator> next;
        for (const Operator& state : now) {
            if (is_there(state)) return count;
            for (const R role : {R::back, R::select})
                next.push_back(pressed(state, role, world).state);
        }
        now = std::move(next);
    }
    return std::nullopt;
}

/// IN-5. The lock while the handle is cleaned and the wizard end by waiting, and say so.
TEST(OperatorWalk, EveryScreenIsReachedAndLeftByFourPressesAtMost) {
    const Language english;
    const OperatorWorld world = still_world(english);
    const auto states = all_states(world);
    std::set<P> places;
    int most = 0;
    for (const auto& [key, state] : states) {
        places.insert(state.place);
        const P place = state.place;
        if (place == P::closed || place == P::cleaning_lock || place == P::key_wizard) continue;
        const auto count = presses_until(
            state, world, 4, [place](const Operator& other) { return other.place != place; });
        ASSERT_TRUE(count) << row_of(place).title << " item " << state.focus;
        most = std::max(most, *count);
        if (is_of_pin(place)) continue;
        EXPECT_TRUE(presses_until(state, world, 4, [](const Operator& other) {
            return other.place == P::home;
        })) << row_of(place).title;
    }
    for (const PlaceRow& row : place_rows()) EXPECT_TRUE(places.contains(row.place)) << row.title;
    EXPECT_GT(states.size(), 200U);
    RecordProperty("states", static_cast<int>(states.size()));
    RecordProperty("steps", static_cast<int>(states.size() * six_roles.size()));
    EXPECT_GE(most, 1);
    for (const P place : {P::cleaning_lock, P::key_wizard}) {
        OperatorWorld later = still_world(english);
        Operator state = at_home(later);
        state.place = place;
        state.wizard = start_key_wizard(100.0);
        state.lock_until_s = 160.0;
        later.now_s = 161.0;
        EXPECT_NE(step_operator(state, MomentPassed{}, later).state.place, place);
    }
}

/// SP-3: whatever is drawn has words, and every key is answered, except while the handle is
/// cleaned.
TEST(OperatorWalk, EveryScreenSpeaksInEveryLanguage) {
    const auto languages = all_languages();
    ASSERT_GE(languages.size(), 4U);
    for (const Language& language : languages) {
        const OperatorWorld world = still_world(language);
        for (const auto& [key, state] : all_states(world)) {
            if (state.place == P::closed) continue;
            const SpokenScreen screen = operator_screen(state, world);
            EXPECT_FALSE(screen.title.empty());
            EXPECT_GE(spoken_screen(screen, language).size(), screen.title.size());
            std::set<int> ids;
            for (const ScreenItem& item : screen.items) {
                EXPECT_FALSE(item.name.empty()) << screen.title;
                EXPECT_TRUE(ids.insert(item.id).second) << screen.title << ' ' << item.name;
                const bool has_value =
                    item.role == ItemRole::setting || item.role == ItemRole::toggle;
                EXPECT_TRUE(!has_value || !item.value.empty()) << item.name;
            }
            if (state.place == P::cleaning_lock || language.code() != "en") continue;
            for (const R role : six_roles)
                EXPECT_FALSE(pressed(state, role, world).orders.empty())
                    << screen.title << ' ' << key_role_names[static_cast<std::size_t>(role)];
        }
    }
}

/// Tests any focus, except in a held value, a digit, a test and the wizard.
TEST(OperatorWalk, RepeatTellsAndNeverActs) {
    const Language english;
    const OperatorWorld world = still_world(english);
    int pressed_count = 0;
    for (const auto& [key, state] : all_states(world)) {
        const bool is_list = is_inside(state.place) && state.place != P::test_step &&
                             state.place != P::key_wizard && state.place != P::cleaning_lock;
        if (!is_list || state.is_held) continue;
        ++pressed_count;
        for (const OperatorOrder& order : pressed(state, R::repeat, world).orders)
            EXPECT_TRUE(std::holds_alternative<Say>(order))
                << operator_screen(state, world).title << ' ' << state.focus;
    }
    EXPECT_GT(pressed_count, 100);
}

TEST(OperatorWalk, EveryTextIsInTheCatalogue) {
    const PoFile catalogue =
        read_po(TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/touchline.pot");
    const auto expect = [&](const char* context, std::string_view text) {
        if (text.empty()) return;
        EXPECT_TRUE(catalogue.contains({context, std::string(text)})) << context << ": " << text;
    };
    std::set<std::string> units;
    for (const auto& [key, entry] : catalogue)
        if (key.first == "unit") units.insert(entry.plural);
    for (const SettingRow& row : setting_rows()) {
        expect("setting", row.name);
        expect("setting", row.help);
        for (const std::string_view choice : row.choices) expect("setting", choice);
        EXPECT_TRUE(row.unit.empty() || units.contains("{0} " + std::string(row.unit))) << row.unit;
    }
    for (const PlaceRow& row : place_rows()) {
        const bool has_own = row.place == P::key_wizard || row.place == P::test_step;
        if (!has_own) expect("operator", row.title);
        expect("operator", row.text);
    }
    for (const ActionRow& row : action_rows()) {
        expect("operator", row.name);
        expect("operator", row.hint);
    }
    for (std::size_t i = 0; i < question_count; ++i)
        expect("operator", row_of(static_cast<Question>(i)).text);
    for (const KindRow& row : kind_rows()) {
        expect("kind", row.name);
        expect("kind", row.hint);
    }
    for (std::size_t i = 0; i < test_step_count; ++i) {
        const TestStepRow& row = row_of(static_cast<TestStep>(i));
        for (const auto text : {row.name, row.does, row.question}) expect("test", text);
    }
    for (const char* name : {"child", "adult", "expert", "demo"}) expect("profile", name);
    for (const KeyBinding& binding : default_keys().bindings) {
        const std::string name = key_in_words(binding.key, Language());
        const bool is_printed = name.size() == 1 || name.front() == 'F';
        if (binding.key.source == KeySource::key && !is_printed) expect("keys", name);
    }
}

TEST(OperatorWalk, ValuesAreSaidInTheLanguage) {
    const Language german = Language::load(TOUCHLINE_CATALOGUES, "de").value();
    const auto value = [&](const Settings& settings, const char* table, const char* key) {
        return setting_value(settings, *find_setting(table, key), german);
    };
    Settings settings;
    settings.friction = 0.1;
    settings.viewing_distance_m = 1.0;
    EXPECT_EQ(value(settings, "feel", "friction"), "0,1");
    EXPECT_EQ(value(settings, "feel", "stiffness_N_per_m"), "500 Newton pro Meter");
    EXPECT_EQ(value(settings, "screen", "viewing_distance_m"), "ein Meter");
    EXPECT_EQ(value(settings, "feel", "mode"), "Rille");
    EXPECT_EQ(value(settings, "levels", "automatic"), "an");
    EXPECT_EQ(value(settings, "operator", "device"), "ohne");
    EXPECT_EQ(time_in_words(9 * 60 + 5, german), "9:05");
}

/// What an installer does on the first day, by the transcript and six keys alone, in any language.
class FreshInstall : public OperatorRig {
  public:
    using OperatorRig::OperatorRig;

    [[nodiscard]] std::string words(const char* context, const char* english) const {
        return language.text(context, english);
    }

    void go(std::initializer_list<const char*> titles) {
        for (const char* title : titles)
            ASSERT_TRUE(open({words("operator", title).c_str()})) << title;
    }

    void set(const char* name, int steps) {
        ASSERT_TRUE(open({words("setting", name).c_str()})) << name;
        for (int i = 0; i < std::abs(steps); ++i) press(steps > 0 ? R::up : R::down);
        press(R::select);
    }
};

TEST(OperatorRun, FromAFreshInstallBySixKeysInEveryLanguage) {
    for (const Language& language : all_languages()) {
        FreshInstall kiosk(language);
        kiosk.is_private = language.code() != "de";
        kiosk.enter();
        kiosk.enter_pin("2580");
        kiosk.enter_pin("2580");
        kiosk.press(R::back);
        kiosk.go({"Camera, keys and screen", "Keys", "Assign the keys"});
        for (std::uint32_t i = 0; i < key_role_count; ++i)
            for (int twice = 0; twice < 2; ++twice) kiosk.press_key({KeySource::joystick, 20 + i});
        kiosk.press({R::back, R::back});
        kiosk.go({"Sound, speech and languages", "Volume", "Headphones at the start"});
        kiosk.press({R::up, R::select, R::back, R::back});
        kiosk.go({"How it feels", "Lines and force"});
        kiosk.set("Firmness", -2);
        kiosk.press(R::back);
        kiosk.go({"Levels"});
        kiosk.set("Finest level", 2);
        kiosk.set("Coarsest level", -6);
        kiosk.press({R::back, R::back});
        kiosk.go({"Handle and tests", "Find the handle’s starting point", "Begin"});
        kiosk.press({R::back, R::back});
        kiosk.go({"Upkeep", "Backup of the settings", "Copy the settings"});
        kiosk.press({R::back, R::back, R::back});
        EXPECT_EQ(kiosk.state.place, P::closed) << language.code();
        const Settings settings = kiosk.world().settings;
        EXPECT_EQ(settings.stiffness_N_per_m, 400.0);
        EXPECT_EQ(settings.finest_level, 2.0);
        EXPECT_EQ(settings.coarsest_level, 10.0);
        EXPECT_EQ(kiosk.sound.headset.default_dB, 70.0);
        EXPECT_EQ(role_of(kiosk.keys, {KeySource::joystick, 24}), R::select);
        EXPECT_EQ(kiosk.count<FindHome>(), 1);
        EXPECT_TRUE(is_right_pin(kiosk.folder / "operator.pin", "2580").value());
        EXPECT_TRUE(std::filesystem::exists(kiosk.stick / "touchline-backup.txt"));
    }
}

TEST(FeltBounds, AreSaidInEveryLanguageAndNeverOfWhatIsNoNumber) {
    const SettingRow& row = *find_setting("feel", "stiffness_N_per_m");
    Settings settings;
    settings.stiffness_N_per_m = 650.0;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Language& language : all_languages()) {
        const std::string all = setting_value(settings, row, language);
        const std::string less = felt_value(settings, row, {{1.0, 510.0}, {}}, language);
        EXPECT_NE(less.find(all), std::string::npos) << less;
        EXPECT_NE(less.find("510"), std::string::npos) << less;
        EXPECT_EQ(less.find("possible on") != std::string::npos, language.code() == "en") << less;
        for (const StiffnessBound& bound : {StiffnessBound{}, StiffnessBound{1.0, 646.0},
                                            StiffnessBound{nan, 510.0}, StiffnessBound{1.0, nan}})
            EXPECT_EQ(felt_value(settings, row, {bound, {}}, language), all);
    }
}

OperatorEvent any_event(std::mt19937& random, const KeyTable& keys) {
    const auto choose = [&random](int count) {
        return std::uniform_int_distribution<int>(0, count - 1)(random);
    };
    const int kind = choose(40);
    if (kind == 0) return MomentPassed{};
    if (kind == 1) return PinChecked{choose(2) == 0};
    if (kind == 2) return TestAnswered{static_cast<TestStep>(choose(8)), choose(2) == 0, "Well."};
    if (kind == 3) return OrderAnswered{"Something came of it."};
    if (kind == 4)
        return KeyStruck{{KeySource::scancode, static_cast<std::uint32_t>(1 + choose(9))}, {}};
    constexpr std::array often{R::up,   R::down,   R::down,   R::down, R::repeat,
                               R::back, R::select, R::select, R::help, R::louder};
    const R role = often[static_cast<std::size_t>(choose(10))];
    return KeyStruck{keys_of(keys, role).front(), role};
}

void expect_sound(const OperatorRig& rig, double ceiling_before_N, bool was_asked) {
    const Settings settings = rig.world().settings;
    for (const SettingRow& row : setting_rows())
        ASSERT_TRUE(with_value({}, row, value_of(settings, row))) << row.key;
    ASSERT_TRUE(conflicts(settings).empty());
    ASSERT_FALSE(role_without_key(rig.keys));
    ASSERT_TRUE(check(rig.sound.headset) && check(rig.sound.speaker));
    ASSERT_TRUE(settings.force_ceiling_N <= ceiling_before_N || was_asked);
    if (rig.state.place == P::closed) return;
    const SpokenScreen screen = rig.screen();
    ASSERT_TRUE(!screen.focus || *screen.focus < screen.items.size());
}

/// Every hundred events the run begins on another screen, so that it reaches all.
void begin_on(OperatorRig& rig, P place) {
    const bool needs_more = place == P::test_step || place == P::cleaning_lock ||
                            place == P::new_pin_again || place == P::question;
    if (needs_more) return;
    rig.state.place = place;
    rig.state.focus = 0;
    rig.state.is_held = false;
    rig.state.pin = {};
    if (place == P::key_wizard) rig.state.wizard = start_key_wizard(rig.now_s);
}

/// Ten thousand events of any kind: each is answered, nothing is ever stuck, and no ceiling is
/// raised without a question.
TEST(OperatorRun, TenThousandRudeEvents) {
    OperatorRig rig;
    rig.in_memory = Settings{};
    rig.enter();
    rig.enter_pin("1234");
    rig.enter_pin("1234");
    std::mt19937 random(7);
    std::set<P> places;
    for (int i = 0; i < 10'000; ++i) {
        if (rig.state.place == P::closed || rig.state.place == P::pin) {
            rig.state.tries = {};
            if (rig.state.place == P::closed) rig.enter();
            rig.enter_pin("1234");
        }
        if (i % 100 == 0) begin_on(rig, place_rows()[static_cast<std::size_t>(i / 100) % 36].place);
        places.insert(rig.state.place);
        const double ceiling_N = rig.in_memory->force_ceiling_N;
        const P place = rig.state.place;
        const bool was_asked =
            place == P::question;  // ceiling, factory settings, or a restored backup
        const std::size_t orders = rig.orders.size();
        const OperatorEvent event = any_event(random, rig.keys);
        rig.now_s += 0.3;
        rig.take(event);
        expect_sound(rig, ceiling_N, was_asked);
        if (testing::Test::HasFatalFailure()) return;
        const auto* key = std::get_if<KeyStruck>(&event);
        const bool is_role = key != nullptr && key->role && *key->role < R::louder;
        const bool waits = place == P::cleaning_lock || rig.state.is_checking;
        if (is_role && !waits) {
            ASSERT_GT(rig.orders.size(), orders) << row_of(place).title;
        }
    }
    EXPECT_GT(places.size(), 30U) << "the run went nearly everywhere";
    rig.wait(1200.0);
    EXPECT_EQ(rig.state.place, P::closed);
}

}  // namespace
}  // namespace touchline
