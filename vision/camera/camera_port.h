// The interface to a camera system: libcamera's, or a made-up one in a test. It carries out orders
// and reports what the camera says; capture_sequence.h decides when to order what.
#pragma once

#include "config/types/pinned.h"
#include "config/types/result.h"
#include "vision/camera/frame.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

struct CameraName {
    std::string id;    // stays the same if plugged into the same socket again
    std::string name;  // for people
};

struct StreamMode {
    PixelFormat format = PixelFormat::yuyv;
    cv::Size size;
    bool operator==(const StreamMode&) const = default;
};

/// The abilities of this camera, as it reports them. No ability is common to all cameras.
struct CameraAbilities {
    std::vector<StreamMode> modes;  // only formats that to_bgr() knows
    bool has_two_streams = false;   // preview and still at once
    bool has_focus_lock = false;    // focuses on demand, then holds the lens
    bool has_exposure_lock = false;
};

/// The still mode is used only with two streams.
struct StreamPlan {
    StreamMode preview;
    std::optional<StreamMode> still;
};

/// What the camera's own control loops must do from the next frame on.
enum class LoopOrder : std::uint8_t { lock_exposure, free_exposure, focus_once, focus_freely };

struct TakenFrame {
    CameraFrame frame;
    LoopReport loops;
    bool is_still = false;  // from the second stream
};

/// Threads: one caller.
class CameraPort : public Interface {
  public:
    /// Returns the cameras that are plugged in now.
    [[nodiscard]] virtual std::vector<CameraName> list() = 0;
    /// Takes the camera for this program and returns its abilities. One camera at a time.
    [[nodiscard]] virtual Result<CameraAbilities> open(const std::string& id) = 0;
    /// Stops the running streams, configures and starts. The camera may change the sizes; frames
    /// carry their own.
    [[nodiscard]] virtual Result<void> start(const StreamPlan& plan) = 0;
    virtual void order(LoopOrder order) = 0;
    /// Requests one frame of the second stream.
    virtual void request_still() = 0;
    /// Returns the newest frame not taken yet; never waits. Returns nothing while none came, and
    /// forever once the stream has died: a camera does not report that.
    [[nodiscard]] virtual std::optional<TakenFrame> take() = 0;
    /// Stops and gives the camera back. Harmless if none is open.
    virtual void close() = 0;
};

}  // namespace touchline
