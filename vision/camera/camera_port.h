// The seam to a system of cameras: libcamera's, or one that a test makes up. It carries orders out
// and tells what the camera said; when to order what is capture_sequence.h.
#pragma once

#include "config/types/result.h"
#include "vision/camera/frame.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

struct CameraName {
    std::string id;    // the same again when it is plugged into the same socket
    std::string name;  // for people
};

struct StreamMode {
    PixelFormat format = PixelFormat::yuyv;
    cv::Size size;
    bool operator==(const StreamMode&) const = default;
};

/// What this camera can do, as it was asked. Nothing here is true of all cameras.
struct CameraAbilities {
    std::vector<StreamMode> modes;  // only formats that to_bgr() knows
    bool has_two_streams = false;   // preview and still at once
    bool has_focus_lock = false;    // focuses on demand, then holds the lens
    bool has_exposure_lock = false;
};

/// The still mode is asked for only with two streams.
struct StreamPlan {
    StreamMode preview;
    std::optional<StreamMode> still;
};

/// What the camera's own control loops shall do from the next frame on.
enum class LoopOrder : std::uint8_t { lock_exposure, free_exposure, focus_once, focus_freely };

struct TakenFrame {
    CameraFrame frame;
    LoopReport loops;
    bool is_still = false;  // from the second stream
};

/// Threads: one caller.
class CameraPort {
  public:
    CameraPort() = default;
    CameraPort(const CameraPort&) = delete;
    CameraPort(CameraPort&&) = delete;
    CameraPort& operator=(const CameraPort&) = delete;
    CameraPort& operator=(CameraPort&&) = delete;
    virtual ~CameraPort() = default;

    /// Those plugged in now.
    [[nodiscard]] virtual std::vector<CameraName> list() = 0;
    /// Takes the camera for this program and asks what it can do. One at a time.
    [[nodiscard]] virtual Result<CameraAbilities> open(const std::string& id) = 0;
    /// Stops what runs, configures, starts. The camera may change the sizes; frames tell theirs.
    [[nodiscard]] virtual Result<void> start(const StreamPlan& plan) = 0;
    virtual void order(LoopOrder order) = 0;
    /// One frame of the second stream, please.
    virtual void request_still() = 0;
    /// The newest frame that was not taken yet; never waits. Nothing while none came, and for ever
    /// when the stream has died: a camera does not tell.
    [[nodiscard]] virtual std::optional<TakenFrame> take() = 0;
    /// Stops and gives the camera back. Harmless when none is open.
    virtual void close() = 0;
};

}  // namespace touchline
