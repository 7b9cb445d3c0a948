// Cameras made up by a test: what they can do, and how they misbehave.
#pragma once

#include "vision/camera/camera_port.h"

#include <string>
#include <vector>

namespace touchline::testing {

struct FakeCamera {
    std::string id;
    CameraAbilities abilities;
    bool is_plugged = true;
    bool is_dead = false;     // gives neither frames nor errors
    bool is_garbled = false;  // gives frames that are not pictures
    bool refuses_open = false;
    bool refuses_start = false;
    bool is_still_dead = false;  // only the second stream is dead
    double sharpens_s = 0.0;     // frames are blurred for so long after a start
    double brightens_s = 0.0;    // and dark for so long
    bool is_never_sharp = false;
    int clipped_stills = 0;  // so many attempts are overexposed
    bool tells_loops = false;
    double focuses_s = 0.2;  // after focus_once; reported only with tells_loops
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
    int misuses = 0;               // calls out of order

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

/// A camera as Debian's kernel and libcamera present it: one stream, neither focus nor reports.
[[nodiscard]] FakeCamera usb_camera(const std::string& id);

/// A camera as a board with an image processor presents it: two streams, focus, reports.
[[nodiscard]] FakeCamera board_camera(const std::string& id);

}  // namespace touchline::testing
