#include "config/types/angle.h"
#include "vision/contour/ink_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double least_pale = 0.0005;    // of the picture: less is no grid
constexpr double straight_share = 0.03;  // of the picture's diagonal: length that identifies a line
constexpr double most_tilt_deg = 3.0;
constexpr double tilt_step_deg = 0.25;
constexpr double long_enough = 0.25;  // of the longest line; others may be broken by marks on them
constexpr std::size_t least_lines = 3;
constexpr double gap_spread = 0.2;         // of the spacing
constexpr double mostly_multiple = 0.7;    // of the gaps
constexpr double on_spacing_share = 0.05;  // of the spacing: how near to it a broken line must lie
constexpr double mostly_grid = 0.55;       // of everything that is as pale
constexpr int remains_within_px = 2;       // beside a line, where remains of it may be

/// Places across lines of one direction, tilted by an angle: x cos - y sin, for example.
struct Bundle {
    bool is_level = true;
    double tilt = 0.0;  // of y per x, or x per y

    [[nodiscard]] double place_of(const cv::Point& p) const {
        return is_level ? p.y - tilt * p.x : p.x + tilt * p.y;
    }
};

struct Band {
    double from = 0.0;
    double to = 0.0;
    int pixels = 0;

    [[nodiscard]] double middle() const { return 0.5 * (from + to); }
};

class Counts {
  public:
    Counts(const std::vector<cv::Point>& points, const Bundle& bundle, cv::Size size)
        : low_(static_cast<int>(-0.1 * (size.width + size.height))),
          counts_(static_cast<std::size_t>(1.2 * (size.width + size.height)), 0) {
        for (const cv::Point& p : points) {
            ++counts_[static_cast<std::size_t>(std::lround(bundle.place_of(p)) - low_)];
        }
    }

    [[nodiscard]] double sharpness() const {
        double sum = 0.0;
        for (const int n : counts_) sum += static_cast<double>(n) * n;
        return sum;
    }

    [[nodiscard]] int most() const { return *std::ranges::max_element(counts_); }

    /// Returns the stretches of places that hold more pixels than `few`.
    [[nodiscard]] std::vector<Band> bands(double few) const {
        std::vector<Band> bands;
        for (std::size_t i = 0; i < counts_.size();) {
            Band band{static_cast<double>(i) + low_, 0.0, 0};
            for (; i < counts_.size() && counts_[i] > few; ++i) {
                band.pixels += counts_[i];
                band.to = static_cast<double>(i) + low_;
            }
            if (band.pixels > 0) {
                bands.push_back(band);
            } else {
                ++i;
            }
        }
        return bands;
    }

  private:
    int low_;
    std::vector<int> counts_;
};

Bundle best_tilted(const std::vector<cv::Point>& points, bool is_level, cv::Size size) {
    Bundle best{is_level, 0.0};
    double sharpest = 0.0;
    for (double deg = -most_tilt_deg; deg <= most_tilt_deg; deg += tilt_step_deg) {
        const Bundle bundle{is_level, std::tan(radians(deg))};
        const double sharpness = Counts(points, bundle, size).sharpness();
        if (sharpness > sharpest) {
            sharpest = sharpness;
            best = bundle;
        }
    }
    return best;
}

std::vector<double> gaps_of(const std::vector<Band>& bands) {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < bands.size(); ++i) {
        gaps.push_back(bands[i].middle() - bands[i - 1].middle());
    }
    return gaps;
}

bool is_multiple(double gap, double spacing, double tolerance) {
    return std::abs(gap / spacing - std::round(gap / spacing)) <= tolerance;
}

/// Returns whether each gap is close enough to a multiple of the smallest.
bool are_even(const std::vector<double>& gaps) {
    const double least = *std::ranges::min_element(gaps);
    const auto even = std::ranges::count_if(
        gaps, [&](double gap) { return is_multiple(gap, least, gap_spread); });
    return static_cast<double>(even) >= mostly_multiple * static_cast<double>(gaps.size());
}

/// Returns the straight pieces that lie as far from the nearest line as lines do from each other,
/// or a multiple of that: between high bars, little of a line can be seen, and yet it is one of
/// them.
std::vector<Band> on_spacing(const std::vector<Band>& all, const std::vector<Band>& lines) {
    const double spacing = std::ranges::min(gaps_of(lines));
    std::vector<Band> found;
    std::ranges::copy_if(all, std::back_inserter(found), [&](const Band& one) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Band& line : lines) {
            nearest = std::min(nearest, std::abs(one.middle() - line.middle()));
        }
        return nearest > 0.5 * spacing && is_multiple(nearest, spacing, on_spacing_share);
    });
    return found;
}

/// Returns the part of the pale strokes that lies on evenly spaced lines of one direction.
cv::Mat1b on_even_lines(const cv::Mat1b& pale, bool is_level, double greatest_width_px) {
    cv::Mat1b found(pale.size(), uchar{0});
    const int length = static_cast<int>(straight_share * std::hypot(pale.cols, pale.rows));
    cv::Mat1b straight;
    cv::morphologyEx(pale, straight, cv::MORPH_OPEN,
                     cv::Mat::ones(is_level ? cv::Size(length, 1) : cv::Size(1, length), CV_8U));
    std::vector<cv::Point> points;
    cv::findNonZero(straight, points);
    if (points.empty()) return found;
    const Bundle bundle = best_tilted(points, is_level, pale.size());
    const Counts counts(points, bundle, pale.size());
    std::vector<Band> bands = counts.bands(long_enough * counts.most());
    const auto is_thin = [&](const Band& band) { return band.to - band.from < greatest_width_px; };
    if (bands.size() < least_lines || !std::ranges::all_of(bands, is_thin) ||
        !are_even(gaps_of(bands))) {
        return found;
    }
    std::ranges::copy_if(on_spacing(counts.bands(0.0), bands), std::back_inserter(bands), is_thin);
    std::vector<cv::Point> all;
    cv::findNonZero(pale, all);
    for (const cv::Point& p : all) {
        const double place = bundle.place_of(p);
        found(p) = std::ranges::any_of(bands,
                                       [&](const Band& band) {
                                           return place >= band.from - remains_within_px &&
                                                  place <= band.to + remains_within_px;
                                       })
                       ? 255
                       : 0;
    }
    return found;
}

}  // namespace

cv::Mat1b grid_of(const cv::Mat1b& pale, double greatest_width_px) {
    const int pixels = cv::countNonZero(pale);
    if (pixels < least_pale * static_cast<double>(pale.total())) return {};
    const cv::Mat1b grid(on_even_lines(pale, true, greatest_width_px) |
                         on_even_lines(pale, false, greatest_width_px));
    return cv::countNonZero(grid) >= mostly_grid * pixels ? grid : cv::Mat1b();
}

}  // namespace touchline
