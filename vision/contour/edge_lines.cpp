#include "vision/contour/edge_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchline {
namespace {

constexpr int no_crossing = -1;
constexpr double least_ring_px = 4.0;  // smaller rings are pixels at which the normal turns round

/// Slope and curvature of the strength along the edge normal at one pixel.
struct Profile {
    float slope = 0.0F;
    float curvature = 0.0F;
    cv::Vec2f normal;
};

/// Whether the strength rises along the normal. A slope of exactly 0 counts as one whose maximum
/// lies a hair to the right (or below): the same answer for either sign of the normal.
bool is_rising(float slope, const cv::Vec2f& normal) {
    return slope > 0.0F ||
           (slope == 0.0F && (normal[0] > 0.0F || (normal[0] == 0.0F && normal[1] > 0.0F)));
}

/// A point where a line crosses an edge of the pixel grid, with its neighbours on the line: at most
/// two, one through each cell at that grid edge.
struct Crossing {
    EdgePoint point;
    std::array<int, 2> next{no_crossing, no_crossing};
};

class LineTracer {
  public:
    LineTracer(const GradientField& field, const Hysteresis& limits)
        : field_(field), limits_(limits) {}

    std::vector<Chain> trace() {
        find_and_link();
        std::vector<Chain> chains;
        std::vector<bool> used(crossings_.size(), false);
        for (const bool ends_only : {true, false}) {  // open lines from their ends, then rings
            for (std::size_t i = 0; i < crossings_.size(); ++i) {
                const bool is_end = crossings_[i].next[1] == no_crossing;
                if (!used[i] && (is_end || !ends_only)) {
                    keep_if_strong(follow(static_cast<int>(i), used), chains);
                }
            }
        }
        return chains;
    }

  private:
    Profile profile(int x, int y) const {
        const cv::Mat1f& m = field_.strength;
        const int left = std::max(0, x - 1);
        const int right = std::min(m.cols - 1, x + 1);
        const float* above = m[std::max(0, y - 1)];
        const float* here = m[y];
        const float* below = m[std::min(m.rows - 1, y + 1)];
        const cv::Vec2f n = field_.normal(y, x);
        const float dx = 0.5F * (here[right] - here[left]);
        const float dy = 0.5F * (below[x] - above[x]);
        const float dxx = here[right] - 2.0F * here[x] + here[left];
        const float dyy = below[x] - 2.0F * here[x] + above[x];
        const float dxy = 0.25F * (below[right] - below[left] - above[right] + above[left]);
        return {n[0] * dx + n[1] * dy,
                n[0] * n[0] * dxx + 2.0F * n[0] * n[1] * dxy + n[1] * n[1] * dyy, n};
    }

    /// Returns the crossing on the grid edge from pixel a to pixel b, or no_crossing.
    int crossing_between(cv::Point a, cv::Point b) {
        const float strength_a = field_.strength(a);
        const float strength_b = field_.strength(b);
        const auto low = static_cast<float>(limits_.low);
        if (!(strength_a >= low) && !(strength_b >= low)) return no_crossing;
        const Profile at_a = profile(a.x, a.y);
        const Profile at_b = profile(b.x, b.y);
        const float sign = at_a.normal.dot(at_b.normal) < 0.0F ? -1.0F : 1.0F;
        const float slope_b = sign * at_b.slope;
        if (is_rising(at_a.slope, at_a.normal) == is_rising(slope_b, sign * at_b.normal)) {
            return no_crossing;
        }
        const float change = at_a.slope - slope_b;
        const float t = change != 0.0F ? at_a.slope / change : 0.5F;
        const float strength = strength_a + t * (strength_b - strength_a);
        const float curvature = at_a.curvature + t * (at_b.curvature - at_a.curvature);
        if (!(strength >= low) || !(curvature < 0.0F)) return no_crossing;
        const cv::Point2d where = cv::Point2d(a) + static_cast<double>(t) * cv::Point2d(b - a);
        const cv::Vec2f to_light = !field_.has_light_side    ? cv::Vec2f(0.0F, 0.0F)
                                   : strength_a > strength_b ? at_a.normal
                                                             : at_b.normal;
        crossings_.push_back(
            {{where, static_cast<double>(strength), false, to_light}, {no_crossing, no_crossing}});
        return static_cast<int>(crossings_.size()) - 1;
    }

    /// Goes row by row: crossings on the grid edges of a row of cells, then the links through its
    /// cells.
    void find_and_link() {
        const int cols = field_.strength.cols;
        const int rows = field_.strength.rows;
        std::vector<int> upper = row_crossings(0);
        for (int y = 0; y + 1 < rows; ++y) {
            std::vector<int> lower = row_crossings(y + 1);
            int left = crossing_between({0, y}, {0, y + 1});
            for (int x = 0; x + 1 < cols; ++x) {
                const int right = crossing_between({x + 1, y}, {x + 1, y + 1});
                const auto i = static_cast<std::size_t>(x);
                link_through_cell({upper[i], right, lower[i], left});
                left = right;
            }
            upper = std::move(lower);
        }
    }

    std::vector<int> row_crossings(int y) {
        std::vector<int> ids(static_cast<std::size_t>(field_.strength.cols), no_crossing);
        for (int x = 0; x + 1 < field_.strength.cols; ++x) {
            ids[static_cast<std::size_t>(x)] = crossing_between({x, y}, {x + 1, y});
        }
        return ids;
    }

    /// Two crossings of a cell are one line. Of three or four, the closest two are joined first,
    /// then the rest; a third stays an end.
    void link_through_cell(const std::array<int, 4>& sides) {
        std::array<int, 4> ids{};
        std::size_t count = 0;
        for (const int id : sides) {
            if (id != no_crossing) ids[count++] = id;
        }
        while (count >= 2) {
            std::size_t best_i = 0;
            std::size_t best_j = 1;
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t j = i + 1; j < count; ++j) {
                    if (gap(ids[i], ids[j]) < gap(ids[best_i], ids[best_j])) {
                        best_i = i;
                        best_j = j;
                    }
                }
            }
            link(ids[best_i], ids[best_j]);
            ids[best_j] = ids[--count];
            ids[best_i] = ids[--count];
        }
    }

    double gap(int i, int j) const { return distance(crossing(i).point.at, crossing(j).point.at); }

    void link(int i, int j) {
        add_neighbour(crossings_[static_cast<std::size_t>(i)], j);
        add_neighbour(crossings_[static_cast<std::size_t>(j)], i);
    }

    static void add_neighbour(Crossing& c, int id) {
        c.next[c.next[0] == no_crossing ? 0 : 1] = id;
    }

    const Crossing& crossing(int id) const { return crossings_[static_cast<std::size_t>(id)]; }

    /// Follows the line from a crossing until it ends or comes round.
    Chain follow(int start, std::vector<bool>& used) const {
        Chain chain;
        int previous = no_crossing;
        int id = start;
        while (id != no_crossing && !used[static_cast<std::size_t>(id)]) {
            used[static_cast<std::size_t>(id)] = true;
            chain.points.push_back(crossing(id).point);
            const std::array<int, 2>& next = crossing(id).next;
            const int ahead = next[0] != previous ? next[0] : next[1];
            previous = id;
            id = ahead;
        }
        chain.is_closed = id == start && chain.points.size() > 2;
        return chain;
    }

    void keep_if_strong(Chain chain, std::vector<Chain>& chains) const {
        const auto is_strong = [&](const EdgePoint& p) { return p.strength >= limits_.high; };
        const bool is_dot = chain.is_closed && length_of(chain) < least_ring_px;
        if (chain.points.size() >= 2 && !is_dot && std::ranges::any_of(chain.points, is_strong)) {
            chains.push_back(std::move(chain));
        }
    }

    const GradientField& field_;
    Hysteresis limits_;
    std::vector<Crossing> crossings_;
};

constexpr double finest_sigma_px = 1.0;    // below it, the pixel grid shows in the slopes
constexpr double photo_sigma_px = 2.5;     // best of 1, 1.4, 2, 2.5, 2.8, 4 on photos
constexpr double drawing = 0.20;           // at most this part of the picture changes: a drawing
constexpr double least_photo_part = 0.40;  // at least this part: a photo
// The gradient that 8-bit rounding and compression leave, per pixel.
constexpr double rounding_gradient = 0.3;
constexpr double significance = 6.0;         // x gradient noise: 2e-8 of the pixels of pure noise
constexpr double median_over_sigma = 1.177;  // of a Rayleigh distribution: the gradient of noise
constexpr double mostly_noise = 2.5;  // measured over predicted gradient noise; photos 5 and more
constexpr double high_over_quantile = 3.0;  // binds in drawings, which have only strong edges
constexpr double grain_over_quantile = 2.0;
constexpr double high_over_strongest = 0.45;  // F .613 on photos; .609 at 0.5, .606 at 0.6
constexpr double low_over_high = 0.4;

/// Returns the share of the pixels whose lightness differs across them by more than noise and
/// rounding explain. Unsmoothed, because close lines of a drawing leave flat pixels between them,
/// and the texture of a photo does not.
double changing_part(const LabPicture& lab, double noise) {
    const double limit = std::max(2.0 * rounding_gradient, 3.0 * noise / std::numbers::sqrt2);
    const auto limit_squared = static_cast<float>(4.0 * limit * limit);
    std::size_t changing = 0;
    for (int y = 1; y + 1 < lab.rows; ++y) {
        for (int x = 1; x + 1 < lab.cols; ++x) {
            const float dx = lab(y, x + 1)[0] - lab(y, x - 1)[0];
            const float dy = lab(y + 1, x)[0] - lab(y - 1, x)[0];
            changing += dx * dx + dy * dy > limit_squared ? 1 : 0;
        }
    }
    return static_cast<double>(changing) / static_cast<double>(lab.total());
}

double quantile_of(const GradientField& field, double fraction) {
    return static_cast<double>(quantile(field.strength, fraction));
}

Hysteresis hysteresis(double high) {
    return {low_over_high * high, high};
}

constexpr std::size_t reach_points = 28;  // points: 20 pixels at 1.4 crossings of the grid a pixel
constexpr double extent_px = 30.0;

}  // namespace

std::vector<Chain> edge_lines(const GradientField& field, const Hysteresis& limits) {
    return LineTracer(field, limits).trace();
}

double smoothing_for(const LabPicture& lab, double noise) {
    // The smallest sigma that brings the gradient's noise down to one grey level a pixel.
    const double fine_px =
        std::clamp(finest_sigma_px * std::sqrt(gradient_noise(noise, finest_sigma_px)),
                   finest_sigma_px, photo_sigma_px);
    const double part = changing_part(lab, noise);
    const double photo = std::clamp((part - drawing) / (least_photo_part - drawing), 0.0, 1.0);
    return fine_px + photo * (photo_sigma_px - fine_px);
}

Hysteresis thresholds_for(const GradientField& field, double noise, double sigma_px) {
    const double median = quantile_of(field, 0.5);
    const double predicted = gradient_noise(noise, sigma_px);
    const double measured = median / median_over_sigma;
    // If most of the gradient is noise, the gradient itself measures it best.
    const double floor =
        significance *
        (measured < mostly_noise * predicted ? std::max(predicted, measured) : predicted);
    const double crowd = std::min(high_over_quantile * quantile_of(field, 0.75),
                                  high_over_strongest * quantile_of(field, 0.98));
    return hysteresis(std::max({crowd, floor, 4.0 * rounding_gradient}));
}

Hysteresis grain_thresholds(const GradientField& field) {
    return hysteresis(
        std::max(grain_over_quantile * quantile_of(field, 0.75), 4.0 * rounding_gradient));
}

cv::Mat edge_strength(const std::vector<Chain>& lines, cv::Size size, double high) {
    cv::Mat1b picture(size, uchar{0});
    for (const Chain& line : lines) {
        const std::size_t n = line.points.size();
        const double extent = 1.0 - std::exp(-length_of(line) / extent_px);
        std::vector<double> sum(n + 1, 0.0);
        for (std::size_t i = 0; i < n; ++i) sum[i + 1] = sum[i] + line.points[i].strength;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t from = i > reach_points ? i - reach_points : 0;
            const std::size_t to = std::min(n, i + reach_points + 1);
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
