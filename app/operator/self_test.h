// The kiosk's self-test: what each step does, what it asks, and its result.
// Threads: values and pure functions.
#pragma once

#include "app/visit/screen_model.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

enum class TestStep : std::uint8_t {
    device,
    motors,
    camera,
    sound_left,
    sound_right,
    keys,
    stick_port,
    disk
};

inline constexpr std::size_t test_step_count = 8;

enum class TestVerdict : std::uint8_t { untried, passed, failed };

struct TestStepRow {
    TestStep step;
    std::string_view name;
    std::string_view does;      // one or two sentences, said before the step begins
    std::string_view question;  // for a person to answer; empty: the kiosk decides by itself
    bool waits = false;         // until a person begins it
};

[[nodiscard]] const TestStepRow& row_of(TestStep step);

/// told: says what it does and waits for Select. running: the kiosk is at it. asked: waits for yes
/// or no.
enum class TestPhase : std::uint8_t { idle, told, running, asked };

struct SelfTest {
    std::array<TestVerdict, test_step_count> verdicts{};
    TestPhase phase = TestPhase::idle;
    TestStep step = TestStep::device;
    bool is_all = false;       // the next step follows by itself
    std::size_t focus = 0;     // told: begin, skip; asked: yes, no
    std::uint8_t pressed = 0;  // the roles pressed in the step `keys`, a bit each
    double since_s = 0.0;      // when the phase began

    friend bool operator==(const SelfTest&, const SelfTest&) = default;
};

struct SelfTestStep {
    SelfTest test;
    std::optional<TestStep> run;  // the step that the kiosk has to run now and answer
    bool stop = false;            // stop what runs
    std::string said;
};

[[nodiscard]] SelfTestStep begin_test(const SelfTest& test, TestStep step, bool is_all,
                                      double now_s, const Language& language);

/// Back stops. In the step `keys` every role counts, and a second Back stops.
[[nodiscard]] SelfTestStep press_test_key(const SelfTest& test, KeyRole role, double now_s,
                                          const Language& language);

/// The kiosk did `step`. `line`: what is worth telling; may be empty. Changes nothing for a step
/// that nobody waits for.
[[nodiscard]] SelfTestStep test_done(const SelfTest& test, TestStep step, bool has_passed,
                                     const std::string& line, double now_s,
                                     const Language& language);

/// A step without an answer for 60 s has failed.
[[nodiscard]] SelfTestStep wait_for_test(const SelfTest& test, double now_s,
                                         const Language& language);

/// The screen of the step under way.
[[nodiscard]] SpokenScreen test_screen(const SelfTest& test, const Language& language);

}  // namespace touchline
