// One run of a camera's stream, or of its two: buffers, requests, the newest frame. Private to
// vision/camera. Threads: one caller, besides libcamera's own thread, which calls has_completed().
#pragma once

#include "vision/camera/camera_port.h"

#include <map>
#include <memory>
#include <mutex>

#include <libcamera/camera.h>
#include <libcamera/framebuffer_allocator.h>
#include <libcamera/request.h>

namespace touchline {

class LibcameraStream {
  public:
    /// Configures, starts and requests frames. `camera` is acquired, and stays so while this object
    /// lives.
    [[nodiscard]] static Result<std::unique_ptr<LibcameraStream>> start(
        std::shared_ptr<libcamera::Camera> camera, const StreamPlan& plan,
        const std::vector<LoopOrder>& orders);
    ~LibcameraStream();
    LibcameraStream(const LibcameraStream&) = delete;
    LibcameraStream(LibcameraStream&&) = delete;
    LibcameraStream& operator=(const LibcameraStream&) = delete;
    LibcameraStream& operator=(LibcameraStream&&) = delete;

    void order(LoopOrder order);

    void request_still() { is_still_wanted_ = true; }

    [[nodiscard]] std::optional<TakenFrame> take();

  private:
    /// The memory of a buffer's planes, mapped into this process.
    struct Mapping {
        std::uint8_t* start = nullptr;
        std::size_t size_bytes = 0;
        const std::uint8_t* bytes = nullptr;
    };

    explicit LibcameraStream(std::shared_ptr<libcamera::Camera> camera);
    [[nodiscard]] Result<void> configure(const StreamPlan& plan);
    [[nodiscard]] Result<void> prepare_buffers();
    [[nodiscard]] Result<void> map(const libcamera::FrameBuffer& buffer);
    [[nodiscard]] TakenFrame copy_of(const libcamera::Request& request) const;
    void has_completed(libcamera::Request* request);
    void queue(libcamera::Request& request);

    std::shared_ptr<libcamera::Camera> camera_;
    std::unique_ptr<libcamera::CameraConfiguration> configuration_;
    libcamera::FrameBufferAllocator allocator_;
    std::map<const libcamera::FrameBuffer*, std::vector<Mapping>> mappings_;
    std::vector<std::unique_ptr<libcamera::Request>> requests_;
    bool is_started_ = false;
    libcamera::ControlList orders_;  // for the next request
    bool is_still_wanted_ = false;
    std::mutex mutex_;
    std::vector<libcamera::Request*> completed_;  // under the mutex, oldest first
};

}  // namespace touchline
