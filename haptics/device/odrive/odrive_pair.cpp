#include "haptics/device/odrive/odrive_pair.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

constexpr double quiet_s = 0.02;  // outlasts every answer that is on its way
constexpr double short_quiet_s = 0.005;
constexpr double ask_state_again_s = 0.05;
constexpr double same = 1e-6;  // of numbers that the board tells with six decimals
constexpr int idle = 1, closed_loop = 8;
constexpr int torque_control = 1, as_told = 1;
constexpr double first_absolute_mode = 256.0;
constexpr double watchdog_expired = 2048.0;

// By the number of Asked.
constexpr std::array<std::string_view, 12> properties{"",
                                                      "controller.input_torque",
                                                      "error",
                                                      "current_state",
                                                      "config.watchdog_timeout",
                                                      "config.enable_watchdog",
                                                      "motor.config.torque_lim",
                                                      "controller.config.control_mode",
                                                      "controller.config.input_mode",
                                                      "encoder.is_ready",
                                                      "encoder.config.mode",
                                                      "motor.is_calibrated"};

// A whole number that comes back as it was told, and does so for the next thousand bursts alone.
std::uint32_t mark_of(std::uint64_t burst) {
    return static_cast<std::uint32_t>(1 + burst % 1000);
}

}  // namespace

void OdrivePair::set_up() {
    verdict_.set_up();
    clears_errors_ = true;
    go(Stage::quiet);
}

void OdrivePair::let_go() {
    verdict_.let_go();
    if (stage_ != Stage::let_go) go(Stage::let_go);
}

// What was asked before is answered into the void.
void OdrivePair::go(Stage stage) {
    const bool forgets = stage == Stage::quiet || stage == Stage::let_go;
    stage_ = stage;
    stage_s_ = 0.0;
    is_first_of_stage_ = true;
    if (!forgets) return;
    open_count_ = 0;
    deaf_s_ = stage == Stage::quiet ? quiet_s : short_quiet_s;
}

void OdrivePair::go_astray() {
    verdict_.hear_wrong();
    if (stage_ != Stage::let_go) verdict_.go_astray();
    go(Stage::let_go);
}

PairNews OdrivePair::step(double elapsed_s) {
    stage_s_ += elapsed_s;
    verdict_.step(elapsed_s);
    std::array<std::uint8_t, 512> bytes{};
    while (const std::size_t size = port_->read(bytes)) {
        std::span<const std::uint8_t> unread(bytes.data(), size);
        while (const auto line = lines_.next(unread))
            if (deaf_s_ <= 0.0) take(*line);
    }
    deaf_s_ = std::max(0.0, deaf_s_ - elapsed_s);
    if (stage_ == Stage::quiet && deaf_s_ <= 0.0)
        go(verdict_.may_clear() ? Stage::arm : Stage::look);
    if (port_->is_gone()) verdict_.lose();
    return verdict_.news();
}

void OdrivePair::take(std::string_view line) {
    const OdriveAnswer answer = odrive_answer(line);
    const bool is_refusal = answer.kind == OdriveAnswer::Kind::refused;
    if (is_refusal && stage_ == Stage::read_back)
        return doubt(MotorTrouble::Kind::too_old, asked_axis());
    if (open_count_ == 0 || answer.kind == OdriveAnswer::Kind::wrong) return go_astray();
    Burst& burst = open_[first_open_];
    Question& question = burst.questions[burst.answered];
    const bool is_place = answer.kind == OdriveAnswer::Kind::place;
    if (is_refusal || is_place != (question.asked == Asked::place)) return go_astray();
    question.answer = answer.value;
    if (++burst.answered < burst.count) return;
    const Burst whole = burst;
    first_open_ = (first_open_ + 1) % most_open;
    --open_count_;
    complete(whole);
}

std::size_t OdrivePair::asked_axis() const {
    const Burst& burst = open_[first_open_];
    return open_count_ == 0 ? 0 : burst.questions[burst.answered].axis;
}

void OdrivePair::complete(const Burst& burst) {
    if (burst.questions[burst.count - 1].answer != mark_of(burst.number)) return go_astray();
    const auto are_all = [&](Asked asked, double value) {
        int count = 0;
        for (std::size_t i = 0; i < burst.count; ++i) {
            const Question& q = burst.questions[i];
            count += q.asked == asked && std::abs(q.answer - value) < same ? 1 : 0;
        }
        return count == 2;
    };
    const bool are_idle = are_all(Asked::state, idle);
    if (are_all(Asked::held_torque, 0.0) || are_idle) verdict_.hear_zero(burst.number);
    if (are_idle) verdict_.hear_let_go(burst.number);
    if (burst.stage == Stage::arm) return look(burst);
    if (burst.stage != stage_) return;
    if (stage_ == Stage::read_back) return read_back(burst);
    if (stage_ == Stage::look) return look(burst);
    if (stage_ != Stage::close_loop && stage_ != Stage::ready) return;
    judge_axes(burst);
    if (stage_ == Stage::close_loop && are_all(Asked::state, closed_loop) &&
        are_all(Asked::error, 0.0)) {
        verdict_.be_ready();
        go(Stage::ready);
    }
    if (stage_ == Stage::ready && burst.questions[0].asked == Asked::place)
        verdict_.hear_turns(burst.number, {burst.questions[0].answer, burst.questions[1].answer});
}

void OdrivePair::read_back(const Burst& burst) {
    are_absolute_ = true;
    for (std::size_t i = 0; i < burst.count; ++i) {
        const Question& q = burst.questions[i];
        const auto is = [&](double value) { return std::abs(q.answer - value) < same; };
        if (q.asked == Asked::watchdog_time && !is(watchdog_s))
            return doubt(MotorTrouble::Kind::watchdog_not_set, q.axis);
        if (q.asked == Asked::watchdog_on && !is(1.0))
            return doubt(MotorTrouble::Kind::watchdog_not_set, q.axis);
        if (q.asked == Asked::most_torque && !(q.answer <= most_Nm_ + same))
            return doubt(MotorTrouble::Kind::too_old, q.axis);
        if (q.asked == Asked::control_mode && !is(torque_control))
            return doubt(MotorTrouble::Kind::other_control, q.axis);
        if (q.asked == Asked::input_mode && !is(as_told))
            return doubt(MotorTrouble::Kind::other_control, q.axis);
        if (q.asked == Asked::encoder_ready && !is(1.0))
            return refuse(MotorTrouble::Kind::no_encoder, q.axis);
        if (q.asked == Asked::motor_calibrated && !is(1.0))
            return refuse(MotorTrouble::Kind::not_calibrated, q.axis);
        if (q.asked == Asked::encoder_mode)
            are_absolute_ = are_absolute_ && q.answer >= first_absolute_mode;
    }
    go(Stage::close_loop);
}

// Arming clears errors, so one that came since the pair was ready must be told; and it clears
// nothing where there was nothing, lest it be an error that came since.
void OdrivePair::look(const Burst& burst) {
    bool has_error = false;
    for (std::size_t i = 0; i < burst.count; ++i) {
        const Question& q = burst.questions[i];
        if (q.asked != Asked::error || q.answer == 0.0) continue;
        has_error = true;
        if (q.answer != watchdog_expired && !verdict_.may_clear())
            return refuse(MotorTrouble::Kind::fault, q.axis, q.answer);
    }
    if (stage_ != Stage::look) return;
    clears_errors_ = has_error;
    go(Stage::arm);
}

// Tells the first of two faults.
void OdrivePair::judge_axes(const Burst& burst) {
    for (std::size_t i = 0; i < burst.count; ++i) {
        const Question& q = burst.questions[i];
        if (q.asked == Asked::error && q.answer == watchdog_expired) return go_astray();
        if (q.asked == Asked::error && q.answer != 0.0)
            return refuse(MotorTrouble::Kind::fault, q.axis, q.answer);
        if (stage_ == Stage::ready && q.asked == Asked::state && q.answer != closed_loop)
            return go_astray();
    }
}

void OdrivePair::doubt(MotorTrouble::Kind kind, std::size_t axis) {
    verdict_.doubt({kind, static_cast<int>(axis) + 1, 0});
    go(Stage::let_go);
}

void OdrivePair::refuse(MotorTrouble::Kind kind, std::size_t axis, double code) {
    verdict_.refuse(
        {kind, static_cast<int>(axis) + 1, static_cast<std::uint32_t>(std::clamp(code, 0.0, 1e9))});
    go(Stage::let_go);
}

// An empty line is answered too, which may only be where nobody listens.
void OdrivePair::put_release(OdriveText& text) const {
    if (is_first_of_stage_ && deaf_s_ > 0.0) text.end_line();
    for (const int axis : {0, 1}) {
        text.torque(axis, 0.0);
        text.set(axis, "requested_state", idle);
    }
}

// The watchdogs are fed before they are switched on, and errors are asked for right before they are
// cleared.
void OdrivePair::put_arming(OdriveText& text, Burst& burst) const {
    for (const int axis : {0, 1}) {
        text.set(axis, "config.watchdog_timeout", watchdog_s);
        text.feed(axis);
        text.set(axis, "config.enable_watchdog", 1);
        text.set(axis, "controller.config.control_mode", torque_control);
        text.set(axis, "controller.config.input_mode", as_told);
        text.set(axis, "motor.config.torque_lim", most_Nm_);
        text.torque(axis, 0.0);
    }
    text.set_mark(mark_of(burst.number));
    ask(text, burst, Asked::error);
    ask_mark(text, burst);
    if (clears_errors_) text.clear_errors();
}

void OdrivePair::ask(OdriveText& text, Burst& burst, Asked asked) {
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        if (asked == Asked::place)
            text.ask_place(static_cast<int>(axis));
        else
            text.ask(static_cast<int>(axis), properties[static_cast<std::size_t>(asked)]);
        burst.questions[burst.count++] = {asked, axis};
    }
}

void OdrivePair::ask_mark(OdriveText& text, Burst& burst) {
    text.ask_mark();
    burst.questions[burst.count++] = {Asked::mark, 0};
}

// Torques first: they must not wait for the board to answer.
void OdrivePair::put_stage(OdriveText& text, Burst& burst, ShaftTorques torques) {
    if (stage_ == Stage::arm) return put_arming(text, burst);
    if (stage_ < Stage::arm) {
        put_release(text);
    } else {
        text.torque(0, torques.x);
        text.torque(1, torques.y);
    }
    const bool is_state_due = is_first_of_stage_ || stage_s_ > ask_state_again_s;
    if (stage_ == Stage::close_loop && is_state_due) {
        text.set(0, "requested_state", closed_loop);
        text.set(1, "requested_state", closed_loop);
        stage_s_ = 0.0;
    }
    const bool is_waiting = stage_ == Stage::read_back && !is_first_of_stage_ && open_count_ > 0;
    if (deaf_s_ > 0.0 || open_count_ == most_open || is_waiting) return;
    text.set_mark(mark_of(burst.number));
    put_questions(text, burst, torques == ShaftTorques{});
    ask_mark(text, burst);
}

void OdrivePair::put_questions(OdriveText& text, Burst& burst, bool is_zero) {
    switch (stage_) {
        case Stage::read_back:
            for (const Asked asked : read_backs) ask(text, burst, asked);
            return;
        case Stage::look:
            ask(text, burst, Asked::error);
            return;
        case Stage::ready:
            ask(text, burst, Asked::place);
            if (is_zero && !verdict_.is_held_zero()) return ask(text, burst, Asked::held_torque);
            [[fallthrough]];
        case Stage::close_loop:  // the error first, for an axis that has one is idle at once
            ask(text, burst, Asked::error);
            ask(text, burst, Asked::state);
            return;
        default:
            ask(text, burst, Asked::state);
    }
}

bool OdrivePair::tell(ShaftTorques torques) {
    const ShaftTorques told = stage_ == Stage::ready ? torques : ShaftTorques{};
    OdriveText text;
    Burst burst;
    burst.number = verdict_.tell(told != ShaftTorques{});
    burst.stage = stage_;
    put_stage(text, burst, told);
    if (!port_->write(text.bytes())) return false;
    is_first_of_stage_ = false;
    if (burst.count > 0) open_[(first_open_ + open_count_++) % most_open] = burst;
    if (stage_ == Stage::arm) go(Stage::read_back);
    return true;
}

MotorTrouble OdrivePair::trouble() const {
    return verdict_.trouble(0);
}

}  // namespace touchline
