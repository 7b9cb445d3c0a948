#include "haptics/device/drives/motor_pantograph.h"

#include "haptics/device/hand_reach.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double oldest_angles_s = 0.0045;  // four ticks without an answer
constexpr double longest_set_up_s = 0.8;    // controllers measure their currents before they start
constexpr int most_attempts = 3;
constexpr int jumps_that_count = 3;
constexpr double pause_s = 0.001;
constexpr int longest_zero_ms = 20;

}  // namespace

MotorPantograph::MotorPantograph(std::unique_ptr<MotorPair> pair, const DeviceProfile& profile,
                                 const JointDrives& drives)
    : JointDevice(profile.geometry), pair_(std::move(pair)), frame_(profile, drives) {}

MotorPantograph::~MotorPantograph() {
    if (report_.state != DriveState::closed) stop();
}

Result<void> MotorPantograph::open() {
    if (!pair_) return failure("the device was given back");
    angles_.reset();
    last_s_.reset();
    attempts_ = 0;
    jumps_in_a_row_ = 0;
    has_jumped_ = false;
    begin_set_up();
    while (report_.state == DriveState::setting_up) tick_at_rest();
    last_s_.reset();
    if (report_.state == DriveState::ready) return {};
    if (std::string line = words(); !line.empty()) return failure(std::move(line));
    return failure("the device was unplugged while it was set up: plug it in again");
}

std::string MotorPantograph::words() const {
    const bool is_none = !pair_ || report_.trouble.kind == MotorTrouble::Kind::none;
    return is_none ? std::string() : pair_->words_of(report_.trouble);
}

// On a clock of its own, since the next caller's may begin anywhere.
void MotorPantograph::tick_at_rest() {
    pair_->rest(pause_s);
    (void)read_angles(last_s_.value_or(0.0) + pause_s);
    (void)write_torques({});
}

// States do not matter any more; only what the controllers confirm does. Ages go on, for a driver
// that was at work may be read again.
bool MotorPantograph::wait_for(bool PairNews::*confirmed, int longest_ms) {
    is_held_zero_ = false;
    for (int i = 0; i < longest_ms; ++i) {
        (void)pair_->tell({});
        pair_->rest(pause_s);
        const PairNews news = pair_->step(pause_s);
        if (news.state == PairState::gone) return false;
        is_held_zero_ = news.is_held_zero;
        if (last_s_) *last_s_ += pause_s;
        angles_age_s_ += pause_s;
        answer_age_s_ += pause_s;
        if (report_.state == DriveState::ready && news.turns) take(*news.turns, news.late_s);
        if (news.*confirmed) return true;
    }
    return false;
}

bool MotorPantograph::end_in_zero() {
    if (!pair_ || report_.state == DriveState::closed) return false;
    if (report_.state == DriveState::ready && wait_for(&PairNews::is_held_zero, longest_zero_ms))
        return true;
    pair_->let_go();
    return wait_for(&PairNews::is_let_go, longest_end_ms);
}

bool MotorPantograph::stop(int longest_ms) {
    if (!pair_) return false;
    pair_->let_go();
    const bool is_let_go = wait_for(&PairNews::is_let_go, longest_ms);
    pair_.reset();
    report_.state = is_let_go ? DriveState::closed : DriveState::lost;
    return is_let_go;
}

std::optional<JointAngles> MotorPantograph::read_angles(double now_s) {
    const double elapsed_s = last_s_ && now_s > *last_s_ ? now_s - *last_s_ : 0.0;
    if (std::isfinite(now_s)) last_s_ = now_s;
    if (!pair_ || report_.state == DriveState::closed) return std::nullopt;
    freshness_.is_new = false;
    angles_age_s_ += elapsed_s;
    answer_age_s_ += elapsed_s;
    set_up_age_s_ += elapsed_s;
    follow(pair_->step(elapsed_s));
    judge_age();
    const bool is_good = report_.state == DriveState::ready && jumps_in_a_row_ == 0 && angles_ &&
                         angles_age_s_ < oldest_angles_s;
    return is_good ? angles_ : std::nullopt;
}

bool MotorPantograph::write_torques(JointTorques torques) {
    if (!is_finite(torques)) report_.was_torque_not_finite = true;
    if (!pair_ || report_.state == DriveState::closed) return false;
    const bool is_passed_on = report_.state == DriveState::ready && jumps_in_a_row_ == 0;
    const ShaftTorques told = is_passed_on ? frame_.shaft_torques(torques) : ShaftTorques{};
    const bool is_zero = frame_.shaft_torques(torques) == ShaftTorques{};
    const bool is_held = is_held_zero_;
    if (told != ShaftTorques{}) is_held_zero_ = false;
    const bool is_sent = pair_->tell(told);
    return is_zero ? is_held : is_passed_on && is_sent;
}

void MotorPantograph::accept_position() {
    report_.is_position_doubtful = false;
    jumps_in_a_row_ = 0;
    has_jumped_ = false;
    angles_.reset();
    if (report_.state == DriveState::jumped) report_.state = DriveState::ready;
}

// A leap is not forgotten: by the end, the angles before it are so old that a hand could have moved
// to any place.
void MotorPantograph::begin_set_up() {
    set_up_age_s_ = 0.0;
    begin_arming();
}

void MotorPantograph::begin_arming() {
    ++report_.set_ups;
    report_.state = DriveState::setting_up;
    report_.trouble = {};
    is_held_zero_ = false;
    whole_.reset();
    pair_->set_up();
}

void MotorPantograph::follow(const PairNews& news) {
    is_held_zero_ = news.is_held_zero;
    report_.wrong = news.wrong;
    if (report_.state == DriveState::lost || report_.state == DriveState::refused) return;
    if (news.state == PairState::gone) {
        report_.state = DriveState::lost;
    } else if (news.state == PairState::refused) {
        report_.state = DriveState::refused;
        report_.trouble = pair_->trouble();
    } else if (news.state == PairState::astray && report_.state == DriveState::setting_up) {
        begin_arming();  // on the time of the set-up, or one that never ends would never be told
    } else if (news.state == PairState::astray) {
        begin_set_up();
    } else if (news.state == PairState::ready && news.turns) {
        take(*news.turns, news.late_s);
    } else if (report_.state == DriveState::ready) {
        ++report_.late;
    }
}

// A set-up ends with the first turns.
void MotorPantograph::take(ShaftTurns turns, double late_s) {
    ++report_.replies;
    answer_age_s_ = 0.0;
    if (!whole_) whole_ = turns - frame_.nearest_the_middle(turns);
    judge_position(frame_.joint_angles(turns - *whole_), late_s);
    if (report_.state != DriveState::setting_up) return;
    attempts_ = 0;
    report_.state = has_jumped_ ? DriveState::jumped : DriveState::ready;
    if (!frame_.is_absolute() || !pair_->are_encoders_absolute())
        report_.is_position_doubtful = true;
}

void MotorPantograph::judge_position(JointAngles angles, double late_s) {
    if (has_jumped_) return;
    const double age_s = (jumps_in_a_row_ == 0 ? angles_age_s_ : jump_age_s_) + freshness_.late_s;
    if (!angles_ || can_a_hand_move(frame_.profile(), *angles_, angles, age_s)) {
        angles_ = angles;
        freshness_ = {true, late_s};
        angles_age_s_ = 0.0;
        jumps_in_a_row_ = 0;
        return;
    }
    ++report_.jumps;
    if (jumps_in_a_row_++ == 0) jump_age_s_ = angles_age_s_;
    if (jumps_in_a_row_ < jumps_that_count) return;
    has_jumped_ = true;
    if (report_.state == DriveState::ready) report_.state = DriveState::jumped;
    report_.is_position_doubtful = true;
}

void MotorPantograph::judge_age() {
    const bool is_at_work =
        report_.state == DriveState::ready || report_.state == DriveState::jumped;
    if (is_at_work && answer_age_s_ >= oldest_angles_s) begin_set_up();
    if (report_.state != DriveState::setting_up || !(set_up_age_s_ > longest_set_up_s)) return;
    if (++attempts_ < most_attempts) {
        begin_set_up();
        return;
    }
    report_.state = DriveState::lost;
    report_.trouble = pair_->trouble();
    if (report_.trouble.kind == MotorTrouble::Kind::none)
        report_.trouble.kind = MotorTrouble::Kind::silent;
    pair_->let_go();
}

}  // namespace touchline
