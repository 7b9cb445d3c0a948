#include "app/trace/photo_page.h"

#include "vision/camera/conversion.h"
#include "vision/prepare/document.h"

#include <cstdint>
#include <string>
#include <utility>

namespace touchline {
namespace {

constexpr std::int64_t photo_pixels = 2'000'000;  // more are averaged away

/// The page that lies there, or the photograph where none does.
Result<cv::Mat> what_lies_there(const cv::Mat& photo) {
    Document document = document_in(photo);
    if (!document.page.empty()) return std::move(document.page);
    if (document.trouble == CaptureTrouble::no_page) return photo;
    return failure(std::string(sentence(document.trouble)));
}

}  // namespace

Result<Page> photo_page(const CameraFrame& frame, const PhotoCut& cut) {
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

}  // namespace touchline
