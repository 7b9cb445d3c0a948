// A camera as the program uses it, whatever supplies the pictures: a real one (stream_camera.h) or
// a folder of pictures (folder_camera.h). Nothing here waits; step() is called at the screen's
// rate.
// Threads: one caller.
#pragma once

#include "config/types/pinned.h"
#include "vision/camera/capture_sequence.h"
#include "vision/camera/frame.h"

namespace touchline {

/// A picture taken. The frame is as the camera gave it, so that its user decides how much of it to
/// decode: to_bgr(frame, quick_size(frame.size, 1'000'000)) for outlines, all of it for a zoom.
struct Still {
    CameraFrame frame;
    FrameQuality quality;
    bool is_blurred = false;  // even after a second attempt
    bool is_clipped = false;  // likewise: too much of it is at full brightness
};

/// News since the last step.
struct CameraView {
    CameraCondition condition = CameraCondition::absent;
    std::optional<cv::Mat> preview;  // 8-bit BGR, at most preview_pixels
    std::optional<Still> still;
    bool has_given_up = false;  // the requested still will not come
};

constexpr std::int64_t preview_pixels = std::int64_t{640} * 480;

class Camera : public Interface {
  public:
    [[nodiscard]] virtual std::vector<CameraName> list() = 0;
    /// Chooses the camera to use from the next step on, whenever it is plugged in; another one
    /// never takes its place. "" (as at the start) takes whichever comes first.
    virtual void choose(const std::string& id) = 0;
    /// The abilities of the camera in use; nothing while there is none.
    [[nodiscard]] virtual std::optional<CameraAbilities> abilities() const = 0;
    /// Asks for a still. One of the next steps returns a still or has_given_up.
    virtual void want_still() = 0;
    /// `now_s` never falls.
    [[nodiscard]] virtual CameraView step(double now_s) = 0;
};

}  // namespace touchline
