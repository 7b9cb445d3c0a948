#include "vision/simplify/class_lines.h"

#include "vision/contour/dashes.h"
#include "vision/contour/edge_strength.h"
#include "vision/contour/finger.h"
#include "vision/contour/gradient.h"
#include "vision/contour/main_shape.h"
#include "vision/contour/regions.h"
#include "vision/contour/strokes.h"
#include "vision/figure/figure_lines.h"
#include "vision/prepare/ink.h"
#include "vision/prepare/text_boxes.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace touchline {
namespace {

constexpr double kWorkingPixels = 1e6;  // 0.1 mm a pixel on a drawing area of 116 x 84 mm

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

/// Finds the lines of a class other than photo.
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
    found.specks_dropped = static_cast<int>(std::erase_if(found.chains, [&](const Chain& line) {
        return length_of(line) < kShortestLine_mm * px_per_mm || line.points.size() < 2;
    }));
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

ClassLines class_lines(const cv::Mat& picture, PictureClass picture_class, double longer_side_mm,
                       const cv::Mat1b& figure) {
    if (picture_class != PictureClass::photo) {
        PhotoLines found = drawn_lines(picture, picture_class, longer_side_mm);
        constexpr std::size_t kMostSpecks = 50;
        constexpr double kGrain = 40.0;  // grey levels of noise: no drawing shows through
        if (!found.chains.empty() && found.noise < kGrain &&
            static_cast<std::size_t>(found.specks_dropped) < kMostSpecks * found.chains.size()) {
            return {picture_class, std::move(found)};
        }
    }
    PhotoLines found = photo_lines(picture, longer_side_mm);
    const bool is_photo = picture_class == PictureClass::photo;
    if (is_photo && !figure.empty()) {
        found = with_figure(std::move(found), picture, figure, longer_side_mm);
    } else if (is_photo && !found.is_grain && !found.chains.empty() && picture.channels() == 3) {
        add_main_shape(picture, found);
    }
    return {PictureClass::photo, std::move(found)};
}

}  // namespace touchline
