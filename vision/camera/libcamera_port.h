// Cameras through libcamera 0.0.3 (Debian 12) or 0.4 (Debian 13): USB cameras of the UVC class,
// which have one stream there and neither focus nor exposure reports, and those of boards with an
// image processor, which have more. Frames arrive on libcamera's own thread and wait here, the
// newest only. Threads: one caller; one object per process, as libcamera demands.
#pragma once

#include "vision/camera/camera_port.h"

#include <memory>

namespace touchline {

class LibcameraPort : public CameraPort {
  public:
    /// Fails if libcamera does not start. Having no camera is not a failure.
    [[nodiscard]] static Result<std::unique_ptr<LibcameraPort>> create();
    ~LibcameraPort() override;

    [[nodiscard]] std::vector<CameraName> list() override;
    [[nodiscard]] Result<CameraAbilities> open(const std::string& id) override;
    [[nodiscard]] Result<void> start(const StreamPlan& plan) override;
    void order(LoopOrder order) override;
    void request_still() override;
    [[nodiscard]] std::optional<TakenFrame> take() override;
    void close() override;

  private:
    struct Cameras;
    class Stream;

    explicit LibcameraPort(std::unique_ptr<Cameras> cameras);

    std::unique_ptr<Cameras> cameras_;
    std::vector<LoopOrder> orders_;    // in force: a new stream gets them again
    std::unique_ptr<Stream> running_;  // after cameras_: goes first
};

}  // namespace touchline
