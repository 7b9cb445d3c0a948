#include "app/operator/self_test.h"

#include "app/visit/keys/key_wizard.h"

namespace touchline {
namespace {

constexpr double patience_s = 60.0;
constexpr unsigned all_pressed = (1U << needed_role_count) - 1U;

constexpr std::array<TestStepRow, test_step_count> rows{{
    {TestStep::device, "Circuit board of the handle",
     "Checks whether the board of the handle answers.", "", false},
    {TestStep::motors, "Motors",
     "The motors push to both sides with at most 1 newton. Hold the handle lightly.",
     "Did the handle push to both sides?", true},
    {TestStep::camera, "Camera", "One photo is taken and not kept.", "", false},
    {TestStep::sound_left, "Sound on the left", "You will hear a sound from the left only.",
     "Did you hear it on the left only?", true},
    {TestStep::sound_right, "Sound on the right", "You will hear a sound from the right only.",
     "Did you hear it on the right only?", true},
    {TestStep::keys, "Keys", "Press each of the six keys once. Press Back twice to stop.", "",
     false},
    {TestStep::stick_port, "USB slot", "Put in a USB stick within a minute.", "", true},
    {TestStep::disk, "Disk", "A small file is written, read and removed.", "", false},
}};

std::string name_of_step(TestStep step, const Language& language) {
    return language.text("test", std::string(row_of(step).name));
}

std::string explanation(TestStep step, const Language& language) {
    return language.text("test", std::string(row_of(step).does));
}

std::string joined(const std::string& first, const std::string& second) {
    if (first.empty() || second.empty()) return first + second;
    return first + ' ' + second;
}

SelfTestStep running(SelfTest test, double now_s) {
    test.phase = TestPhase::running;
    test.since_s = now_s;
    test.pressed = 0;
    const bool is_ours = test.step == TestStep::keys;
    return {test, is_ours ? std::nullopt : std::optional(test.step), false, ""};
}

SelfTestStep stopped(SelfTest test, const Language& language) {
    const bool is_running = test.phase == TestPhase::running && test.step != TestStep::keys;
    test.phase = TestPhase::idle;
    test.is_all = false;
    return {test, std::nullopt, is_running, language.text("test", "Stopped.")};
}

SelfTestStep after(const SelfTest& test, const std::string& said, double now_s,
                   const Language& language) {
    const auto next = static_cast<std::size_t>(test.step) + 1;
    if (test.is_all && next < test_step_count) {
        SelfTestStep begun = begin_test(test, static_cast<TestStep>(next), true, now_s, language);
        begun.said = joined(said, begun.said);
        return begun;
    }
    SelfTest done = test;
    done.phase = TestPhase::idle;
    done.is_all = false;
    return {done, std::nullopt, false,
            test.is_all ? joined(said, language.text("test", "All steps are done.")) : said};
}

SelfTestStep judged(SelfTest test, bool has_passed, const std::string& line, double now_s,
                    const Language& language) {
    test.verdicts[static_cast<std::size_t>(test.step)] =
        has_passed ? TestVerdict::passed : TestVerdict::failed;
    // If a step runs alone and passes, its line of the list says so.
    if (has_passed && !test.is_all && line.empty()) return after(test, "", now_s, language);
    const std::string name = name_of_step(test.step, language);
    const std::string verdict = has_passed ? language.text("test", "{0} passed.", {name})
                                           : language.text("test", "{0} failed.", {name});
    return after(test, joined(verdict, line), now_s, language);
}

SelfTestStep chosen(const SelfTest& test, double now_s, const Language& language) {
    const bool is_first = test.focus == 0;
    if (test.phase == TestPhase::asked) return judged(test, is_first, "", now_s, language);
    return is_first ? running(test, now_s) : after(test, "", now_s, language);
}

SelfTestStep key_tried(SelfTest test, KeyRole role, double now_s, const Language& language) {
    if (static_cast<std::size_t>(role) >= needed_role_count) return {test, {}, false, ""};
    const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(role));
    if (role == KeyRole::back && (test.pressed & bit) != 0) return stopped(test, language);
    test.pressed = static_cast<std::uint8_t>(test.pressed | bit);
    test.since_s = now_s;
    const std::string said = role_in_words(role, language);
    if (test.pressed != all_pressed) return {test, std::nullopt, false, said};
    return judged(test, true, "", now_s, language);
}

std::string missing_keys(const SelfTest& test, const Language& language) {
    std::string names;
    for (std::size_t i = 0; i < needed_role_count; ++i)
        if ((test.pressed & (1U << i)) == 0)
            names += (names.empty() ? "" : ", ") + role_in_words(static_cast<KeyRole>(i), language);
    return language.text("test", "These were not pressed: {0}.", {names});
}

void add_choices(SpokenScreen& screen, const SelfTest& test, const std::string& first,
                 const std::string& second) {
    screen.items = {{0, ItemRole::choice, first, "", ""}, {1, ItemRole::choice, second, "", ""}};
    screen.focus = test.focus;
}

void add_keys(SpokenScreen& screen, const SelfTest& test, const Language& language) {
    for (std::size_t i = 0; i < needed_role_count; ++i) {
        const bool is_pressed = (test.pressed & (1U << i)) != 0;
        screen.items.push_back(
            {static_cast<int>(i), ItemRole::text, role_in_words(static_cast<KeyRole>(i), language),
             is_pressed ? language.text("test", "pressed") : language.text("test", "not yet"), ""});
    }
}

}  // namespace

const TestStepRow& row_of(TestStep step) {
    return rows[static_cast<std::size_t>(step)];
}

SelfTestStep begin_test(const SelfTest& test, TestStep step, bool is_all, double now_s,
                        const Language& language) {
    SelfTest begun = test;
    begun.step = step;
    begun.is_all = is_all;
    begun.focus = 0;
    begun.since_s = now_s;
    const std::string said =
        joined(name_of_step(step, language) + '.', explanation(step, language));
    if (row_of(step).waits) {
        begun.phase = TestPhase::told;
        return {begun, std::nullopt, false,
                joined(said, language.text("test", "Press Select to begin."))};
    }
    SelfTestStep run = running(begun, now_s);
    run.said = said;
    return run;
}

SelfTestStep press_test_key(const SelfTest& test, KeyRole role, double now_s,
                            const Language& language) {
    const bool is_key_test = test.phase == TestPhase::running && test.step == TestStep::keys;
    if (is_key_test) return key_tried(test, role, now_s, language);
    if (test.phase == TestPhase::idle) return {test, std::nullopt, false, ""};
    if (role == KeyRole::back) return stopped(test, language);
    const bool has_choice = test.phase != TestPhase::running;
    if (has_choice && role == KeyRole::select) return chosen(test, now_s, language);
    SelfTest next = test;
    if (has_choice && (role == KeyRole::up || role == KeyRole::down)) {
        next.focus = 1 - test.focus;
        return {next, std::nullopt, false,
                spoken_item(test_screen(next, language), next.focus, language)};
    }
    return {next, std::nullopt, false, spoken_screen(test_screen(next, language), language)};
}

SelfTestStep test_done(const SelfTest& test, TestStep step, bool has_passed,
                       const std::string& line, double now_s, const Language& language) {
    if (test.phase != TestPhase::running || test.step != step)
        return {test, std::nullopt, false, ""};
    const std::string_view question = row_of(step).question;
    if (!has_passed || question.empty()) return judged(test, has_passed, line, now_s, language);
    SelfTest asked = test;
    asked.phase = TestPhase::asked;
    asked.focus = 0;
    asked.since_s = now_s;
    return {asked, std::nullopt, false, spoken_screen(test_screen(asked, language), language)};
}

SelfTestStep wait_for_test(const SelfTest& test, double now_s, const Language& language) {
    const bool is_waiting = test.phase == TestPhase::running || test.phase == TestPhase::asked;
    if (!is_waiting || now_s - test.since_s < patience_s) return {test, std::nullopt, false, ""};
    const std::string why = test.step == TestStep::keys
                                ? missing_keys(test, language)
                                : language.text("test", "No answer came within a minute.");
    SelfTestStep over = judged(test, false, why, now_s, language);
    over.stop = test.phase == TestPhase::running && test.step != TestStep::keys;
    return over;
}

SpokenScreen test_screen(const SelfTest& test, const Language& language) {
    SpokenScreen screen;
    screen.title = name_of_step(test.step, language);
    screen.text = explanation(test.step, language);
    if (test.phase == TestPhase::told)
        add_choices(screen, test, language.text("test", "Begin"), language.text("test", "Skip"));
    if (test.phase == TestPhase::asked) {
        screen.text = language.text("test", std::string(row_of(test.step).question));
        add_choices(screen, test, language.text("test", "Yes"), language.text("test", "No"));
    }
    if (test.phase == TestPhase::running && test.step == TestStep::keys)
        add_keys(screen, test, language);
    return screen;
}

}  // namespace touchline
