#include "vision/prepare/stand.h"

#include "vision/prepare/capture_trouble.h"
#include "vision/prepare/fiducials.h"
#include "vision/prepare/rectify.h"

#include <string>

namespace touchline {

Result<StandSettings> calibrated_stand(const cv::Mat& bgr, cv::Size2d bed_mm) {
    const std::vector<Fiducial> marks = find_fiducials(bgr);
    Quad bed;
    // The corner of each mark that is nearest to the bed's middle.
    for (const Fiducial& mark : marks) {
        const auto id = static_cast<std::size_t>(mark.id);
        bed[id] = mark.corners[(id + 2) % 4];
    }
    if (marks.size() != fiducial_count || !is_sheet_like(bed))
        return failure(std::string(sentence(CaptureTrouble::no_markers)));
    StandSettings stand;
    stand.picture_width_px = bgr.cols;
    stand.picture_height_px = bgr.rows;
    for (std::size_t i = 0; i < 4; ++i) {
        stand.bed_corners_px[2 * i] = bed[i].x;
        stand.bed_corners_px[2 * i + 1] = bed[i].y;
    }
    stand.bed_width_mm = bed_mm.width;
    stand.bed_height_mm = bed_mm.height;
    return stand;
}

cv::Mat bed_picture(const cv::Mat& bgr, const StandSettings& stand, double most_pixels) {
    Quad bed;
    for (std::size_t i = 0; i < 4; ++i)
        bed[i] = {stand.bed_corners_px[2 * i], stand.bed_corners_px[2 * i + 1]};
    const cv::Size calibrated(stand.picture_width_px, stand.picture_height_px);
    return rectified(bgr, rescaled(bed, calibrated, bgr.size()),
                     stand.bed_width_mm / stand.bed_height_mm, most_pixels);
}

}  // namespace touchline
