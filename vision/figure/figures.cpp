#include "vision/figure/figures.h"

#include "vision/contour/chain.h"
#include "vision/contour/gradient.h"
#include "vision/contour/ink_parts.h"
#include "vision/contour/rings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double mask_pixels = 1e6;
constexpr uchar limit = 128;  // of a mask
// Likelihood: measured, tests/lab/bench/vision/photographs.md.
constexpr float figure_likelihood = 0.3F;
constexpr double least_part = 0.05;   // of all figures
constexpr double least_area = 0.002;  // of the picture
constexpr double least_hole = 0.004;  // of the picture
constexpr double beside = 0.05;       // of a part: this near to a thing, a hand means it
constexpr double ground_share = 0.8;  // of a part

cv::Size mask_size(cv::Size picture) {
    const double pixels = static_cast<double>(picture.width) * picture.height;
    const double scale = std::min(1.0, std::sqrt(mask_pixels / pixels));
    return {std::max(1, cvRound(scale * picture.width)),
            std::max(1, cvRound(scale * picture.height))};
}

/// Connected pieces of a mask, without the background.
struct Pieces {
    explicit Pieces(const cv::Mat& mask) {
        cv::Mat1d centres;
        count = cv::connectedComponentsWithStats(mask, number, stats, centres, 8, CV_32S);
    }

    [[nodiscard]] int area(int piece) const { return stats(piece, cv::CC_STAT_AREA); }

    [[nodiscard]] cv::Rect box(int piece) const {
        return {stats(piece, cv::CC_STAT_LEFT), stats(piece, cv::CC_STAT_TOP),
                stats(piece, cv::CC_STAT_WIDTH), stats(piece, cv::CC_STAT_HEIGHT)};
    }

    cv::Mat1i number;
    cv::Mat1i stats;
    int count = 0;
};

/// Converts a soft likelihood to a mask with the limit at 128.
cv::Mat1b soft_mask(const cv::Mat1f& likelihood) {
    cv::Mat1b mask(likelihood.size());
    std::ranges::transform(likelihood, mask.begin(), [](float value) {
        const float below = 127.0F * value / figure_likelihood;
        const float above =
            128.0F + 127.0F * (value - figure_likelihood) / (1.0F - figure_likelihood);
        return static_cast<uchar>(value < figure_likelihood ? below : std::min(255.0F, above));
    });
    return mask;
}

bool touches_frame(const cv::Rect& box, cv::Size size) {
    return box.x == 0 || box.y == 0 || box.br().x == size.width || box.br().y == size.height;
}

/// Returns whether a box reaches a side of a part that is not the picture's own frame.
bool is_cut(const cv::Rect& box, const cv::Rect& part, cv::Size size) {
    return (box.x == part.x && part.x > 0) || (box.y == part.y && part.y > 0) ||
           (box.br().x == part.br().x && part.br().x < size.width) ||
           (box.br().y == part.br().y && part.br().y < size.height);
}

/// Moves the pieces that `is_out` selects to the other side of the limit, all of their pixels to
/// `value`.
template <class IsOut>
void change(const Pieces& pieces, uchar value, IsOut is_out, cv::Mat1b& mask) {
    std::vector<bool> goes(static_cast<std::size_t>(pieces.count), false);
    for (int piece = 1; piece < pieces.count; ++piece) {
        goes[static_cast<std::size_t>(piece)] = is_out(piece);
    }
    std::ranges::transform(pieces.number, mask, mask.begin(), [&](int piece, uchar before) {
        return goes[static_cast<std::size_t>(piece)] ? value : before;
    });
}

/// Removes parts that are too small to be a thing, and fills small holes.
void clean(cv::Mat1b& mask) {
    const auto pixels = static_cast<double>(mask.total());
    const cv::Mat is_figure = mask >= limit;
    const double least_px = std::max(least_part * cv::countNonZero(is_figure), least_area * pixels);
    const Pieces parts(is_figure);
    change(
        parts, limit - 1, [&](int part) { return parts.area(part) < least_px; }, mask);
    const Pieces holes(mask < limit);
    change(
        holes, limit,
        [&](int hole) {
            return holes.area(hole) < least_hole * pixels &&
                   !touches_frame(holes.box(hole), mask.size());
        },
        mask);
}

std::vector<cv::Rect> boxes_of(const cv::Mat1b& mask) {
    const Pieces parts(mask >= limit);
    std::vector<int> order;
    for (int part = 1; part < parts.count; ++part) order.push_back(part);
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](int part) { return parts.area(part); });
    std::vector<cv::Rect> boxes;
    std::ranges::transform(order, std::back_inserter(boxes),
                           [&](int part) { return parts.box(part); });
    return boxes;
}

/// Returns 0 if none is that near.
int nearest_piece(const Pieces& pieces, cv::Point at, double reach_px) {
    int nearest = 0;
    double least_px = reach_px;
    for (int y = 0; y < pieces.number.rows; ++y) {
        for (int x = 0; x < pieces.number.cols; ++x) {
            const double away_px = std::hypot(x - at.x, y - at.y);
            if (pieces.number(y, x) != 0 && away_px <= least_px) {
                nearest = pieces.number(y, x);
                least_px = away_px;
            }
        }
    }
    return nearest;
}

/// Returns the part of a mask a little inside its edge; all of anything thinner.
cv::Mat along_edge(const cv::Mat& mask) {
    constexpr double nearest_share = 0.013;  // of the picture's side
    constexpr double farthest = 0.039;
    const cv::Mat1f depth_px = depth_of(mask);
    cv::Mat along = (depth_px > nearest_share * mask.cols) & (depth_px <= farthest * mask.cols);
    return cv::countNonZero(along) > 0 ? along : mask;
}

double contrast_of(const cv::Mat1f& likelihood) {
    const cv::Mat figure = likelihood > figure_likelihood;
    if (cv::countNonZero(figure) == 0) return 0.0;
    const cv::Mat ground = ~figure;
    if (cv::countNonZero(ground) == 0) return 0.0;
    return cv::mean(likelihood, along_edge(figure))[0] -
           cv::mean(likelihood, along_edge(ground))[0];
}

/// Derived from pictures that somebody looked at, and which of their masks show a thing.
bool is_sure_of(const FigureSigns& signs) {
    constexpr double least_sure_contrast = 0.67;
    constexpr double least_seen = 0.003;
    return signs.contrast >= least_sure_contrast && signs.area >= least_seen;
}

constexpr float figure_level = 127.5F;
constexpr double reach_mm = 1.0;  // the edge of a thing may lie off its mask
constexpr double smoothing_px = 1.5;

/// Returns the mask at the lines' size, with edges as smooth as the picture's.
cv::Mat1f fitted(const cv::Mat1b& mask, cv::Size size) {
    cv::Mat1f soft;
    mask.convertTo(soft, CV_32F);
    cv::resize(soft, soft, size, 0.0, 0.0,
               mask.cols > size.width ? cv::INTER_AREA : cv::INTER_LINEAR);
    cv::GaussianBlur(soft, soft, cv::Size(), 1.0);
    return soft;
}

std::vector<Chain> rings_of(const cv::Mat1f& soft, const cv::Mat1f& strength, double reach_px,
                            double shortest_px, double high) {
    std::vector<Chain> rings;
    for (const Chain& line : iso_rings(soft, figure_level)) {
        if (length_of(line) < shortest_px) continue;
        Chain ring = resampled(line, 1.0);
        snap(ring, strength, reach_px);
        ring = resampled(ring, 1.0);
        ring.of = LineOf::ring;
        for (EdgePoint& p : ring.points) {
            p.strength = std::max(high, static_cast<double>(strength_at(strength, p.at)));
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

/// Returns the distance of each pixel to the nearest ring.
cv::Mat1f to_rings(const std::vector<Chain>& rings, cv::Size size) {
    cv::Mat1b free(size, uchar{255});
    for (const Chain& ring : rings) {
        std::vector<cv::Point> points;
        for (const EdgePoint& p : ring.points) {
            points.emplace_back(cvRound(p.at.x), cvRound(p.at.y));
        }
        cv::polylines(free, points, ring.is_closed, cv::Scalar(0));
    }
    return depth_of(free);
}

enum class RingSide { on_ring, inside, outside };

/// Returns the rings without the parts along the picture's frame: a thing cut by the frame has no
/// edge there.
std::vector<Chain> off_frame(const std::vector<Chain>& rings, cv::Size size, double shortest_px) {
    std::vector<Chain> lines;
    for (const Chain& ring : rings) {
        cut_by_place(
            ring, [&](const EdgePoint& p) { return is_on_frame(p.at, size); },
            [&](Chain part, bool is_frame) {
                if (!is_frame && length_of(part) >= shortest_px) lines.push_back(std::move(part));
            });
    }
    return lines;
}

}  // namespace

Figures figures_of(const cv::Mat1f& likelihood, cv::Size picture) {
    cv::Mat1f fitted;
    cv::resize(likelihood, fitted, mask_size(picture), 0.0, 0.0, cv::INTER_LINEAR);
    Figures figures;
    figures.mask = soft_mask(fitted);
    clean(figures.mask);
    figures.boxes = boxes_of(figures.mask);
    figures.signs = {
        cv::countNonZero(figures.mask >= limit) / static_cast<double>(figures.mask.total()),
        contrast_of(likelihood)};
    figures.is_sure = !figures.boxes.empty() && is_sure_of(figures.signs);
    return figures;
}

cv::Rect part_around(cv::Size picture, cv::Point place, double share) {
    const int longer_px = std::max(picture.width, picture.height);
    const int side_px = std::max(1, cvRound(share * longer_px));
    const cv::Size size(std::min(side_px, picture.width), std::min(side_px, picture.height));
    return {{std::clamp(place.x - size.width / 2, 0, picture.width - size.width),
             std::clamp(place.y - size.height / 2, 0, picture.height - size.height)},
            size};
}

Figures figure_at(const cv::Mat1f& likelihood, const cv::Rect& part, cv::Size picture,
                  cv::Point place) {
    Figures seen = figures_of(likelihood, part.size());
    const cv::Size size = mask_size(picture);
    const double scale_x = static_cast<double>(size.width) / picture.width;
    const double scale_y = static_cast<double>(size.height) / picture.height;
    const cv::Point corner(cvFloor(scale_x * part.x), cvFloor(scale_y * part.y));
    const cv::Rect lies =
        cv::Rect(corner, cv::Point(std::max(corner.x + 1, cvRound(scale_x * part.br().x)),
                                   std::max(corner.y + 1, cvRound(scale_y * part.br().y)))) &
        cv::Rect({}, size);
    cv::Mat1b fitted;
    cv::resize(seen.mask, fitted, lies.size(), 0.0, 0.0, cv::INTER_AREA);
    const Pieces things(fitted >= limit);
    const cv::Point at(cvFloor(scale_x * place.x) - lies.x, cvFloor(scale_y * place.y) - lies.y);
    const int thing = nearest_piece(things, at, beside * std::max(lies.width, lies.height));
    Figures found{cv::Mat1b(size, uchar{0}), {}, seen.signs, false};
    if (thing == 0) return found;
    fitted.setTo(0, (things.number != thing) & (things.number != 0));
    fitted.copyTo(found.mask(lies));
    found.boxes.push_back(things.box(thing) + lies.tl());
    const double share = things.area(thing) / static_cast<double>(lies.area());
    found.is_sure =
        seen.is_sure && share < ground_share && !is_cut(found.boxes.front(), lies, size);
    return found;
}

PhotoLines with_figure(PhotoLines lines, const cv::Mat& picture, const cv::Mat1b& mask,
                       double longer_side_mm) {
    const double px_per_mm = std::max(lines.size.width, lines.size.height) / longer_side_mm;
    const double shortest_px = shortest_line_mm * px_per_mm;
    cv::Mat small;
    cv::resize(picture, small, lines.size, 0.0, 0.0, cv::INTER_AREA);
    const cv::Mat1f strength = colour_gradient(to_lab(small), smoothing_px).strength;
    const cv::Mat1f soft = fitted(mask, lines.size);
    const std::vector<Chain> rings =
        rings_of(soft, strength, reach_mm * px_per_mm, shortest_px, lines.high);
    if (rings.empty()) return lines;
    std::vector<Chain> felt = off_frame(rings, lines.size, shortest_px);
    const cv::Mat1f distance = to_rings(felt, lines.size);
    const auto beside_px = static_cast<float>(least_apart_mm * px_per_mm);
    const auto place_of = [&](const EdgePoint& p) {
        const cv::Point at = pixel_at(p.at, soft.size());
        if (distance(at) < beside_px) return RingSide::on_ring;
        return soft(at) > figure_level ? RingSide::inside : RingSide::outside;
    };
    const std::vector<Chain> all = std::exchange(lines.chains, std::move(felt));
    for (const Chain& line : all) {
        cut_by_place(line, place_of, [&](Chain part, RingSide place) {
            if (place == RingSide::on_ring || length_of(part) < shortest_px) return;
            if (place == RingSide::outside) part.of = LineOf::background;
            lines.chains.push_back(std::move(part));
        });
    }
    return lines;
}

}  // namespace touchline
