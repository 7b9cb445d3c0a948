#include "vision/prepare/document.h"

#include "vision/prepare/even_light.h"
#include "vision/prepare/page_search.h"
#include "vision/prepare/rectify.h"

#include <algorithm>

namespace touchline {
namespace {

PaperFormat format_of(double aspect) {
    const double upright = std::min(aspect, 1.0 / aspect);
    if (upright == 1.0 / a4_aspect) return PaperFormat::a4;
    return upright == 1.0 / letter_aspect ? PaperFormat::letter : PaperFormat::other;
}

}  // namespace

Document document_in(const cv::Mat& bgr) {
    const PageSearch search = find_page(bgr);
    if (!search.corners) return {{}, PaperFormat::other, search.trouble};
    const double aspect = snapped_aspect(aspect_of(*search.corners, bgr.size()));
    return {evenly_lit(rectified(bgr, *search.corners, aspect)), format_of(aspect),
            CaptureTrouble::none};
}

}  // namespace touchline
