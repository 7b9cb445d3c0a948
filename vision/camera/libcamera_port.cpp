#include "vision/camera/libcamera_port.h"

#include "vision/camera/libcamera_stream.h"

#include <algorithm>

#include <libcamera/camera_manager.h>
#include <libcamera/control_ids.h>
#include <libcamera/formats.h>
#include <libcamera/logging.h>
#include <libcamera/property_ids.h>

namespace touchline {
namespace {

using libcamera::StreamRole;

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

struct LibcameraPort::Cameras {
    Cameras() = default;
    Cameras(const Cameras&) = delete;
    Cameras(Cameras&&) = delete;
    Cameras& operator=(const Cameras&) = delete;
    Cameras& operator=(Cameras&&) = delete;

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
    auto stream = LibcameraStream::start(cameras_->open, plan, orders_);
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
