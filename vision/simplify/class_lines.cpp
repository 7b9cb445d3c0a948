#include "vision/simplify/class_lines.h"

#include "vision/contour/dashes.h"
#include "vision/contour/edge_strength.h"
#include "vision/contour/gradient.h"
#include "vision/contour/main_shape.h"
#include "vision/contour/regions.h"
#include "vision/contour/strokes.h"
#include "vision/prepare/ink.h"
#include "vision/prepare/text_boxes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace touchline {
namespace {

constexpr double kWorkingPixels = 1e6;    // 0.1 mm a pixel on a drawing area of 116 x 84 mm
constexpr double kWidestStroke_mm = 3.0;  // wider, and a hand feels its two edges
constexpr double kLeastSlight_mm = 8.0;   // across: a thin line, and no letter that was not read
constexpr double kShortest_mm = 4.0;      // the smallest feature worth a finger's time

Chain box_around(const cv::Rect& box, double strength) {
    const cv::Point2d low(box.x - 0.5, box.y - 0.5);
    const cv::Point2d high = low + cv::Point2d(box.width, box.height);
    return {{{low, strength, true},
             {{high.x, low.y}, strength, true},
             {high, strength, true},
             {{low.x, high.y}, strength, true}},
            true,
            0.0,
            LineOf::figure};
}

std::vector<Chain> page_lines(const LabPicture& lab, double noise) {
    const PageLayout page = page_layout(ink_of(lab, noise));
    std::vector<Chain> lines;
    for (const TextLine& text : page.lines) {
        const double middle = text.box.y + 0.5 * (text.box.height - 1);
        lines.push_back({{{{text.box.x - 0.5, middle}, 1.0, true},
                          {{text.box.x + text.box.width - 0.5, middle}, 1.0, true}},
                         false,
                         static_cast<double>(text.box.height),
                         LineOf::text});
    }
    for (const cv::Rect& figure : page.figures) {
        lines.push_back(box_around(figure, 1.0));
    }
    return lines;
}

double mean_strength(const std::vector<Chain>& lines) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Chain& line : lines) {
        for (const EdgePoint& p : line.points) {
            sum += p.strength;
        }
        count += line.points.size();
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

/// Whether a hand would take the line for nothing: short, or slight and no part of a broken line.
bool is_speck(const Chain& line, double px_per_mm) {
    if (line.points.size() < 2 || length_of(line) < kShortest_mm * px_per_mm) {
        return true;
    }
    if (line.of != LineOf::slight) {
        return false;
    }
    const auto [left, right] =
        std::ranges::minmax(line.points, {}, [](const EdgePoint& p) { return p.at.x; });
    const auto [top, bottom] =
        std::ranges::minmax(line.points, {}, [](const EdgePoint& p) { return p.at.y; });
    return std::hypot(right.at.x - left.at.x, bottom.at.y - top.at.y) < kLeastSlight_mm * px_per_mm;
}

/// The lines of a class other than photo.
PhotoLines drawn_lines(const cv::Mat& picture, PictureClass picture_class, double longer_side_mm) {
    const LabPicture lab = to_lab(reduced(picture, kWorkingPixels));
    PhotoLines found;
    found.size = lab.size();
    found.noise = noise_of(lab);
    const double px_per_mm = std::max(lab.cols, lab.rows) / longer_side_mm;
    if (picture_class == PictureClass::diagram) {
        found.chains = region_lines(lab, found.noise, kWidestStroke_mm * px_per_mm);
    } else if (picture_class == PictureClass::line_art) {
        found.chains = stroke_lines(lab, found.noise, kWidestStroke_mm * px_per_mm);
    } else {
        found.chains = page_lines(lab, found.noise);
    }
    if (picture_class != PictureClass::text_page) {
        found.chains = with_dashes_joined(std::move(found.chains), px_per_mm);
    }
    found.lines_found = static_cast<int>(found.chains.size());
    found.specks_dropped = static_cast<int>(
        std::erase_if(found.chains, [&](const Chain& line) { return is_speck(line, px_per_mm); }));
    for (Chain& line : found.chains) {
        line.of = line.of == LineOf::slight ? LineOf::edge : line.of;
    }
    found.high = 0.5 * mean_strength(found.chains);
    found.low = found.high;
    if (!found.chains.empty()) {
        found.edge_strength = edge_strength(found.chains, found.size, found.high);
    }
    return found;
}

/// Adds the main shape to a photo's lines.
void add_main_shape(const cv::Mat& picture, PhotoLines& found) {
    std::optional<Chain> shape = main_shape(picture, std::nullopt);
    if (!shape) {
        return;
    }
    for (EdgePoint& p : shape->points) {
        p.at = {(p.at.x + 0.5) * found.size.width / picture.cols - 0.5,
                (p.at.y + 0.5) * found.size.height / picture.rows - 0.5};
        p.strength = std::max(p.strength, found.high);
    }
    found.chains.push_back(std::move(*shape));
}

}  // namespace

Result<ClassLines> class_lines(const cv::Mat& picture, PictureClass picture_class,
                               double longer_side_mm, const Boundaries& model) {
    if (picture_class != PictureClass::photo && !model) {
        PhotoLines found = drawn_lines(picture, picture_class, longer_side_mm);
        constexpr std::size_t kMostSpecks = 50;
        constexpr double kGrain = 40.0;  // grey levels of noise: no drawing shows through
        if (!found.chains.empty() && found.noise < kGrain &&
            static_cast<std::size_t>(found.specks_dropped) < kMostSpecks * found.chains.size()) {
            return ClassLines{picture_class, std::move(found)};
        }
    }
    return photo_lines(picture, longer_side_mm, model).map([&](PhotoLines found) {
        if (picture_class == PictureClass::photo && !found.is_grain && !found.chains.empty() &&
            picture.channels() == 3) {
            add_main_shape(picture, found);
        }
        return ClassLines{PictureClass::photo, std::move(found)};
    });
}

}  // namespace touchline
