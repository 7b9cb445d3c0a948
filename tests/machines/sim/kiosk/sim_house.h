// The site of a simulation (simulation.h): its time, who acts when, and what they share.
// Threads: one.
#pragma once

#include "app/force/servo/running_servo.h"
#include "audio-cues/cues/cue_table.h"
#include "tests/machines/sim/kiosk/checkers/force.h"
#include "tests/machines/sim/kiosk/checkers/offers.h"
#include "tests/machines/sim/kiosk/checkers/safety.h"
#include "tests/machines/sim/kiosk/checkers/session.h"
#include "tests/machines/sim/kiosk/figures.h"
#include "tests/machines/sim/kiosk/kiosk_life.h"
#include "tests/machines/sim/kiosk/servo_life.h"
#include "tests/machines/sim/kiosk/sim_drawer.h"
#include "tests/machines/sim/kiosk/sim_printer.h"
#include "tests/machines/sim/kiosk/sim_reader.h"
#include "tests/machines/sim/kiosk/sim_visitor.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace touchline {

/// Board time is site time, except for spans without a visitor in which nothing moves or sounds:
/// those pass for the kiosk alone. This is the servo's clock: while the servo sleeps, all others
/// act when due.
class SimHouse final : public Clock {
  public:
    SimHouse(const Plan& plan, Sabotage sabotage);
    ~SimHouse();

    [[nodiscard]] SimFigures run();

    // The servo's clock.
    [[nodiscard]] std::int64_t now_ns() override { return std::llround(1e9 * time_.now_s); }

    void sleep_until(std::int64_t t_ns) override;

  private:
    /// Acts at regular intervals.
    struct Actor {
        void (SimHouse::*act)();
        double every_s;
        double due_s = 0.0;
    };

    /// A fault that lasts.
    struct Ongoing {
        SimFault fault;
        double until_s;
    };

    // Time (sim_house.cpp).
    void pass_ms();
    void pass(double span_s);
    void come_to(double board_s);
    void act_all();
    [[nodiscard]] bool may_skip() const;
    void skip();
    [[nodiscard]] double next_plan_s() const;

    [[nodiscard]] bool is_over() const {
        return now_s_ >= plan_.options.span_s || findings_.first().has_value();
    }

    // Processes (sim_house.cpp).
    void serve_one();
    void follow_end(bool is_good, bool has_run);
    void start_kiosk();
    void guard();
    void hear_servo();
    void frame();
    void sound();
    void servo_main();

    // People, and what goes wrong (sim_causes.cpp).
    void follow_plan();
    void begin(const PlannedCause& cause);
    [[nodiscard]] bool break_link(const PlannedCause& cause);
    [[nodiscard]] bool break_servo(const PlannedCause& cause);
    [[nodiscard]] bool break_kiosk(const PlannedCause& cause);
    [[nodiscard]] bool break_house(const PlannedCause& cause);
    void end(SimFault fault);
    void expect_zero(SimFault fault, double after_s = 0.0);
    void write_settings() const;
    void fill_disk(bool is_full);
    void spoil_settings(bool are_spoiled);
    [[nodiscard]] JobFate fate_of_job();
    void welcome();
    void accompany();
    void press(KeyRole role);
    void staff();

    // Checks (sim_looks.cpp).
    void look_at_tick();
    void look_at_frame();
    void look_at_offers(const FrameSight& sight);
    void forget_heard();
    [[nodiscard]] Force force_of(JointTorques torques) const;
    [[nodiscard]] std::size_t heard_ever() const;

    [[nodiscard]] bool is_kiosk_up() const { return kiosk_ && now_s_ >= kiosk_frozen_until_s_; }

    [[nodiscard]] bool is_servo_ready() const;
    [[nodiscard]] bool needs_staff() const;

    Plan plan_;
    Sabotage sabotage_;
    Dice dice_;  // for the scheduler and the staff

    VirtualTime time_;  // board time
    double now_s_ = 0.0;
    double skipped_s_ = 0.0;
    std::filesystem::path folder_;

    std::shared_ptr<VisitorHand> hand_;
    BoardEmulator board_;
    std::shared_ptr<Heard> heard_ = std::make_shared<Heard>();
    std::size_t heard_before_ = 0;  // forgotten ones
    std::unique_ptr<KioskLife> kiosk_;
    std::shared_ptr<const Connection> connection_;
    std::unique_ptr<ServoLife> servo_;
    std::optional<ServoWatch> watch_;
    Calibration stored_;
    bool is_kill_wanted_ = false;
    bool is_end_wanted_ = false;
    bool is_servo_frozen_ = false;
    bool is_kiosk_dying_ = false;
    double late_s_ = 0.0;
    bool is_machine_still_ = false;  // while it is late

    std::array<Actor, 5> actors_;
    double next_due_s_ = 0.0;
    std::size_t next_cause_ = 0;
    std::size_t next_visit_ = 0;
    std::optional<SimVisitor> visitor_;
    std::optional<SimDrawer> drawer_;
    std::optional<SimReader> reader_;
    bool has_read_ = false;  // in this frame
    std::size_t read_ = 0;   // of what was heard, looked for on the braille display
    SimPrinter printer_;
    std::vector<Ongoing> ongoing_;
    double kiosk_frozen_until_s_ = 0.0;
    double frames_off_until_s_ = 0.0;
    double link_broken_until_s_ = 0.0;  // board time
    std::optional<SimFault> armed_decoder_;
    double armed_decoder_s_ = 0.0;
    std::optional<double> staff_due_s_;
    int minutes_stepped_ = 0;
    double last_heard_s_ = 0.0;
    CueState cues_;

    SimFigures figures_;
    Findings findings_;
    StateHash hash_;
    double hashed_s_ = 0.0;
    std::uint64_t seen_ticks_ = 0;
    bool has_ticked_ = false;  // since this servo started
    bool is_led_ = false;
    double held_since_s_ = 0.0;
    JointTorques held_;
    std::uint32_t pattern_serial_ = 0;
    double pattern_until_s_ = 0.0;
    ForceLimitsChecker force_limits_;
    BoardTruthChecker board_truth_;
    GivenEnergyChecker given_energy_;
    ZeroDeadlineChecker zero_deadline_;
    NoHandChecker no_hand_;
    SafetyTransitionsChecker safety_transitions_;
    SessionRulesChecker session_rules_;
    AnswersChecker answers_;
    ReadinessChecker readiness_;
    QueuesChecker queues_;
    GrowingLineChecker growing_line_;
    PagesChecker pages_;
    LineChecker line_;
};

}  // namespace touchline
