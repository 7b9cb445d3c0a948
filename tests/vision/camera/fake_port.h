// Cameras that a test makes up: what they can do, and how they misbehave.
#pragma once

#include "vision/camera/camera_port.h"

#include <string>
#include <vector>

namespace touchline::testing {

struct FakeCamera {
    std::string id;
    CameraAbilities abilities;
    bool is_plugged = true;
    bool is_dead = false;     // gives no frames, and no error
    bool is_garbled = false;  // frames that are no pictures
    bool refuses_open = false;
    bool refuses_start = false;
    bool is_still_dead = false;  // nothing but the second stream is dead
    double sharpens_s = 0.0;     // after a start frames are blurred for so long
    double brightens_s = 0.0;    // and dark
    bool is_never_sharp = false;
    int clipped_stills = 0;  // so many attempts are flooded with light
    bool tells_loops = false;
    double focuses_s = 0.2;  // after focus_once; told only with tells_loops
};

/// A 10 Hz camera on the time that the test sets. Counts what no driver may do.
class FakePort : public CameraPort {
  public:
    explicit FakePort(std::vector<FakeCamera> plugged) : cameras(std::move(plugged)) {}

    [[nodiscard]] std::vector<CameraName> list() override;
    [[nodiscard]] Result<CameraAbilities> open(const std::string& id) override;
    [[nodiscard]] Result<void> start(const StreamPlan& plan) override;
    void order(LoopOrder order) override;
    void request_still() override;
    [[nodiscard]] std::optional<TakenFrame> take() override;
    void close() override;

    std::vector<FakeCamera> cameras;
    double now_s = 0.0;
    std::vector<std::string> log;  // "open a", "start 640x480", "lock", ...
    int misuses = 0;               // orders that do not fit

  private:
    [[nodiscard]] FakeCamera* find(const std::string& id);
    [[nodiscard]] CameraFrame frame_now(cv::Size size) const;

    void expect(bool is_right) { misuses += is_right ? 0 : 1; }

    FakeCamera* open_ = nullptr;
    std::optional<StreamPlan> plan_;
    double started_s_ = 0.0;
    double last_frame_s_ = 0.0;
    double focus_ordered_s_ = 0.0;
    int stills_left_ = 0;
    bool is_attempt_clipped_ = false;
};

/// As Debian's kernel and libcamera give it: one stream, neither focus nor reports.
[[nodiscard]] FakeCamera usb_camera(const std::string& id);

/// As a board with an image processor gives it: two streams, focus, reports.
[[nodiscard]] FakeCamera board_camera(const std::string& id);

}  // namespace touchline::testing
