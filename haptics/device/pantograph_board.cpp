#include "haptics/device/pantograph_board.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchline {
namespace {

constexpr double oldest_angles_s = 0.0045;  // four ticks that went without a reply
constexpr double lost_reply_s = 0.02;
constexpr double slow_send_s = 0.005;
constexpr double tip_speed_m_per_s = 1.5;        // faster than any hand at the handle
constexpr double joint_speed_per_s = 60.0;       // where the tip moves little for a turn
constexpr double handle_speed_rad_per_s = 40.0;  // faster than fingers twirl a knob
constexpr double handle_step_rad = 0.01;         // more than two counts of any handle
constexpr double sampling_s = 0.001;  // how much later a board may have looked than it was asked
constexpr int jumps_that_count = 3;
constexpr int most_packets_a_tick = 16;
constexpr double rest_s = 0.001;
constexpr double longest_send_s = 0.02;
constexpr double radians_per_degree = std::numbers::pi / 180.0;

}  // namespace

PantographBoard::PantographBoard(std::unique_ptr<BoardLink> link, const DeviceProfile& profile,
                                 const Calibration& calibration)
    : link_(std::move(link)), frame_(profile, calibration) {}

PantographBoard::~PantographBoard() {
    if (report_.state != BoardState::closed) stop();
}

Result<void> PantographBoard::open() {
    if (!link_) return failure("the board was given back");
    raw_.reset();
    report_.state = BoardState::closed;
    note(link_->set_lines(true));
    start_resync(Rung::opening);
    run_resync();
    report_.is_position_doubtful = false;
    if (report_.state == BoardState::ready) return {};
    if (report_.last_failure == LinkStatus::gone) return failure("the board was unplugged");
    return failure(
        "the board does not answer as a pantograph's board does: check that it is the right one, "
        "unplug it and plug it in again");
}

Result<void> PantographBoard::open(const Calibration& calibration) {
    frame_ = BoardFrame(frame_.profile(), calibration);
    return open();
}

bool PantographBoard::stop() {
    if (!link_) return false;
    if (report_.last_failure != LinkStatus::gone) {
        report_.state = BoardState::closed;
        if (sending_bytes_ != 0) link_->wait(longest_send_s);
        judge_send();
        send(zero_command());
        note(link_->set_lines(true));
        start_resync(Rung::settle);
        run_resync();
    }
    const bool is_zero = report_.state == BoardState::ready;
    (void)link_->set_lines(false);
    link_.reset();
    report_.state = is_zero ? BoardState::closed : BoardState::lost;
    return is_zero;
}

std::optional<JointAngles> PantographBoard::read_angles(double now_s) {
    const double elapsed_s = last_s_ && now_s > *last_s_ ? now_s - *last_s_ : 0.0;
    if (std::isfinite(now_s)) last_s_ = now_s;
    if (report_.state == BoardState::closed || report_.state == BoardState::lost)
        return std::nullopt;
    raw_age_s_ += elapsed_s;
    send_age_s_ += elapsed_s;
    judge_send();
    const Arrivals arrivals = take_packets();
    if (report_.state == BoardState::resyncing) {
        step_resync(arrivals, elapsed_s);
        return std::nullopt;
    }
    if (report_.state != BoardState::lost) follow(arrivals);
    if (report_.state != BoardState::lost) judge_age(elapsed_s);
    const bool is_good = report_.state == BoardState::ready && jumps_in_a_row_ == 0 && raw_ &&
                         raw_age_s_ < oldest_angles_s;
    if (!is_good) return std::nullopt;
    return frame_.joint_angles(raw_->joints);
}

std::optional<double> PantographBoard::handle_angle_rad() const {
    if (!frame_.has_handle() || !raw_ || report_.state != BoardState::ready) return std::nullopt;
    return raw_->handle_deg * radians_per_degree;
}

void PantographBoard::turn_handle(double torque_Nm) {
    if (!std::isfinite(torque_Nm)) report_.was_torque_not_finite = true;
    handle_Nm_ = torque_Nm;
}

bool PantographBoard::write_torques(JointTorques torques) {
    if (!is_finite(torques)) report_.was_torque_not_finite = true;
    const PortTorques told = frame_.port_torques(torques);
    const auto handle_Nm = frame_.handle_torque_Nm(std::exchange(handle_Nm_, 0.0));
    const bool is_zero = told == PortTorques{} && handle_Nm.value_or(0.0) == 0.0;
    if (report_.state == BoardState::closed || report_.state == BoardState::lost) return false;
    if (report_.state == BoardState::resyncing) return is_zero;
    const bool is_passed_on = report_.state == BoardState::ready || is_zero;
    judge_send();
    if (report_.state == BoardState::resyncing) return is_zero;
    // A send that hangs for a moment: the torque before goes on for that long.
    if (sending_bytes_ != 0) return is_passed_on && send_age_s_ < slow_send_s;
    if (!send(is_passed_on ? write_command(told, handle_Nm) : zero_command())) {
        start_resync(Rung::settle);
        return false;
    }
    ++owed_;
    return is_passed_on;
}

void PantographBoard::set_calibration(const Calibration& calibration) {
    Calibration kept = calibration;
    kept.are_motors_swapped = frame_.calibration().are_motors_swapped;
    frame_ = BoardFrame(frame_.profile(), kept);
    report_.is_position_doubtful = false;
}

void PantographBoard::accept_position() {
    report_.is_position_doubtful = false;
    jumps_in_a_row_ = 0;
    raw_.reset();
    if (report_.state == BoardState::jumped) report_.state = BoardState::ready;
}

PantographBoard::Arrivals PantographBoard::take_packets() {
    Arrivals arrivals;
    for (int i = 0; i < most_packets_a_tick && report_.state != BoardState::lost; ++i) {
        const Received received = link_->receive();
        if (received.status == LinkStatus::under_way) break;
        sort(received, arrivals);
    }
    return arrivals;
}

void PantographBoard::sort(const Received& received, Arrivals& arrivals) {
    if (received.status != LinkStatus::done) {
        ++arrivals.bad;
        note(received.status);
        return;
    }
    const Reply reply = decode_reply(received.packet(), 0, frame_.has_handle());
    if (reply.kind == ReplyKind::empty) {
        ++report_.empty_packets;
    } else if (reply.kind == ReplyKind::unconfigured) {
        ++arrivals.unconfigured;
        ++report_.unconfigured;
    } else if (reply.kind == ReplyKind::angles &&
               frame_.is_whole_counts(reply.angles, reply.handle_deg)) {
        ++arrivals.good;
        ++report_.replies;
        arrivals.newest = Said{reply.angles, reply.handle_deg};
    } else {
        ++arrivals.bad;
        ++report_.wrong_packets;
    }
}

void PantographBoard::judge_send() {
    if (sending_bytes_ == 0) return;
    const Sent sent = link_->sent();
    if (sent.status == LinkStatus::under_way) return;
    const std::size_t wanted = std::exchange(sending_bytes_, 0);
    if (sent.status == LinkStatus::done && sent.bytes == wanted) return;
    ++report_.failed_sends;
    has_send_failed_ = true;
    const bool is_write = wanted == write_size(frame_.has_handle());
    if (is_write) --owed_;
    note(sent.status);
    // The board waits for the rest, with the old torque on.
    if (is_write && sent.bytes > 0 && sent.bytes < wanted)
        send(completing_command(sent.bytes, frame_.has_handle()));
    const bool is_from_before = std::exchange(is_old_send_open_, false);
    if (report_.state != BoardState::resyncing || is_from_before) start_resync(Rung::settle);
}

void PantographBoard::follow(const Arrivals& arrivals) {
    owed_ -= arrivals.good + arrivals.bad;
    if (owed_ < 0) ++report_.wrong_packets;
    if (arrivals.unconfigured > 0) {
        start_resync(Rung::set_up_again);
    } else if (arrivals.bad > 0 || owed_ < 0) {
        start_resync(Rung::settle);
    } else if (arrivals.newest) {
        judge_position(*arrivals.newest);
    } else if (owed_ > 0) {
        ++report_.late;
    }
}

void PantographBoard::judge_age(double elapsed_s) {
    owed_age_s_ = owed_ > 0 ? owed_age_s_ + elapsed_s : 0.0;
    if (owed_age_s_ > lost_reply_s) {
        report_.lost_replies += static_cast<std::uint64_t>(owed_);
        owed_ = 0;
    }
    const bool is_silent =
        owed_ > 0 && raw_age_s_ >= oldest_angles_s && owed_age_s_ >= oldest_angles_s;
    if (is_silent && report_.state == BoardState::ready && jumps_in_a_row_ == 0)
        start_resync(Rung::settle);
}

void PantographBoard::judge_position(const Said& raw) {
    if (!is_jump(raw)) {
        raw_ = raw;
        raw_age_s_ = 0.0;
        jumps_in_a_row_ = 0;
        return;
    }
    ++report_.jumps;
    if (jumps_in_a_row_++ == 0) jump_age_s_ = raw_age_s_;
    if (jumps_in_a_row_ < jumps_that_count) return;
    report_.state = BoardState::jumped;
    report_.is_position_doubtful = true;
}

bool PantographBoard::is_jump(const Said& raw) const {
    if (!raw_) return false;
    const double age_s = (jumps_in_a_row_ == 0 ? raw_age_s_ : jump_age_s_) + sampling_s;
    const JointAngles quantum = encoder_quantum(frame_.profile());
    if (frame_.has_handle()) {
        const double turned_rad = radians_per_degree * std::abs(raw.handle_deg - raw_->handle_deg);
        if (!(turned_rad <= handle_speed_rad_per_s * age_s + handle_step_rad)) return true;
    }
    const JointAngles then = frame_.joint_angles(raw_->joints);
    const JointAngles now = frame_.joint_angles(raw.joints);
    const double turned = std::max(std::abs(now.x - then.x), std::abs(now.y - then.y));
    if (!(turned <= joint_speed_per_s * age_s + 2.0 * std::max(quantum.x, quantum.y))) return true;
    const auto from = forward(frame_.profile().geometry, then);
    const auto to = forward(frame_.profile().geometry, now);
    if (!from || !to) return false;
    const double count_m = singular_values(from->jacobian, quantum).largest;
    return !(norm(to->p_DH - from->p_DH) <= tip_speed_m_per_s * age_s + 2.0 * count_m);
}

void PantographBoard::start_resync(Rung first) {
    if (report_.state == BoardState::lost) return;
    ++report_.resyncs;
    report_.state = BoardState::resyncing;
    has_send_failed_ = false;
    owed_age_s_ = 0.0;
    jumps_in_a_row_ = 0;
    heard_.reset();
    if (first == Rung::settle && sending_bytes_ == 0 && send(zero_command())) ++owed_;
    is_old_send_open_ = sending_bytes_ != 0 && send_age_s_ > 0.0;
    resync_ = Resync(first, std::max(owed_, 0));
    owed_ = 0;
    step_resync({}, 0.0);
}

void PantographBoard::step_resync(const Arrivals& arrivals, double elapsed_s) {
    if (report_.state == BoardState::lost) return;
    const bool has_failed = std::exchange(has_send_failed_, false);
    const auto action =
        resync_.step({elapsed_s, arrivals.good, arrivals.bad + arrivals.unconfigured,
                      sending_bytes_ == 0, has_failed});
    if (action == ResyncAction::flush) send(flush_command());
    if (action == ResyncAction::write_zero) send(zero_command());
    if (action == ResyncAction::set_up) {
        send(set_up_command(raw_ ? frame_.set_up_at(raw_->joints, raw_->handle_deg)
                                 : frame_.set_up_at_home()));
        report_.is_position_doubtful = true;
    }
    if (resync_.state() == ResyncState::lost) report_.state = BoardState::lost;
    if (arrivals.newest) heard_ = arrivals.newest;
    if (resync_.state() != ResyncState::in_step) return;
    report_.state = BoardState::ready;
    if (heard_) judge_position(*heard_);
}

// On a clock of its own; the next caller's may begin anywhere.
void PantographBoard::run_resync() {
    last_s_ = 0.0;
    while (report_.state == BoardState::resyncing) {
        link_->rest(rest_s);
        (void)read_angles(*last_s_ + rest_s);
    }
    last_s_.reset();
}

Command PantographBoard::zero_command() const {
    return write_command({}, frame_.handle_torque_Nm(0.0));
}

bool PantographBoard::send(const Command& command) {
    const LinkStatus status = link_->send(command.bytes());
    if (status == LinkStatus::done) {
        sending_bytes_ = command.bytes().size();
        send_age_s_ = 0.0;
        return true;
    }
    if (status != LinkStatus::under_way) {
        ++report_.failed_sends;
        has_send_failed_ = true;
        note(status);
    }
    return false;
}

void PantographBoard::note(LinkStatus status) {
    if (status == LinkStatus::done || status == LinkStatus::under_way) return;
    report_.last_failure = status;
    if (status == LinkStatus::gone) report_.state = BoardState::lost;
    if (status == LinkStatus::stalled && link_->clear_stall() == LinkStatus::gone)
        report_.state = BoardState::lost;
}

bool zero_torque(std::unique_ptr<BoardLink> link, const DeviceProfile& profile) {
    return PantographBoard(std::move(link), profile, {}).stop();
}

}  // namespace touchline
