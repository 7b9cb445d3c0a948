#include "tests/machines/sim/board/board_emulator.h"

#include "haptics/device/board/board_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double plant_step_s = 1.25e-4;
constexpr double host_wait_s = 0.07;  // waits this long, once, for a host that does not read
constexpr std::uint32_t deadly_baud = 1200;

std::uint64_t seed_of(std::uint64_t seed, int power_up) {
    return seed + 1000003 * static_cast<std::uint64_t>(power_up);
}

// Counts four edges a cycle and steps back on the fourth: on average, half of them.
std::int64_t counted_with_steps_back(double counts) {
    const auto edge = static_cast<std::int64_t>(std::floor(2.0 * counts));
    const std::int64_t within = (edge % 4 + 4) % 4;
    return (edge - within) / 2 + within;
}

std::int64_t as_clockwise(std::int64_t count, Turn turn) {
    return turn == Turn::clockwise ? count : -count;
}

}  // namespace

BoardEmulator::BoardEmulator(const BoardTruth& truth, std::shared_ptr<const IntendedPath> path)
    : truth_(truth),
      firmware_(truth.type, seed_of(truth.seed, 0), truth.firmware),
      plant_(truth.profile, truth.hand, plant_step_s, std::move(path)),
      angles_(plant_.angles().value_or(truth.profile.home)) {}

void BoardEmulator::advance_to(double t_s) {
    while (is_plugged_ && !is_boot_loader_ && firmware_.next_pass_s() <= t_s) {
        const double pass_s = std::max(firmware_.next_pass_s(), now_s());
        plant_.advance(pass_s - now_s());
        plant_.skip_to(pass_s);
        if (auto packet = firmware_.pass(pass_s, port_counts())) leave(std::move(*packet));
        update_torques();
    }
    if (!(t_s > now_s())) return;
    plant_.advance(t_s - now_s());
    plant_.skip_to(t_s);
}

void BoardEmulator::host_sends(std::span<const std::uint8_t> bytes) {
    if (is_plugged_ && !is_boot_loader_) firmware_.take(bytes, now_s());
}

void BoardEmulator::host_listens(bool is_listening) {
    is_host_listening_ = is_listening;
    if (!is_listening || !in_endpoint_) return;
    on_the_way_.push_back({now_s(), std::move(*in_endpoint_)});
    in_endpoint_.reset();
    if (is_dropping_) on_the_way_.push_back({now_s(), {}});
    is_dropping_ = false;
}

void BoardEmulator::leave(PacketBytes packet) {
    if (truth_.type == BoardType::due && !are_lines_up_) return;
    if (is_host_listening_) {
        on_the_way_.push_back({now_s(), std::move(packet)});
    } else if (!in_endpoint_) {
        in_endpoint_ = std::move(packet);
    } else if (!is_dropping_) {
        is_dropping_ = true;
        firmware_.hold_until(now_s() + host_wait_s);
    }
}

std::optional<SentPacket> BoardEmulator::take_packet() {
    if (on_the_way_.empty()) return std::nullopt;
    SentPacket packet = std::move(on_the_way_.front());
    on_the_way_.pop_front();
    return packet;
}

void BoardEmulator::set_lines(bool dtr, bool rts) {
    are_lines_up_ = dtr || rts;
    if (baud_ != deadly_baud || dtr || !is_plugged_) return;
    is_boot_loader_ = true;
    firmware_ = Firmware(truth_.type, 0, truth_.firmware);
    update_torques();
    ++device_number_;
}

void BoardEmulator::unplug() {
    is_plugged_ = false;
    firmware_ = Firmware(truth_.type, seed_of(truth_.seed, ++power_ups_), truth_.firmware);
    on_the_way_.clear();
    in_endpoint_.reset();
    is_dropping_ = is_host_listening_ = are_lines_up_ = false;
    update_torques();
}

void BoardEmulator::plug() {
    is_plugged_ = true;
    baud_ = 115200;
    ++device_number_;
}

std::uint16_t BoardEmulator::product() const {
    if (truth_.type == BoardType::due) return is_boot_loader_ ? 0x6124 : 0x003e;
    return is_boot_loader_ ? 0x004d : 0x804d;
}

void BoardEmulator::switch_motors(bool have_power) {
    truth_.have_motors_power = have_power;
    update_torques();
}

void BoardEmulator::lose_counts(int joint, std::int64_t counts) {
    lost_counts_[static_cast<std::size_t>(joint - 1)] += counts;
}

bool BoardEmulator::is_joint_1_on(std::size_t port, const Plugs& plugs) const {
    return (truth_.profile.wiring.joint_1.port == static_cast<int>(port) + 1) != plugs.are_swapped;
}

Turn BoardEmulator::turn_of(bool is_joint_1, const Plugs& plugs) const {
    const BoardWiring& wiring = truth_.profile.wiring;
    const Turn turn = is_joint_1 ? wiring.joint_1.turn : wiring.joint_2.turn;
    const bool is_reversed = is_joint_1 ? plugs.is_1_reversed : plugs.is_2_reversed;
    const bool is_clockwise = (turn == Turn::clockwise) != is_reversed;
    return is_clockwise ? Turn::clockwise : Turn::counter_clockwise;
}

JointAngles BoardEmulator::true_quantum() const {
    Calibration unit;
    unit.has_all_counts = truth_.firmware.has_all_counts;
    return encoder_quantum(calibrated(truth_.profile, unit));
}

// Clockwise counts are the negative of counter-clockwise ones.
PortCounts BoardEmulator::port_counts() {
    angles_ = plant_.angles().value_or(angles_);
    const JointAngles quantum = true_quantum();
    PortCounts counts{};
    for (std::size_t port = 0; port < 2; ++port) {
        const bool is_1 = is_joint_1_on(port, truth_.encoders);
        const double turned = is_1 ? angles_.x * (1.0 + truth_.scale_error.x) / quantum.x
                                   : angles_.y * (1.0 + truth_.scale_error.y) / quantum.y;
        const std::int64_t counted = truth_.do_counts_step_back
                                         ? counted_with_steps_back(turned)
                                         : static_cast<std::int64_t>(std::floor(turned));
        const std::int64_t count = counted - lost_counts_[is_1 ? 0 : 1];
        counts[port] = as_clockwise(count, turn_of(is_1, truth_.encoders));
    }
    if (const auto& handle = plant_.handle()) {
        const TurningHandle& made = *truth_.profile.handle;
        const double turned = handle->angle_rad() / encoder_quantum_rad(made);
        counts[2] = as_clockwise(static_cast<std::int64_t>(std::floor(turned)), made.turn);
    }
    return counts;
}

double BoardEmulator::told_handle_torque_Nm() const {
    if (!truth_.profile.handle) return 0.0;
    const bool is_right =
        firmware_.motor_turns()[2] == static_cast<std::uint8_t>(truth_.profile.handle->turn);
    return firmware_.duty()[2] * truth_.firmware.torque_limit_Nm * (is_right ? 1.0 : -1.0);
}

void BoardEmulator::update_torques() {
    JointTorques torques;
    for (std::size_t port = 0; port < 2; ++port) {
        const bool is_1 = is_joint_1_on(port, truth_.motors);
        const bool is_right = firmware_.motor_turns()[port] ==
                              static_cast<std::uint8_t>(turn_of(is_1, truth_.motors));
        const double made = firmware_.duty()[port] * truth_.firmware.torque_limit_Nm;
        const double torque = made * (is_right ? 1.0 : -1.0);
        (is_1 ? torques.x : torques.y) = torque;
    }
    const double handle_Nm = told_handle_torque_Nm();
    if (changes_.empty() || changes_.back().torques != torques ||
        changes_.back().handle_Nm != handle_Nm) {
        changes_.push_back({now_s(), torques, handle_Nm});
    }
    const bool have_power = truth_.have_motors_power;
    plant_.turn_motors(have_power ? torques : JointTorques{}, have_power ? handle_Nm : 0.0);
}

}  // namespace touchline
