#include "app/kiosk/photo_desk.h"

#include "app/process/places.h"
#include "vision/camera/conversion.h"
#include "vision/camera/folder_camera.h"
#include "vision/camera/libcamera_port.h"
#include "vision/camera/stream_camera.h"
#include "vision/prepare/document.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include <opencv2/core.hpp>

namespace touchline {
namespace {

constexpr std::int64_t photo_pixels = 2'000'000;  // more are averaged away
constexpr int preview_px = 640;

Picture picture_of(const cv::Mat& bgr) {
    Picture picture;
    picture.width = bgr.cols;
    picture.height = bgr.rows;
    const cv::Mat whole = bgr.isContinuous() ? bgr : bgr.clone();
    picture.bgr.assign(whole.data, whole.data + whole.total() * whole.elemSize());
    return picture;
}

/// The page that lies there, or the photograph where none does.
Result<cv::Mat> what_lies_there(const cv::Mat& photo) {
    Document document = document_in(photo);
    if (!document.page.empty()) return std::move(document.page);
    if (document.trouble == CaptureTrouble::no_page) return photo;
    return failure(std::string(sentence(document.trouble)));
}

/// Without what the operator cut off at the sides; a pixel stays at least.
cv::Mat cut_off(const cv::Mat& picture, const PhotoDesk::Cut& cut) {
    const auto share = [](double percent) {
        return percent >= 0.0 && percent <= 40.0 ? 0.01 * percent : 0.0;
    };
    const int left = cvRound(share(cut.left) * picture.cols);
    const int right = cvRound(share(cut.right) * picture.cols);
    const int top = cvRound(share(cut.top) * picture.rows);
    const int bottom = cvRound(share(cut.bottom) * picture.rows);
    return picture(cv::Rect(left, top, std::max(1, picture.cols - left - right),
                            std::max(1, picture.rows - top - bottom)));
}

Result<Page> page_of_photo(const CameraFrame& frame, const PhotoDesk::Cut& cut) {
    const auto photo = to_bgr(frame, quick_size(frame.size, photo_pixels));
    if (!photo) return tl::unexpected(photo.error());
    const auto seen = what_lies_there(cut_off(*photo, cut));
    if (!seen) return tl::unexpected(seen.error());
    Page page;
    page.picture = picture_of(*seen);
    const double ratio = static_cast<double>(page.picture.height) / page.picture.width;
    page.told.area.height_m = page.told.area.width_m * ratio;
    return page;
}

Result<cv::Mat> read_bgr(const std::filesystem::path& file) {
    auto picture = read_picture(file.string());
    if (!picture) return tl::unexpected(picture.error());
    return cv::Mat(picture->height, picture->width, CV_8UC3, picture->bgr.data()).clone();
}

}  // namespace

void PhotoDesk::show(bool is_wanted) {
    is_shown_ = is_wanted;
    if (!is_wanted) preview_.reset();
}

PhotoNews PhotoDesk::step(double now_s) {
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
        news.has_a_preview = true;
    }
    return news;
}

FilePtr file_of(CameraFrame frame, const PhotoDesk::Cut& cut) {
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
