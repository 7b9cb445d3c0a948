#include "haptics/device/moteus/moteus_pair.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace touchline {
namespace {

// What the controller does when its watchdog expires. 0 switches the motor's bridge off.
constexpr std::string_view set_mode_text = "conf set servo.timeout_mode 0\n";
constexpr std::string_view read_mode_text = "conf get servo.timeout_mode\n";
constexpr int lets_go = 0;
constexpr double ask_again_s = 0.02;
constexpr int most_unknown_in_a_row = 3;
constexpr std::uint64_t questions = 127;

// 1 to 127, again and again.
std::uint8_t question_of(std::uint64_t number) {
    return static_cast<std::uint8_t>(1 + number % questions);
}

bool is_in(const MoteusStatus& status, MoteusMode mode) {
    return status.mode == static_cast<std::uint8_t>(mode);
}

int motor_number(std::size_t motor) {
    return static_cast<int>(motor) + 1;
}

std::optional<int> number_in(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} ? std::optional(number) : std::nullopt;
}

}  // namespace

void MoteusPair::Console::put(char byte) {
    if (byte == '\r' || byte == '\n') {
        is_line_whole = is_line_whole || size > 0;
    } else if (!is_line_whole && size < line.size()) {
        line[size++] = byte;
    }
}

void MoteusPair::set_up() {
    verdict_.set_up();
    is_let_go_ = false;
    is_heard_ = {};
    unknown_in_a_row_ = 0;
    go(verdict_.may_clear() ? Stage::stop : Stage::look);
}

void MoteusPair::let_go() {
    verdict_.let_go();
    is_let_go_ = true;
    go(Stage::stop);
}

void MoteusPair::go(Stage stage) {
    stage_ = stage;
    stage_s_ = asked_s_ = 0.0;
    is_asking_ = stage == Stage::set_mode || stage == Stage::read_mode;
    consoles_ = {};
}

PairNews MoteusPair::step(double elapsed_s) {
    stage_s_ += elapsed_s;
    asked_s_ += elapsed_s;
    verdict_.step(elapsed_s);
    while (const auto frame = link_->receive()) take(*frame);
    if (stage_ == Stage::set_mode || stage_ == Stage::read_mode) read_consoles();
    if (link_->is_gone()) verdict_.lose();
    return verdict_.news();
}

void MoteusPair::take(const CanFrame& frame) {
    const MoteusAnswer answer = moteus_answer(frame);
    const auto* const id = std::ranges::find(ids_, answer.from.controller);
    Exchange* const open = &open_[answer.from.question % most_open];
    const auto motor = static_cast<std::size_t>(id - ids_.begin());
    const bool is_known = id != ids_.end() && open->number != 0 &&
                          question_of(open->number) == answer.from.question &&
                          !open->is_answered[motor];
    if (!is_known || answer.kind == MoteusAnswer::Kind::wrong) {
        verdict_.hear_wrong();
        return;
    }
    if (answer.kind == MoteusAnswer::Kind::unknown_register) {
        verdict_.hear_wrong();
        if (stage_ == Stage::enable && ++unknown_in_a_row_ >= most_unknown_in_a_row)
            doubt(MotorTrouble::Kind::too_old, motor_number(motor));
        return;
    }
    if ((answer.kind == MoteusAnswer::Kind::console) != open->is_console()) {
        verdict_.hear_wrong();
        return;
    }
    is_heard_[motor] = true;
    open->is_answered[motor] = true;
    open->status[motor] = answer.status;
    open->is_text_empty = open->is_text_empty && answer.text_size == 0;
    for (std::size_t i = 0; i < answer.text_size; ++i) consoles_[motor].put(answer.text[i]);
    if (open->is_answered[0] && open->is_answered[1]) complete(*open);
}

void MoteusPair::complete(const Exchange& exchange) {
    if (exchange.number <= answered_) return;
    answered_ = exchange.number;
    if (exchange.is_console()) {
        if (stage_ == Stage::drain && exchange.is_text_empty) go(Stage::set_mode);
        return;
    }
    const auto has_no_torque = [](const MoteusStatus& said) {
        return is_in(said, MoteusMode::stopped) || is_in(said, MoteusMode::fault) ||
               (is_in(said, MoteusMode::position) && is_read_back(0.0, said.torque_Nm));
    };
    const bool are_stopped = std::ranges::all_of(
        exchange.status, [](const MoteusStatus& said) { return is_in(said, MoteusMode::stopped); });
    if (std::ranges::all_of(exchange.status, has_no_torque)) verdict_.hear_zero(exchange.number);
    if (are_stopped) verdict_.hear_let_go(exchange.number);
    if (stage_ == Stage::ready) return follow(exchange);
    if (stage_ == Stage::enable) return enable(exchange);
    // What was asked before tells nothing of a fault that came since.
    if (exchange.stage != stage_ || is_let_go_) return;
    if (!verdict_.may_clear() && tells_fault(exchange)) return;
    if (stage_ == Stage::look) return go(Stage::stop);
    if (stage_ == Stage::stop && are_stopped) go(Stage::drain);
}

// Tells the first of two faults.
bool MoteusPair::tells_fault(const Exchange& exchange) {
    for (std::size_t motor = 0; motor < 2; ++motor) {
        const MoteusStatus& said = exchange.status[motor];
        if (!is_in(said, MoteusMode::fault)) continue;
        verdict_.refuse({MotorTrouble::Kind::fault, motor_number(motor), said.fault});
        let_go();
        return true;
    }
    return false;
}

bool MoteusPair::is_followed(const Exchange& exchange, std::size_t motor) const {
    const MoteusStatus& said = exchange.status[motor];
    return is_in(said, MoteusMode::position) && is_read_back(watchdog_s, said.watchdog_s) &&
           is_read_back(exchange.torque_Nm[motor], said.torque_Nm);
}

void MoteusPair::follow(const Exchange& exchange) {
    if (tells_fault(exchange)) return;
    if (!is_followed(exchange, 0) || !is_followed(exchange, 1)) return go_astray();
    verdict_.hear_turns(exchange.number, {exchange.status[0].turns, exchange.status[1].turns});
}

// A controller measures its currents before it follows, and says so by its modes meanwhile.
void MoteusPair::enable(const Exchange& exchange) {
    if (tells_fault(exchange)) return;
    for (std::size_t motor = 0; motor < 2; ++motor) {
        const MoteusStatus& said = exchange.status[motor];
        if (!is_read_back(watchdog_s, said.watchdog_s))
            return doubt(MotorTrouble::Kind::watchdog_not_set, motor_number(motor));
        if (!is_in(said, MoteusMode::position)) return;
    }
    if (!is_followed(exchange, 0) || !is_followed(exchange, 1)) return;
    are_absolute_ = exchange.status[0].home != 0 && exchange.status[1].home != 0;
    verdict_.be_ready();
    go(Stage::ready);
    follow(exchange);
}

void MoteusPair::read_consoles() {
    if (asked_s_ > ask_again_s) {
        consoles_ = {};
        asked_s_ = 0.0;
        is_asking_ = true;
    }
    for (std::size_t motor = 0; motor < 2; ++motor) {
        const Console& console = consoles_[motor];
        if (!console.is_line_whole) return;
        const std::string_view line = console.text();
        if (line.starts_with("ERR")) return doubt(MotorTrouble::Kind::too_old, motor_number(motor));
        const auto mode = number_in(line);
        if (stage_ == Stage::read_mode && mode != lets_go)
            return doubt(MotorTrouble::Kind::not_let_go, motor_number(motor),
                         static_cast<std::uint32_t>(mode.value_or(-1)));
    }
    go(stage_ == Stage::set_mode ? Stage::read_mode : Stage::enable);
}

// The motors stay let go until somebody sets up anew.
void MoteusPair::go_astray() {
    verdict_.go_astray();
    let_go();
}

void MoteusPair::doubt(MotorTrouble::Kind kind, int motor, std::uint32_t code) {
    verdict_.doubt({kind, motor, code});
    let_go();
}

CanFrame MoteusPair::frame_for(MoteusAddress address, double torque_Nm) const {
    switch (stage_) {
        case Stage::drain:
            return moteus_console_poll(address);
        case Stage::set_mode:
            return is_asking_ ? moteus_console(address, set_mode_text)
                              : moteus_console_poll(address);
        case Stage::read_mode:
            return is_asking_ ? moteus_console(address, read_mode_text)
                              : moteus_console_poll(address);
        case Stage::look:  // a fault stays; only a stop clears it
        case Stage::enable:
        case Stage::ready:
            return moteus_torque(address, torque_Nm, watchdog_s);
        default:
            return moteus_stop(address);
    }
}

bool MoteusPair::tell(ShaftTorques torques) {
    const ShaftTorques told = stage_ == Stage::ready ? torques : ShaftTorques{};
    Exchange exchange;
    exchange.number = verdict_.tell(told != ShaftTorques{});
    exchange.stage = stage_;
    exchange.torque_Nm = {told.x, told.y};
    const std::uint8_t question = question_of(exchange.number);
    open_[question % most_open] = exchange;
    bool is_sent = true;
    for (std::size_t motor = 0; motor < 2; ++motor) {
        const CanFrame frame = frame_for({ids_[motor], question}, exchange.torque_Nm[motor]);
        is_sent = link_->send(frame) && is_sent;
    }
    is_asking_ = is_asking_ && !is_sent;
    return is_sent;
}

MotorTrouble MoteusPair::trouble() const {
    return verdict_.trouble(is_heard_[0] ? (is_heard_[1] ? 0 : 2) : 1);
}

}  // namespace touchline
