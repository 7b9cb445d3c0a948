// Decides when to order what from a camera: find it, start it, notice that it died, take a still. A
// state machine on the time that it is told; it gives orders, and the caller carries them out
// (stream_camera.h).
//
//   absent -> opening -> starting -> previewing -> focusing -> settling -> locking -> sharpening
//                ^                    (still asked for)                                    |
//                |              starting again, with the preview <-------------------------+
//                +-- pausing: from everywhere, when the camera refuses or is silent
//
// Threads: one caller. Deterministic. O(1) a step.
#pragma once

#include "vision/camera/camera_port.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace touchline {

struct CaptureLimits {
    double start_s = 8.0;    // until the first frame of a stream
    double stall_s = 2.0;    // between frames: longer, and the stream is dead
    double retry_s = 2.0;    // before a dead camera is opened again
    double focus_s = 3.0;    // after this time, goes on without focus
    double settle_s = 2.0;   // after this time, goes on without a settled exposure
    double sharpen_s = 2.0;  // from the still's first frame on
    int steady_frames = 3;   // without change: settled, or as sharp as it will get
    double steady_levels = 3.0;
    double brightness_tolerance = 0.25;  // share by which still and preview may differ
    double steady_ratio = 1.05;          // sharpness that grows by less does not grow
    /// At up to 0.8 megapixel, a page of text has about 500 or more, and one out of focus below 20.
    double least_sharpness = 30.0;
    double most_clipped_share = 0.02;
};

enum class CameraCondition : std::uint8_t {
    absent,    // no camera is plugged in
    starting,  // no frame yet
    ready,     // previews come
    taking,    // a still is under way
    stopped,   // it is plugged in but gives no frames
};

enum class CaptureAction : std::uint8_t {
    open,
    start_preview,
    start_still,    // with one stream only: the same stream, at the largest size
    request_still,  // with two streams only
    focus,
    lock_exposure,
    free_loops,  // exposure and focus run by themselves again
    keep,        // the frame of this step is the best still so far
    deliver,     // the kept frame is the still
    give_up,     // there will be no still
    close,
};

struct CaptureInputs {
    bool is_present = false;                // the chosen camera is plugged in
    std::optional<CameraAbilities> opened;  // the answer to `open`
    bool has_refused = false;               // an action of the last step could not be carried out
    bool has_frame = false;                 // one came and was readable
    bool is_frame_still = false;            // from the second of two streams
    FrameQuality quality;                   // of that frame
    LoopReport loops;
    bool is_still_wanted = false;  // asked for since the last step
};

class CaptureSequence {
  public:
    explicit CaptureSequence(const CaptureLimits& limits = {}) : limits_(limits) {}

    /// `now_s` never falls.
    [[nodiscard]] std::vector<CaptureAction> step(double now_s, const CaptureInputs& in);

    [[nodiscard]] CameraCondition condition() const;

    [[nodiscard]] bool is_still_pending() const { return is_still_pending_; }

    /// True while the frames of the one stream are stills.
    [[nodiscard]] bool is_still_running() const { return is_still_running_; }

    /// True if the still kept last is blurred; below, if it is overexposed.
    [[nodiscard]] bool is_blurred() const { return best_.sharpness < limits_.least_sharpness; }

    [[nodiscard]] bool is_clipped() const {
        return best_.clipped_share > limits_.most_clipped_share;
    }

  private:
    enum class State : std::uint8_t {
        absent,
        pausing,
        opening,
        starting,
        previewing,
        focusing,
        settling,
        locking,
        sharpening,
    };

    void enter(State state);

    void order(CaptureAction action) { actions_.push_back(action); }

    void lose(State next);
    void start(CaptureAction stream);
    void start_preview();
    void begin_attempt();
    void settle(const CaptureInputs& in);
    void begin_sharpening();
    void sharpen(const CaptureInputs& in);
    void finish();

    [[nodiscard]] bool is_running() const { return state_ >= State::starting; }

    [[nodiscard]] bool is_silent() const;
    [[nodiscard]] bool is_steady(const FrameQuality& quality);

    [[nodiscard]] double elapsed_s() const { return now_s_ - entered_s_; }

    CaptureLimits limits_;
    CameraAbilities abilities_;
    State state_ = State::absent;
    std::vector<CaptureAction> actions_;
    double now_s_ = 0.0;
    double entered_s_ = 0.0;
    double stream_started_s_ = 0.0;
    std::optional<double> last_frame_s_;  // of the stream that runs
    std::optional<double> first_still_s_;
    bool is_still_running_ = false;
    bool is_still_pending_ = false;
    bool has_died_ = false;
    int attempt_ = 0;
    int steady_ = 0;
    double steady_brightness_ = 0.0;   // of the last frame
    double settled_brightness_ = 0.0;  // of the preview
    FrameQuality best_;
};

/// Returns what to say, in at most 15 words; empty if all is well.
[[nodiscard]] std::string_view sentence(CameraCondition condition);

}  // namespace touchline
