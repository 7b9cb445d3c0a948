#include "app/kiosk/photo_capture.h"

#include "app/documents/trace/tracing.h"
#include "app/isolation/process/places.h"
#include "vision/camera/folder_camera.h"
#include "vision/camera/libcamera_port.h"
#include "vision/camera/stream_camera.h"

#include <filesystem>
#include <string>
#include <utility>

#include <opencv2/core.hpp>

namespace touchline {
namespace {

constexpr int preview_px = 640;

Result<cv::Mat> read_bgr(const std::filesystem::path& file) {
    auto picture = read_picture(file.string());
    if (!picture) return tl::unexpected(picture.error());
    return cv::Mat(picture->height, picture->width, CV_8UC3, picture->bgr.data()).clone();
}

}  // namespace

void PhotoCapture::show(bool is_wanted) {
    is_shown_ = is_wanted;
    if (!is_wanted) preview_.reset();
}

PhotoNews PhotoCapture::step(double now_s) {
    CameraView view = camera_->step(now_s);
    PhotoNews news;
    news.condition = view.condition;
    news.has_given_up = view.has_given_up;
    const bool is_answer = view.still || view.has_given_up;
    if (is_answer && std::exchange(is_stale_, false)) {
        view.still.reset();
        news.has_given_up = false;
    } else if (is_answer) {
        is_awaited_ = false;
    }
    if (view.still) {
        news.is_doubtful = view.still->is_blurred || view.still->is_clipped;
        news.photo = file_of(std::move(view.still->frame), cut_);
    }
    if (is_shown_ && view.preview) {
        preview_ = std::make_shared<const Canvas>(
            canvas_of(picture_of(cut_off(*view.preview, cut_)), preview_px));
    }
    return news;
}

FilePtr file_of(CameraFrame frame, const PhotoCut& cut) {
    const auto kept = std::make_shared<const CameraFrame>(std::move(frame));
    return std::make_shared<const PictureFile>(
        PictureFile{"photo", "", "", true,
                    [kept, cut](const PageOrder&) { return page_of_photo(*kept, cut); }});
}

Result<std::unique_ptr<Camera>> open_camera() {
    const std::string folder = environment("TOUCHLINE_CAMERA");
    if (!folder.empty()) return std::make_unique<FolderCamera>(folder, read_bgr);
    auto port = LibcameraPort::create();
    if (!port) return tl::unexpected(port.error());
    return std::make_unique<StreamCamera>(std::move(*port));
}

}  // namespace touchline
