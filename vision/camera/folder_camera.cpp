#include "vision/camera/folder_camera.h"

#include "vision/camera/frame.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double look_every_s = 1.0;

CameraFrame frame_of(const cv::Mat& bgr) {
    CameraFrame frame{
        PixelFormat::bgr, bgr.size(), std::size_t{3} * static_cast<std::size_t>(bgr.cols), {}};
    for (int y = 0; y < bgr.rows; ++y)
        frame.bytes.insert(frame.bytes.end(), bgr.ptr(y), bgr.ptr(y) + frame.stride_bytes);
    return frame;
}

}  // namespace

FolderCamera::FolderCamera(std::filesystem::path folder, ReadPicture read)
    : folder_(std::move(folder)), read_(std::move(read)) {}

std::vector<CameraName> FolderCamera::list() {
    look_into_folder();
    if (files_.empty()) return {};
    return {{folder_.string(), "the pictures of " + folder_.filename().string()}};
}

std::optional<CameraAbilities> FolderCamera::abilities() const {
    if (picture_.empty()) return std::nullopt;
    return CameraAbilities{{{PixelFormat::bgr, picture_.size()}}, false, false, false};
}

/// A missing or unreadable folder is a camera that is not plugged in.
void FolderCamera::look_into_folder() {
    files_.clear();
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder_, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file(error)) files_.push_back(entry->path());
    std::sort(files_.begin(), files_.end());
}

/// Loads the next readable file by name, round and round. Returns false if there is none.
bool FolderCamera::load_next() {
    const auto after = std::upper_bound(files_.begin(), files_.end(), last_);
    std::rotate(files_.begin(), after, files_.end());
    const auto readable = std::find_if(files_.begin(), files_.end(), [&](const auto& file) {
        auto picture = read_(file);
        if (!picture || picture->empty() || picture->type() != CV_8UC3) return false;
        picture_ = std::move(*picture);
        last_ = file;
        return true;
    });
    is_new_ = readable != files_.end();
    if (!is_new_) picture_.release();
    std::sort(files_.begin(), files_.end());
    return is_new_;
}

CameraView FolderCamera::step(double now_s) {
    CameraView view;
    const bool is_chosen = wanted_id_.empty() || wanted_id_ == folder_.string();
    if (!looked_s_ || now_s - *looked_s_ >= look_every_s) {
        looked_s_ = now_s;
        look_into_folder();
        const bool is_there = std::binary_search(files_.begin(), files_.end(), last_);
        if (!is_there || picture_.empty()) (void)load_next();
    }
    const bool is_wanted = std::exchange(is_still_wanted_, false);
    if (!is_chosen || picture_.empty()) {
        view.has_given_up = is_wanted;
        return view;
    }
    view.condition = CameraCondition::ready;
    if (std::exchange(is_new_, false)) {
        cv::Mat preview;
        cv::resize(picture_, preview, reduced_size(picture_.size(), preview_pixels), 0, 0,
                   cv::INTER_AREA);
        view.preview = preview;
    }
    if (is_wanted) {
        view.still = Still{frame_of(picture_), measure_quality(picture_), false, false};
        (void)load_next();
    }
    return view;
}

}  // namespace touchline
