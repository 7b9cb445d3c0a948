#include "vision/camera/capture_sequence.h"

#include <cmath>

namespace touchline {

std::vector<CaptureAction> CaptureSequence::step(double now_s, const CaptureInputs& in) {
    now_s_ = now_s;
    actions_.clear();
    is_still_pending_ = is_still_pending_ || in.is_still_wanted;
    if (is_running() && in.has_frame) last_frame_s_ = now_s;
    if (!in.is_present) {
        has_died_ = false;
        lose(State::absent);
        return actions_;
    }
    if (state_ != State::absent && (in.has_refused || is_silent())) {
        has_died_ = true;
        lose(State::pausing);
        return actions_;
    }
    switch (state_) {
        case State::absent:
            order(CaptureAction::open);
            enter(State::opening);
            break;
        case State::pausing:
            if (elapsed_s() < limits_.retry_s) break;
            order(CaptureAction::open);
            enter(State::opening);
            break;
        case State::opening:
            if (!in.opened) break;
            abilities_ = *in.opened;
            start_preview();
            break;
        case State::starting:
            if (!in.has_frame) break;
            has_died_ = false;
            enter(State::previewing);
            break;
        case State::previewing:
            if (!is_still_pending_) break;
            attempt_ = 0;
            best_ = {};
            begin_attempt();
            break;
        case State::focusing:
            if (in.loops.is_focused.value_or(false) || elapsed_s() >= limits_.focus_s)
                enter(State::settling);
            break;
        case State::settling:
            settle(in);
            break;
        case State::locking:  // orders travel with the next request
            if (in.has_frame || !abilities_.has_exposure_lock) begin_sharpening();
            break;
        case State::sharpening:
            sharpen(in);
            break;
    }
    return actions_;
}

CameraCondition CaptureSequence::condition() const {
    if (state_ == State::absent) return CameraCondition::absent;
    if (has_died_) return CameraCondition::stopped;
    if (state_ <= State::starting) return CameraCondition::starting;
    return state_ == State::previewing ? CameraCondition::ready : CameraCondition::taking;
}

void CaptureSequence::enter(State state) {
    state_ = state;
    entered_s_ = now_s_;
    steady_ = 0;
}

/// The camera is gone or silent. A requested still is not taken when it comes back, because the
/// visitor has moved on by then.
void CaptureSequence::lose(State next) {
    if (is_still_pending_) order(CaptureAction::give_up);
    is_still_pending_ = false;
    is_still_running_ = false;
    if (state_ > State::pausing) order(CaptureAction::close);
    if (state_ != next) enter(next);
}

bool CaptureSequence::is_silent() const {
    if (state_ == State::opening) return elapsed_s() > limits_.start_s;
    if (!is_running()) return false;
    return last_frame_s_ ? now_s_ - *last_frame_s_ > limits_.stall_s
                         : now_s_ - stream_started_s_ > limits_.start_s;
}

void CaptureSequence::start(CaptureAction stream) {
    order(stream);
    is_still_running_ = stream == CaptureAction::start_still;
    stream_started_s_ = now_s_;
    last_frame_s_.reset();
}

void CaptureSequence::start_preview() {
    start(CaptureAction::start_preview);
    enter(State::starting);
}

void CaptureSequence::begin_attempt() {
    if (abilities_.has_focus_lock) order(CaptureAction::focus);
    enter(abilities_.has_focus_lock ? State::focusing : State::settling);
}

/// True after a few frames without change.
bool CaptureSequence::is_steady(const FrameQuality& quality) {
    const bool is_same = std::abs(quality.brightness - steady_brightness_) <= limits_.steady_levels;
    steady_ = is_same ? steady_ + 1 : 0;
    steady_brightness_ = quality.brightness;
    return steady_ >= limits_.steady_frames;
}

void CaptureSequence::settle(const CaptureInputs& in) {
    const bool is_light_steady = in.has_frame && is_steady(in.quality);
    const bool is_settled = in.loops.is_exposure_settled.value_or(is_light_steady);
    if (!is_settled && elapsed_s() < limits_.settle_s) return;
    if (abilities_.has_exposure_lock) order(CaptureAction::lock_exposure);
    enter(State::locking);
}

void CaptureSequence::begin_sharpening() {
    settled_brightness_ = steady_brightness_;
    enter(State::sharpening);
    first_still_s_.reset();
    best_ = {};
    if (abilities_.has_two_streams) {
        order(CaptureAction::request_still);
    } else if (!is_still_running_) {
        start(CaptureAction::start_still);
    }
}

/// On many cameras the stream starts dark and blurred at its new size, so the best frame is kept
/// until no better one comes. The search starts again while the light is not yet that of the
/// preview, or jumps.
void CaptureSequence::sharpen(const CaptureInputs& in) {
    if (in.has_frame && (in.is_frame_still || is_still_running_)) {
        if (!first_still_s_) first_still_s_ = now_s_;
        const double jump = std::abs(in.quality.brightness - steady_brightness_);
        const double off = std::abs(in.quality.brightness - settled_brightness_);
        const bool is_unsettled = jump > limits_.steady_levels ||
                                  off > limits_.brightness_tolerance * settled_brightness_;
        const bool is_sharper = in.quality.sharpness > best_.sharpness * limits_.steady_ratio;
        steady_brightness_ = in.quality.brightness;
        steady_ = is_unsettled || is_sharper ? 0 : steady_ + 1;
        if (is_unsettled || in.quality.sharpness >= best_.sharpness) {
            best_ = in.quality;
            order(CaptureAction::keep);
        }
        if (abilities_.has_two_streams) order(CaptureAction::request_still);
    }
    const bool is_time_over = first_still_s_ && now_s_ - *first_still_s_ >= limits_.sharpen_s;
    // The second of two streams may fail alone, which the first one's frames hide.
    const bool has_none = !first_still_s_ && elapsed_s() > limits_.start_s;
    if (steady_ >= limits_.steady_frames || is_time_over || has_none) finish();
}

void CaptureSequence::finish() {
    const bool is_taken = first_still_s_.has_value();
    if (is_taken && (is_blurred() || is_clipped()) && attempt_ == 0) {
        ++attempt_;
        order(CaptureAction::free_loops);
        begin_attempt();
        return;
    }
    order(is_taken ? CaptureAction::deliver : CaptureAction::give_up);
    order(CaptureAction::free_loops);
    is_still_pending_ = false;
    if (is_still_running_) {
        start_preview();
    } else {
        enter(State::previewing);
    }
}

std::string_view sentence(CameraCondition condition) {
    switch (condition) {
        case CameraCondition::absent:
            return "There is no camera. Plug one in.";
        case CameraCondition::starting:
            return "The camera is starting.";
        case CameraCondition::stopped:
            return "The camera gives no picture. Please call the staff.";
        case CameraCondition::ready:
        case CameraCondition::taking:
            return "";
    }
    return "";
}

}  // namespace touchline
