#include "vision/contour/edge_strength.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr std::size_t kReach = 28;  // points: 20 pixels at 1.4 crossings of the grid a pixel
constexpr double kExtent_px = 30.0;

}  // namespace

cv::Mat edge_strength(const std::vector<Chain>& lines, cv::Size size, double high) {
    cv::Mat1b picture(size, uchar{0});
    for (const Chain& line : lines) {
        const std::size_t n = line.points.size();
        const double extent = 1.0 - std::exp(-length_of(line) / kExtent_px);
        std::vector<double> sum(n + 1, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            sum[i + 1] = sum[i] + line.points[i].strength;
        }
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t from = i > kReach ? i - kReach : 0;
            const std::size_t to = std::min(n, i + kReach + 1);
            const double r = (sum[to] - sum[from]) / static_cast<double>(to - from) / high * extent;
            const cv::Point at(line.points[i].at);  // on the frame: beside the last pixel
            uchar& pixel =
                picture(std::clamp(at.y, 0, size.height - 1), std::clamp(at.x, 0, size.width - 1));
            pixel = std::max(pixel, cv::saturate_cast<uchar>(255.0 * r / (1.0 + r)));
        }
    }
    return picture;
}

}  // namespace touchline
