#include "app/screen/rendered_path.h"

namespace touchline {

std::vector<PixelPoint> rendered_path(const CurveSet& curves, int piece, double level,
                                      const View& view) {
    constexpr double least_px = 2.0;
    std::vector<PixelPoint> path;
    const int segments = curves.rendered_count(piece, level);
    for (int j = 0; j < segments; ++j) {
        const Segment segment = curves.rendered_segment(piece, level, j);
        if (path.empty()) path.push_back(view.to_px(segment.a));
        const PixelPoint end = view.to_px(segment.b);
        if (j + 1 == segments || norm(end - path.back()) >= least_px) path.push_back(end);
    }
    return path;
}

}  // namespace touchline
