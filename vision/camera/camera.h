// A camera as the program uses it, whatever gives the pictures: a real one (stream_camera.h) or a
// folder of pictures (folder_camera.h). Nothing here waits; step() is called at the screen's rate.
// Threads: one caller.
#pragma once

#include "vision/camera/capture_sequence.h"
#include "vision/camera/conversion.h"

namespace touchline {

/// A picture taken. The frame is as the camera gave it, so that the user of it decides how much of
/// it to decode: to_bgr(frame, quick_size(frame.size, 1'000'000)) for outlines, all for a zoom.
struct Still {
    CameraFrame frame;
    FrameQuality quality;
    bool is_blurred = false;  // even after a second attempt
    bool is_clipped = false;  // likewise: too much of it is as bright as can be
};

/// What is new since the last step.
struct CameraView {
    CameraCondition condition = CameraCondition::absent;
    std::optional<cv::Mat> preview;  // 8-bit BGR, at most preview_pixels
    std::optional<Still> still;
    bool has_given_up = false;  // the still that was asked for will not come
};

constexpr std::int64_t preview_pixels = std::int64_t{640} * 480;

class Camera {
  public:
    Camera() = default;
    Camera(const Camera&) = delete;
    Camera(Camera&&) = delete;
    Camera& operator=(const Camera&) = delete;
    Camera& operator=(Camera&&) = delete;
    virtual ~Camera() = default;

    [[nodiscard]] virtual std::vector<CameraName> list() = 0;
    /// Used from the next step on, whenever it is plugged in; another one never takes its place. ""
    /// (as at the start): whichever comes first.
    virtual void choose(const std::string& id) = 0;
    /// Of the camera in use; nothing while there is none.
    [[nodiscard]] virtual std::optional<CameraAbilities> abilities() const = 0;
    /// Ends with a still or has_given_up in one of the next steps.
    virtual void want_still() = 0;
    /// `now_s` never falls.
    [[nodiscard]] virtual CameraView step(double now_s) = 0;
};

}  // namespace touchline
