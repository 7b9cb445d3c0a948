#include "vision/contour/ink_parts.h"
#include "vision/contour/region_map.h"
#include "vision/prepare/paper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int darkest_within_px = 9;    // where a mark's own darkest point is looked for
constexpr double of_its_darkest = 0.4;  // half is lost if a hair lies between two pixels
constexpr int mixed_px = 3;             // from a border: mixtures of both colours
constexpr double most_uneven = 0.2;     // of an area's pixels; with more it is not a flat colour
constexpr int just_outside_px = 2;
constexpr double faded_out = 0.4;     // of the contrast within: this little just outside of a mark
constexpr double mostly_crisp = 0.6;  // of what is just outside
constexpr int least_pixels = 8;       // fewer are a speck
constexpr double longer_than_dash = 2.3;  // of the greatest width: longer than a dash

cv::Mat square(int half_px) {
    return cv::Mat::ones(2 * half_px + 1, 2 * half_px + 1, CV_8U);
}

cv::Mat1f contrast_to(const LabPicture& lab, const Areas& areas) {
    cv::Mat1f contrast(lab.size());
    for (int y = 0; y < lab.rows; ++y)
        for (int x = 0; x < lab.cols; ++x) {
            const cv::Vec3f d = lab(y, x) - areas.palette[areas.map(y, x)];
            contrast(y, x) = std::sqrt(d.dot(d));
        }
    return contrast;
}

/// Returns the pixels near which another area begins.
cv::Mat1b near_borders(const cv::Mat1b& map, int within_px) {
    cv::Mat1b low;
    cv::Mat1b high;
    cv::erode(map, low, square(within_px));
    cv::dilate(map, high, square(within_px));
    return cv::Mat(low != high);
}

/// Returns the pixels of areas that have a single colour, except for a few pixels.
cv::Mat1b on_even_areas(const cv::Mat1b& map, const cv::Mat1b& differs) {
    std::array<int, most_colours> all{};
    std::array<int, most_colours> uneven{};
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.cols; ++x) {
            ++all[map(y, x)];
            uneven[map(y, x)] += differs(y, x) != 0 ? 1 : 0;
        }
    cv::Mat1b even(map.size());
    std::ranges::transform(map, even.begin(), [&](uchar colour) {
        return static_cast<double>(uneven[colour]) <= most_uneven * all[colour] ? uchar{255}
                                                                                : uchar{0};
    });
    return even;
}

/// The measurements of a piece of ink.
struct PieceOfInk {
    cv::Point low{1 << 30, 1 << 30};
    cv::Point high{-1, -1};
    int pixels = 0;
    float deepest_px = 0.0F;  // half its greatest width
    bool has_stroke = false;
    int beside = 0;  // pixels just outside
    int crisp = 0;   // of these, where the picture looks as if the piece were not there

    [[nodiscard]] bool is_mark(double greatest_width_px) const {
        return pixels >= least_pixels &&
               2.0F * deepest_px <= static_cast<float>(greatest_width_px) &&
               crisp >= mostly_crisp * beside;
    }

    [[nodiscard]] double extent_px() const { return cv::norm(high - low); }
};

class Finder {
  public:
    Finder(const cv::Mat1f& contrast, const cv::Mat1b& mask, double greatest_width_px)
        : contrast_(contrast),
          depth_px_(depth_of(mask)),
          pieces_(static_cast<std::size_t>(cv::connectedComponents(mask, piece_, 8, CV_32S))),
          greatest_width_px_(greatest_width_px) {}

    FineMarks found(const cv::Mat1b& strokes, const cv::Mat1f& strongest_around,
                    const cv::Mat1b& mixed) {
        measure(strokes);
        measure_outside(strongest_around, mixed);
        FineMarks marks{cv::Mat1b(contrast_.size(), uchar{0}),
                        cv::Mat1b(contrast_.size(), uchar{0}), contrast_};
        for (int y = 0; y < contrast_.rows; ++y)
            for (int x = 0; x < contrast_.cols; ++x) {
                const int number = piece_(y, x);
                const PieceOfInk& piece = pieces_[static_cast<std::size_t>(number)];
                if (number == 0 || !piece.is_mark(greatest_width_px_)) continue;
                const bool is_line =
                    piece.has_stroke || piece.extent_px() >= longer_than_dash * greatest_width_px_;
                (is_line ? marks.lines : marks.bits)(y, x) = 255;
            }
        return marks;
    }

  private:
    void measure(const cv::Mat1b& strokes) {
        for (int y = 0; y < contrast_.rows; ++y)
            for (int x = 0; x < contrast_.cols; ++x) {
                PieceOfInk& piece = pieces_[static_cast<std::size_t>(piece_(y, x))];
                piece.low = {std::min(piece.low.x, x), std::min(piece.low.y, y)};
                piece.high = {std::max(piece.high.x, x), std::max(piece.high.y, y)};
                ++piece.pixels;
                piece.deepest_px = std::max(piece.deepest_px, depth_px_(y, x));
                piece.has_stroke = piece.has_stroke || strokes(y, x) != 0;
            }
    }

    /// A shadow goes on outside, or up to what casts it; a mark ends.
    void measure_outside(const cv::Mat1f& strongest_around, const cv::Mat1b& mixed) {
        cv::Mat1f apart;
        cv::Mat1i nearest;
        const cv::Mat1b outside = cv::Mat(piece_ == 0);
        cv::distanceTransform(outside, apart, nearest, cv::DIST_L2, cv::DIST_MASK_5,
                              cv::DIST_LABEL_PIXEL);
        std::vector<int> piece_of(contrast_.total() + 1, 0);
        for (int y = 0; y < contrast_.rows; ++y)
            for (int x = 0; x < contrast_.cols; ++x)
                if (piece_(y, x) != 0)
                    piece_of[static_cast<std::size_t>(nearest(y, x))] = piece_(y, x);
        for (int y = 0; y < contrast_.rows; ++y)
            for (int x = 0; x < contrast_.cols; ++x) {
                if (apart(y, x) < just_outside_px || apart(y, x) >= just_outside_px + 1) continue;
                const int number = piece_of[static_cast<std::size_t>(nearest(y, x))];
                PieceOfInk& piece = pieces_[static_cast<std::size_t>(number)];
                ++piece.beside;
                const auto within = static_cast<double>(strongest_around(y, x));
                const bool is_crisp =
                    mixed(y, x) == 0 && static_cast<double>(contrast_(y, x)) <= faded_out * within;
                piece.crisp += is_crisp ? 1 : 0;
            }
    }

    const cv::Mat1f& contrast_;
    cv::Mat1f depth_px_;
    cv::Mat1i piece_;  // from 1; declared before what counts them
    std::vector<PieceOfInk> pieces_;
    double greatest_width_px_;
};

}  // namespace

FineMarks fine_marks(const LabPicture& lab, const Areas& areas, const cv::Mat1b& strokes,
                     double noise, double smoothing_px, double greatest_width_px) {
    // A picture that no camera saw has no dirt.
    const double floor = least_contrast(
        noise, noise < no_grain ? 0.0 : strongest_contrast(areas.palette, ground_of(areas.map)));
    cv::Mat1f contrast = contrast_to(lab, areas);
    const cv::Mat1b mixed = near_borders(areas.map, mixed_px + cvCeil(2.0 * smoothing_px));
    contrast.setTo(0.0, mixed);
    cv::Mat1f around;
    cv::dilate(contrast, around, cv::Mat::ones(darkest_within_px, darkest_within_px, CV_8U));
    cv::Mat1b mask = cv::Mat(contrast >= cv::max(of_its_darkest * around, floor));
    mask &= on_even_areas(areas.map, cv::Mat(mask & ~strokes));
    cv::Mat known;  // with its soft edge
    cv::dilate(strokes, known, square(1));
    if (cv::countNonZero(mask & ~known) == 0) {
        const cv::Mat1b none(lab.size(), uchar{0});
        return {none, none, contrast};
    }
    mask |= strokes;
    return Finder(contrast, mask, greatest_width_px).found(strokes, around, mixed);
}

}  // namespace touchline
