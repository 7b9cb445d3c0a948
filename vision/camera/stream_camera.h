// A camera that streams, behind a port: chooses among the modes that it offers, and carries out the
// orders of the capture sequence.
// Threads: one caller.
#pragma once

#include "vision/camera/camera.h"
#include "vision/camera/camera_port.h"

#include <memory>

namespace touchline {

/// Returns the smallest mode that is at least 640 x 480, else the largest. Among modes of one size
/// it prefers nv12 to yuyv, and yuyv to mjpeg, which costs decoding. Returns nothing if there is no
/// mode. O(modes).
[[nodiscard]] std::optional<StreamMode> preview_mode(const CameraAbilities& abilities);

/// Returns the largest mode; among modes of one size, mjpeg comes last. O(modes).
[[nodiscard]] std::optional<StreamMode> still_mode(const CameraAbilities& abilities);

class StreamCamera : public Camera {
  public:
    explicit StreamCamera(std::unique_ptr<CameraPort> port, const CaptureLimits& limits = {});
    ~StreamCamera() override;

    [[nodiscard]] std::vector<CameraName> list() override { return port_->list(); }

    void choose(const std::string& id) override;

    [[nodiscard]] std::optional<CameraAbilities> abilities() const override { return abilities_; }

    void want_still() override { is_still_wanted_ = true; }

    [[nodiscard]] CameraView step(double now_s) override;

  private:
    [[nodiscard]] bool is_present();
    void read_frame(CaptureInputs& in, CameraView& view);
    void carry_out(CaptureAction action, CameraView& view);
    void start(bool is_still);

    std::unique_ptr<CameraPort> port_;
    CaptureLimits limits_;
    CaptureSequence sequence_;
    std::string wanted_id_;
    std::string id_;  // of the camera in use or to be opened
    std::optional<CameraAbilities> abilities_;
    bool has_just_opened_ = false;
    bool has_refused_ = false;
    bool is_still_wanted_ = false;
    bool has_given_up_ = false;  // on a still of the camera before
    CameraFrame frame_;          // this step's
    FrameQuality quality_;
    Still best_;
};

}  // namespace touchline
