#include "haptics/device/board/pantograph_board.h"

#include "config/types/angle.h"
#include "haptics/device/hand_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double oldest_angles_s = 0.0045;  // four ticks without a reply
constexpr double lost_reply_s = 0.02;
constexpr double longest_send_s = 0.0015;  // seen at the second tick; a good one takes 0.2 ms
constexpr int most_untaken_in_a_row = 3;
constexpr double handle_speed_rad_per_s = 40.0;  // faster than fingers twirl a knob
constexpr double handle_step_rad = 0.01;         // more than two counts of any handle
constexpr int jumps_that_count = 3;
constexpr int most_packets_a_tick = 16;
constexpr double pause_s = 0.001;
constexpr int longest_end_ms = 20;

// Half a count of play to each side, so that a counter that steps back by one, or trembles on an
// edge, moves nothing.
PortAngles followed(PortAngles before, PortAngles said, PortAngles quantum) {
    const auto follow = [](double last, double now, double play) {
        return std::clamp(last, now - play, now + play);
    };
    return {follow(before.x, said.x, 0.5 * quantum.x), follow(before.y, said.y, 0.5 * quantum.y)};
}

}  // namespace

PantographBoard::PantographBoard(std::unique_ptr<BoardLink> link, const DeviceProfile& profile,
                                 const Calibration& calibration)
    : JointDevice(profile.geometry), link_(std::move(link)), frame_(profile, calibration) {}

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

bool PantographBoard::take_over(JointAngles last, double age_s) {
    if (!link_ || frame_.has_handle() || !is_finite(last) || !(age_s >= 0.0)) return false;
    raw_ = Said{frame_.reading_at(last), 0.0};
    raw_age_s_ = age_s;
    report_.state = BoardState::closed;
    note(link_->set_lines(true));
    start_resync(Rung::settle);
    run_resync();
    return report_.state == BoardState::ready && !report_.is_position_doubtful &&
           jumps_in_a_row_ == 0 && raw_age_s_ == 0.0;
}

bool PantographBoard::stop() {
    if (!link_) return false;
    if (report_.last_failure != LinkStatus::gone) {
        (void)end_in_zero();
        report_.state = BoardState::closed;
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

// Answers and states do not matter any more; only the bytes sent do.
bool PantographBoard::end_in_zero() {
    for (int i = 0; i < longest_end_ms && link_ && report_.last_failure != LinkStatus::gone; ++i) {
        judge_send();
        clear_stall();
        if (holds_zero_) return true;
        if (is_send_free() && send(zero_command())) owe_a_reply();
        link_->rest(pause_s);
        sending_.age_s += pause_s;
    }
    return holds_zero_;
}

std::optional<JointAngles> PantographBoard::read_angles(double now_s) {
    const double elapsed_s = last_s_ && now_s > *last_s_ ? now_s - *last_s_ : 0.0;
    if (std::isfinite(now_s)) last_s_ = now_s;
    if (report_.state == BoardState::closed || report_.state == BoardState::lost)
        return std::nullopt;
    raw_age_s_ += elapsed_s;
    freshness_.is_new = false;
    sending_.age_s += elapsed_s;
    clear_stall();
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
    return frame_.joint_angles(steady_);
}

std::optional<double> PantographBoard::handle_angle_rad() const {
    if (!frame_.has_handle() || !raw_ || report_.state != BoardState::ready) return std::nullopt;
    return radians(raw_->handle_deg);
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
    judge_send();
    if (report_.state == BoardState::resyncing) return is_zero && holds_zero_;
    const bool is_passed_on = report_.state == BoardState::ready || is_zero;
    // A send hangs for a moment; the torque before goes on for that long.
    if (!is_send_free()) return is_passed_on && !is_zero;
    if (!send(is_zero || !is_passed_on ? zero_command() : write_command(told, handle_Nm))) {
        start_resync(Rung::settle);
        return false;
    }
    owe_a_reply();
    return is_zero ? holds_zero_ : is_passed_on;
}

void PantographBoard::owe_a_reply() {
    ++owed_;
    asked_.ask(last_s_.value_or(0.0));
}

void PantographBoard::set_calibration(const Calibration& calibration) {
    Calibration kept = calibration;
    kept.has_all_counts = kept.has_all_counts || frame_.calibration().has_all_counts;
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
               frame_.with_all_counts().is_whole_counts(reply.angles, reply.handle_deg)) {
        ++arrivals.good;
        ++report_.replies;
        arrivals.newest = Said{reply.angles, reply.handle_deg};
    } else {
        ++arrivals.bad;
        ++report_.wrong_packets;
    }
}

void PantographBoard::judge_send() {
    if (sending_.size == 0) return;
    const Sent sent = link_->sent();
    if (sent.status == LinkStatus::under_way) {
        if (sending_.age_s > longest_send_s) link_->cancel_send();
        return;
    }
    const Sending ended = std::exchange(sending_, {});
    const bool is_from_before = std::exchange(is_old_send_open_, false);
    // A send cancelled after its last byte is as good as done.
    const bool may_be_whole =
        sent.status == LinkStatus::done || sent.status == LinkStatus::timed_out;
    if (may_be_whole && sent.bytes == ended.size) {
        holds_zero_ = holds_zero_ || ended.is_zero;
        untaken_in_a_row_ = 0;
        return;
    }
    const bool is_write = ended.size == write_size(frame_.has_handle());
    if (is_write) --owed_;
    note(sent.status);
    // The board knows nothing of it, and the next write takes its place.
    const bool is_untaken = is_write && sent.status == LinkStatus::timed_out && sent.bytes == 0;
    const bool is_in_step =
        report_.state == BoardState::ready || report_.state == BoardState::jumped;
    if (is_untaken && is_in_step && ++untaken_in_a_row_ < most_untaken_in_a_row) return;
    has_send_failed_ = true;
    untaken_in_a_row_ = 0;
    // The board waits for the rest, with the old torque on.
    const bool is_cut = is_write && sent.bytes > 0 && sent.bytes < ended.size;
    if (is_cut && send(completing_command(sent.bytes, frame_.has_handle())))
        sending_.is_rest = true;
    const bool is_rest_missing = ended.is_rest || (is_cut && !sending_.is_rest);
    if (report_.state == BoardState::resyncing && !is_from_before && !is_rest_missing) return;
    start_resync(is_rest_missing ? Rung::flush : Rung::settle);
}

void PantographBoard::clear_stall() {
    if (!is_stalled_) return;
    const LinkStatus status = link_->clear_stall();
    if (status == LinkStatus::under_way) return;
    is_stalled_ = false;
    if (status != LinkStatus::done) note(status);
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
        // The first odd count shows that this board does not count half.
        if (!frame_.is_whole_counts(raw.joints, raw.handle_deg)) frame_ = frame_.with_all_counts();
        steady_ = raw_ ? followed(steady_, raw.joints, frame_.quantum()) : raw.joints;
        raw_ = raw;
        raw_age_s_ = 0.0;
        freshness_ = {true, asked_.late_s(static_cast<std::uint64_t>(std::max(owed_, 0)))};
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
    const double age_s = (jumps_in_a_row_ == 0 ? raw_age_s_ : jump_age_s_) + freshness_.late_s;
    if (frame_.has_handle()) {
        const double turned_rad = radians(std::abs(raw.handle_deg - raw_->handle_deg));
        const double span_s = age_s + sampling_s;
        if (!(turned_rad <= handle_speed_rad_per_s * span_s + handle_step_rad)) return true;
    }
    return !can_a_hand_move(frame_.calibrated_profile(), frame_.joint_angles(raw_->joints),
                            frame_.joint_angles(raw.joints), age_s);
}

void PantographBoard::start_resync(Rung first) {
    if (report_.state == BoardState::lost) return;
    ++report_.resyncs;
    report_.state = BoardState::resyncing;
    has_send_failed_ = false;
    owed_age_s_ = 0.0;
    jumps_in_a_row_ = 0;
    heard_.reset();
    is_zero_due_ = first == Rung::settle;
    is_old_send_open_ = sending_.size != 0 && sending_.age_s > 0.0;
    resync_ = Resync(first, std::max(owed_, 0));
    owed_ = 0;
    step_resync({}, 0.0);
}

void PantographBoard::step_resync(const Arrivals& arrivals, double elapsed_s) {
    if (is_zero_due_ && is_send_free()) {
        is_zero_due_ = false;
        if (send(zero_command())) resync_.owe_one();
    }
    if (report_.state == BoardState::lost) return;
    const bool has_failed = std::exchange(has_send_failed_, false);
    const auto action =
        resync_.step({elapsed_s, arrivals.good, arrivals.bad + arrivals.unconfigured,
                      is_send_free(), has_failed});
    if (action != ResyncAction::none) is_zero_due_ = false;
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

// On a clock of its own, since the next caller's may begin anywhere.
void PantographBoard::run_resync() {
    last_s_ = 0.0;
    while (report_.state == BoardState::resyncing) {
        link_->rest(pause_s);
        (void)read_angles(*last_s_ + pause_s);
    }
    last_s_.reset();
}

Command PantographBoard::zero_command() const {
    return write_command({}, frame_.handle_torque_Nm(0.0));
}

bool PantographBoard::send(const Command& command) {
    const LinkStatus status = link_->send(command.bytes());
    if (status == LinkStatus::done) {
        const bool is_zero = std::ranges::equal(command.bytes(), zero_command().bytes());
        sending_ = {command.bytes().size(), is_zero};
        holds_zero_ = holds_zero_ && is_zero;
        return true;
    }
    if (status != LinkStatus::under_way) {
        has_send_failed_ = true;
        note(status);
    }
    return false;
}

void PantographBoard::note(LinkStatus status) {
    if (status == LinkStatus::done || status == LinkStatus::under_way) return;
    report_.last_failure = status;
    if (status == LinkStatus::gone) report_.state = BoardState::lost;
    if (status != LinkStatus::stalled) return;
    is_stalled_ = true;
    clear_stall();
}

ZeroedBoard zero_board(std::unique_ptr<BoardLink> link, const DeviceProfile& profile) {
    PantographBoard board(std::move(link), profile, {});
    if (!board.stop()) return ZeroedBoard::not_confirmed;
    return board.report().is_position_doubtful ? ZeroedBoard::unknown : ZeroedBoard::kept;
}

bool zero_torque(std::unique_ptr<BoardLink> link, const DeviceProfile& profile) {
    return zero_board(std::move(link), profile) != ZeroedBoard::not_confirmed;
}

}  // namespace touchline
