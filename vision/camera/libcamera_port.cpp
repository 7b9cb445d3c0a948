#include "vision/camera/libcamera_port.h"

#include <algorithm>
#include <map>
#include <mutex>

#include <libcamera/camera.h>
#include <libcamera/camera_manager.h>
#include <libcamera/control_ids.h>
#include <libcamera/formats.h>
#include <libcamera/framebuffer_allocator.h>
#include <libcamera/logging.h>
#include <libcamera/property_ids.h>
#include <libcamera/request.h>
#include <libcamera/version.h>
#include <sys/mman.h>

namespace touchline {
namespace {

namespace controls = libcamera::controls;
using libcamera::StreamRole;

constexpr unsigned int buffers_wanted = 4;

libcamera::PixelFormat format_of(PixelFormat format) {
    switch (format) {
        case PixelFormat::yuyv:
            return libcamera::formats::YUYV;
        case PixelFormat::mjpeg:
            return libcamera::formats::MJPEG;
        case PixelFormat::nv12:
            return libcamera::formats::NV12;
        case PixelFormat::bgr:
            break;  // no camera offers it here
    }
    return {};
}

PixelFormat format_of(const libcamera::PixelFormat& format) {
    if (format == libcamera::formats::MJPEG) return PixelFormat::mjpeg;
    return format == libcamera::formats::NV12 ? PixelFormat::nv12 : PixelFormat::yuyv;
}

void set_mode(libcamera::StreamConfiguration& stream, const StreamMode& mode) {
    stream.pixelFormat = format_of(mode.format);
    stream.size = {static_cast<unsigned int>(mode.size.width),
                   static_cast<unsigned int>(mode.size.height)};
    stream.bufferCount = buffers_wanted;
}

/// libcamera reports this differently since 0.5, which Raspberry Pi OS has; compiled with 0.7, not
/// tried.
std::optional<bool> is_exposure_settled(const libcamera::ControlList& told) {
#if LIBCAMERA_VERSION_MAJOR == 0 && LIBCAMERA_VERSION_MINOR < 5
    return told.get(controls::AeLocked);
#else
    const auto state = told.get(controls::AeState);
    if (!state) return std::nullopt;
    return *state == controls::AeStateConverged;
#endif
}

LoopReport loops_of(const libcamera::ControlList& told) {
    LoopReport report;
    if (const auto state = told.get(controls::AfState))
        report.is_focused = *state == controls::AfStateFocused;
    report.is_exposure_settled = is_exposure_settled(told);
    return report;
}

std::optional<PixelFormat> known_format(const libcamera::PixelFormat& format) {
    if (format == libcamera::formats::YUYV) return PixelFormat::yuyv;
    if (format == libcamera::formats::MJPEG) return PixelFormat::mjpeg;
    if (format == libcamera::formats::NV12) return PixelFormat::nv12;
    return std::nullopt;
}

std::string name_of(const libcamera::Camera& camera) {
    const auto model = camera.properties().get(libcamera::properties::Model);
    return model ? std::string(*model) : camera.id();
}

std::vector<StreamMode> modes_of(const libcamera::StreamFormats& formats) {
    std::vector<StreamMode> modes;
    for (const auto& format : formats.pixelformats()) {
        const auto known = known_format(format);
        if (!known) continue;
        for (const libcamera::Size& size : formats.sizes(format))
            modes.push_back(
                {*known, {static_cast<int>(size.width), static_cast<int>(size.height)}});
    }
    return modes;
}

/// Only a trial tells: cameras with one stream answer with a shorter list.
bool has_two_streams(libcamera::Camera& camera) {
    const auto both =
        camera.generateConfiguration({StreamRole::Viewfinder, StreamRole::StillCapture});
    return both && both->size() == 2 &&
           both->validate() != libcamera::CameraConfiguration::Invalid && both->size() == 2;
}

bool has_focus_lock(const libcamera::Camera& camera) {
    const auto& controls = camera.controls();
    const auto modes = controls.find(&libcamera::controls::AfMode);
    if (modes == controls.end() || controls.find(&libcamera::controls::AfTrigger) == controls.end())
        return false;
    const auto& values = modes->second.values();
    return std::find(values.begin(), values.end(),
                     libcamera::ControlValue(std::int32_t{libcamera::controls::AfModeAuto})) !=
           values.end();
}

bool has_exposure_lock(const libcamera::Camera& camera) {
    return camera.controls().find(&libcamera::controls::AeEnable) != camera.controls().end();
}

}  // namespace

/// One run of a camera's stream, or of its two: buffers, requests, the newest frame. Threads: one
/// caller, besides libcamera's own thread, which calls has_completed().
class LibcameraPort::Stream : Pinned {
  public:
    /// Configures, starts and requests frames. `camera` is acquired, and stays so while this object
    /// lives.
    [[nodiscard]] static Result<std::unique_ptr<Stream>> start(
        std::shared_ptr<libcamera::Camera> camera, const StreamPlan& plan,
        const std::vector<LoopOrder>& orders) {
        std::unique_ptr<Stream> stream(new Stream(std::move(camera)));
        if (auto done = stream->configure(plan); !done) return tl::unexpected(done.error());
        if (auto done = stream->prepare_buffers(); !done) return tl::unexpected(done.error());
        stream->camera_->requestCompleted.connect(stream.get(), &Stream::has_completed);
        if (stream->camera_->start() != 0) return failure("the camera does not start");
        stream->is_started_ = true;
        for (const LoopOrder order : orders) stream->order(order);
        for (const auto& request : stream->requests_) stream->queue(*request);
        return stream;
    }

    ~Stream() {
        // After this, no thread of libcamera is in has_completed().
        if (is_started_) camera_->stop();
        camera_->requestCompleted.disconnect(this);
        requests_.clear();
        for (const auto& [buffer, planes] : mappings_)
            for (const Mapping& plane : planes) munmap(plane.start, plane.size_bytes);
        if (configuration_)
            for (const auto& stream : *configuration_) allocator_.free(stream.stream());
    }

    void order(LoopOrder order) {
        switch (order) {
            case LoopOrder::lock_exposure:
                orders_.set(controls::AeEnable, false);
                break;
            case LoopOrder::free_exposure:
                orders_.set(controls::AeEnable, true);
                break;
            case LoopOrder::focus_once:
                orders_.set(controls::AfMode, std::int32_t{controls::AfModeAuto});
                orders_.set(controls::AfTrigger, std::int32_t{controls::AfTriggerStart});
                break;
            case LoopOrder::focus_freely:
                orders_.set(controls::AfMode, std::int32_t{controls::AfModeContinuous});
                break;
        }
    }

    void request_still() { is_still_wanted_ = true; }

    /// Frames that nobody took in time go back unseen, but a still is never skipped.
    [[nodiscard]] std::optional<TakenFrame> take() {
        std::vector<libcamera::Request*> completed;
        {
            const std::lock_guard lock(mutex_);
            completed.swap(completed_);
        }
        if (completed.empty()) return std::nullopt;
        const auto still =
            std::find_if(completed.begin(), completed.end(),
                         [](const auto* request) { return request->buffers().size() > 1; });
        libcamera::Request& chosen = still == completed.end() ? *completed.back() : **still;
        TakenFrame taken = copy_of(chosen);
        taken.loops = loops_of(chosen.metadata());
        for (libcamera::Request* request : completed) queue(*request);
        return taken;
    }

  private:
    /// The memory of a buffer's planes, mapped into this process.
    struct Mapping {
        std::uint8_t* start = nullptr;
        std::size_t size_bytes = 0;
        const std::uint8_t* bytes = nullptr;
    };

    explicit Stream(std::shared_ptr<libcamera::Camera> camera)
        : camera_(std::move(camera)), allocator_(camera_), orders_(controls::controls) {}

    [[nodiscard]] Result<void> configure(const StreamPlan& plan) {
        std::vector<StreamRole> roles{StreamRole::Viewfinder};
        if (plan.still) roles.push_back(StreamRole::StillCapture);
        configuration_ = camera_->generateConfiguration(roles);
        if (!configuration_ || configuration_->size() != roles.size())
            return failure("the camera does not give the streams that it offered");
        set_mode(configuration_->at(0), plan.preview);
        if (plan.still) set_mode(configuration_->at(1), *plan.still);
        if (configuration_->validate() == libcamera::CameraConfiguration::Invalid ||
            camera_->configure(configuration_.get()) != 0) {
            configuration_.reset();
            return failure("the camera refuses the size that it offered");
        }
        return {};
    }

    [[nodiscard]] Result<void> prepare_buffers() {
        for (const auto& stream : *configuration_) {
            if (allocator_.allocate(stream.stream()) < 0)
                return failure("there is no memory for the camera's frames");
            for (const auto& buffer : allocator_.buffers(stream.stream()))
                if (auto done = map(*buffer); !done) return done;
        }
        const auto& previews = allocator_.buffers(configuration_->at(0).stream());
        for (std::size_t i = 0; i < previews.size(); ++i) {
            auto request = camera_->createRequest(i);
            if (!request) return failure("the camera takes no requests");
            requests_.push_back(std::move(request));
        }
        return {};
    }

    [[nodiscard]] Result<void> map(const libcamera::FrameBuffer& buffer) {
        for (const auto& plane : buffer.planes()) {
            Mapping mapping;
            mapping.size_bytes = std::size_t{plane.offset} + plane.length;
            void* start =
                mmap(nullptr, mapping.size_bytes, PROT_READ, MAP_SHARED, plane.fd.get(), 0);
            if (start == MAP_FAILED) return failure("the camera's frames cannot be read");
            mapping.start = static_cast<std::uint8_t*>(start);
            mapping.bytes = mapping.start + plane.offset;
            mappings_[&buffer].push_back(mapping);
        }
        return {};
    }

    [[nodiscard]] TakenFrame copy_of(const libcamera::Request& request) const {
        const bool is_still = request.buffers().size() > 1;
        const libcamera::StreamConfiguration& wanted = configuration_->at(is_still ? 1 : 0);
        const libcamera::FrameBuffer& buffer = *request.buffers().at(wanted.stream());
        TakenFrame taken;
        taken.is_still = is_still;
        taken.frame = {format_of(wanted.pixelFormat),
                       {static_cast<int>(wanted.size.width), static_cast<int>(wanted.size.height)},
                       wanted.stride,
                       {}};
        if (buffer.metadata().status != libcamera::FrameMetadata::FrameSuccess) return taken;
        const auto& planes = mappings_.at(&buffer);
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const std::size_t used = std::min<std::size_t>(buffer.metadata().planes()[i].bytesused,
                                                           planes[i].size_bytes);
            taken.frame.bytes.insert(taken.frame.bytes.end(), planes[i].bytes,
                                     planes[i].bytes + used);
        }
        return taken;
    }

    /// libcamera calls this on its own thread.
    void has_completed(libcamera::Request* request) {
        if (request->status() != libcamera::Request::RequestComplete) return;
        const std::lock_guard lock(mutex_);
        completed_.push_back(request);
    }

    /// The request takes the buffer of its number. A still takes the first of its stream, and no
    /// second one is requested before it came.
    void queue(libcamera::Request& request) {
        request.reuse();
        const auto* preview = configuration_->at(0).stream();
        const auto& buffers = allocator_.buffers(configuration_->at(0).stream());
        request.addBuffer(preview, buffers[request.cookie()].get());
        if (is_still_wanted_ && configuration_->size() > 1) {
            auto* still = configuration_->at(1).stream();
            request.addBuffer(still, allocator_.buffers(still).front().get());
            is_still_wanted_ = false;
        }
        request.controls().merge(orders_);
        orders_.clear();
        camera_->queueRequest(&request);
    }

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

struct LibcameraPort::Cameras : Pinned {
    ~Cameras() {
        release();
        if (is_started) manager.stop();
    }

    void release() {
        if (open) open->release();
        open.reset();
    }

    libcamera::CameraManager manager;
    bool is_started = false;
    std::shared_ptr<libcamera::Camera> open;  // acquired
};

LibcameraPort::LibcameraPort(std::unique_ptr<Cameras> cameras) : cameras_(std::move(cameras)) {}

LibcameraPort::~LibcameraPort() = default;

Result<std::unique_ptr<LibcameraPort>> LibcameraPort::create() {
    // Errors are reported in our own words, by the return values.
    libcamera::logSetTarget(libcamera::LoggingTargetNone);
    auto cameras = std::make_unique<Cameras>();
    if (cameras->manager.start() != 0) return failure("libcamera does not start");
    cameras->is_started = true;
    return std::unique_ptr<LibcameraPort>(new LibcameraPort(std::move(cameras)));
}

std::vector<CameraName> LibcameraPort::list() {
    std::vector<CameraName> names;
    for (const auto& camera : cameras_->manager.cameras())
        names.push_back({camera->id(), name_of(*camera)});
    return names;
}

Result<CameraAbilities> LibcameraPort::open(const std::string& id) {
    close();
    const auto camera = cameras_->manager.get(id);
    if (!camera) return failure("the camera is gone: " + id);
    if (camera->acquire() != 0) return failure("another program has the camera " + id);
    cameras_->open = camera;
    const auto offered = camera->generateConfiguration({StreamRole::StillCapture});
    if (!offered || offered->empty()) return failure("the camera offers no pictures: " + id);
    return CameraAbilities{modes_of(offered->at(0).formats()), has_two_streams(*camera),
                           has_focus_lock(*camera), has_exposure_lock(*camera)};
}

Result<void> LibcameraPort::start(const StreamPlan& plan) {
    running_.reset();
    if (!cameras_->open) return failure("no camera is open");
    auto stream = Stream::start(cameras_->open, plan, orders_);
    if (!stream) return tl::unexpected(stream.error());
    running_ = std::move(*stream);
    return {};
}

/// An order may be followed at once by a new stream, before any request could carry it.
void LibcameraPort::order(LoopOrder order) {
    std::erase(orders_, order);
    orders_.push_back(order);
    if (running_) running_->order(order);
}

void LibcameraPort::request_still() {
    if (running_) running_->request_still();
}

std::optional<TakenFrame> LibcameraPort::take() {
    return running_ ? running_->take() : std::nullopt;
}

void LibcameraPort::close() {
    running_.reset();
    orders_.clear();
    cameras_->release();
}

}  // namespace touchline
