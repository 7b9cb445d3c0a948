#include "vision/simplify/trace.h"

#include "vision/contour/chain.h"
#include "vision/contour/edge_lines.h"
#include "vision/contour/gradient.h"
#include "vision/contour/linking.h"
#include "vision/contour/main_shape.h"
#include "vision/contour/regions.h"
#include "vision/contour/strokes.h"
#include "vision/figure/figures.h"
#include "vision/prepare/halftone.h"
#include "vision/prepare/paper.h"
#include "vision/prepare/sheet_edge.h"
#include "vision/prepare/text_boxes.h"
#include "vision/simplify/zoom.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <utility>
#include <vector>

namespace touchline {
namespace {

struct ClassLines {
    PictureClass picture_class = PictureClass::photo;  // the class whose way found them
    PhotoLines found;
};

Chain box_around(const cv::Rect& box) {
    constexpr double frame_strength = 1.0;
    const cv::Point2d low(box.x - 0.5, box.y - 0.5);
    const cv::Point2d high = low + cv::Point2d(box.width, box.height);
    return {{{low, frame_strength, true},
             {{high.x, low.y}, frame_strength, true},
             {high, frame_strength, true},
             {{low.x, high.y}, frame_strength, true}},
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
    for (const cv::Rect& figure : page.figures) lines.push_back(box_around(figure));
    return lines;
}

double mean_strength(const std::vector<Chain>& lines) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Chain& line : lines) {
        for (const EdgePoint& p : line.points) sum += p.strength;
        count += line.points.size();
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

/// Finds the lines of a class other than photo.
PhotoLines drawn_lines(const cv::Mat& picture, PictureClass picture_class, double longer_side_mm) {
    const LabPicture lab = to_lab(reduced(picture, working_pixels));
    PhotoLines found;
    found.size = lab.size();
    found.noise = noise_of(lab);
    const double px_per_mm = std::max(lab.cols, lab.rows) / longer_side_mm;
    if (picture_class == PictureClass::diagram) {
        found.chains = region_lines(lab, found.noise, widest_stroke_mm * px_per_mm);
    } else if (picture_class == PictureClass::line_art) {
        found.chains = stroke_lines(lab, found.noise, widest_stroke_mm * px_per_mm);
    } else {
        found.chains = page_lines(lab, found.noise);
    }
    if (picture_class != PictureClass::text_page) {
        found.chains = with_dashes_joined(std::move(found.chains), px_per_mm);
    }
    found.lines_found = static_cast<int>(found.chains.size());
    found.specks_dropped = static_cast<int>(std::erase_if(found.chains, [&](const Chain& line) {
        return length_of(line) < shortest_line_mm * px_per_mm || line.points.size() < 2;
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
    if (!shape) return;
    for (EdgePoint& p : shape->points) {
        p.at = {(p.at.x + 0.5) * found.size.width / picture.cols - 0.5,
                (p.at.y + 0.5) * found.size.height / picture.rows - 0.5};
        p.strength = std::max(p.strength, found.high);
    }
    found.chains.push_back(std::move(*shape));
}

/// photo: edges, and the main shape if one convinces; diagram: borders of flat colour; line art:
/// middle lines of strokes up to 6 mm wide; text page: a line through each line of text, and a box
/// around each figure (letters are not felt). If the way of its class finds nothing, or fifty times
/// more specks than lines, the picture is treated as a photo. For classes other than photo, `high`
/// is half the mean strength of the lines. `longer_side_mm`: how long the picture's longer side
/// will be at the handle. `figure`: the mask of a photo's main things (vision/figure), instead of
/// its main shape; empty: none. Throws cv::Exception without memory. Deterministic. Threads: pure
/// function. O(pixels).
ClassLines class_lines(const cv::Mat& picture, PictureClass picture_class, double longer_side_mm,
                       const cv::Mat1b& figure) {
    if (picture_class != PictureClass::photo) {
        PhotoLines found = drawn_lines(picture, picture_class, longer_side_mm);
        constexpr std::size_t most_specks = 50;
        constexpr double grain = 40.0;  // grey levels of noise: no drawing shows through
        if (!found.chains.empty() && found.noise < grain &&
            static_cast<std::size_t>(found.specks_dropped) < most_specks * found.chains.size()) {
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

std::string size_of(const cv::Mat& picture) {
    return std::to_string(picture.cols) + " x " + std::to_string(picture.rows);
}

Result<void> check(const cv::Mat& picture) {
    if (picture.empty()) {
        return failure(
            "no outline found, because the picture has no pixels; choose another picture");
    }
    if (picture.type() != CV_8UC3 && picture.type() != CV_8UC1) {
        return failure("the picture is neither 8-bit colour nor 8-bit grey; convert it first");
    }
    return {};
}

Result<void> check(const TraceOptions& options) {
    if (options.detail < 1 || options.detail > most_detail) {
        return failure("detail is " + std::to_string(options.detail) + "; it must be 1 to 5");
    }
    if (!(options.zoom.factor >= 1.0 && options.zoom.factor <= 16.0)) {
        return failure("the zoom is " + std::to_string(options.zoom.factor) +
                       " times; it must be 1 to 16");
    }
    if (!std::isfinite(options.zoom.centre.x) || !std::isfinite(options.zoom.centre.y)) {
        return failure("the middle of the zoom is no place; choose another part of the picture");
    }
    if (!is_usable(options.area)) {
        return failure("the drawing area must be between 1 mm and 1 m on each side");
    }
    return {};
}

/// For a visitor, unlike a library's own message. Only lack of memory is known to occur.
std::string sentence_for(const std::exception& e) {
    const auto* of_opencv = dynamic_cast<const cv::Exception*>(&e);
    const bool is_memory = dynamic_cast<const std::bad_alloc*>(&e) != nullptr ||
                           (of_opencv != nullptr && of_opencv->code == cv::Error::StsNoMem);
    return is_memory ? "the picture could not be traced, because there is not enough memory; "
                       "try a smaller one"
                     : "the picture could not be traced, because it is of a kind that was not "
                       "foreseen; try another one";
}

/// A part of a photograph, cut out round its main thing, may look like a drawing.
ClassDecision decided(const cv::Mat& sheet, const TraceOptions& options, bool has_figure) {
    if (options.picture_class)
        return {*options.picture_class, "You chose the kind of picture.", {}};
    if (has_figure) return {PictureClass::photo, "This looks like a photo, with a main thing.", {}};
    return class_of(sheet);
}

std::string nothing_found(const cv::Mat& picture, double mm_per_pixel, const PhotoLines& found) {
    if (picture.total() <= 64) {
        return "no outline found, because the picture is only " + size_of(picture) +
               " pixels; use a larger one";
    }
    // A smaller picture is one line for a finger, or has no room for an edge.
    constexpr double least_side_mm = 3.0;
    constexpr int least_pixels = 8;
    const int shorter = std::min(picture.cols, picture.rows);
    if (shorter < least_pixels || mm_per_pixel * shorter < least_side_mm) {
        const bool is_flat = picture.rows < picture.cols;
        return "no outline found, because the picture is " + size_of(picture) + " pixels, too " +
               (is_flat ? "flat to be felt; use a higher one"
                        : "narrow to be felt; use a wider one");
    }
    if (found.specks_dropped > 0) {
        return "no outline found, because all that is in the picture is too small for a finger; "
               "use a larger area, or a closer picture";
    }
    return "no outline found, because nothing in the picture stands out from its background; use "
           "a picture with more contrast";
}

std::string warning_for(const TraceReport& report) {
    if (report.found.is_grain) {
        return "nothing in the picture stands out from its grain; of " +
               std::to_string(report.found.lines_found) + " lines in the grain only the " +
               std::to_string(report.outlines) + " strongest are used";
    }
    constexpr int crowd = 100;  // lines: more than any detail shows
    return report.simplified.left_out < crowd
               ? ""
               : "the picture has " + std::to_string(report.simplified.lines) +
                     " lines, more than can be felt; only the " + std::to_string(report.outlines) +
                     " strongest are used";
}

}  // namespace

bool is_usable(const Area& area) {
    constexpr double smallest_side_m = 1e-3;
    constexpr double largest_side_m = 1.0;
    const auto is_size = [](double metres) {
        return metres >= smallest_side_m && metres <= largest_side_m;
    };
    return is_size(area.width_m) && is_size(area.height_m);
}

Result<Found> find_lines(const cv::Mat& picture, const TraceOptions& options,
                         const cv::Mat1b& figure) {
    if (const Result<void> usable = check(picture); !usable) return tl::unexpected(usable.error());
    if (const Result<void> usable = check(options); !usable) return tl::unexpected(usable.error());
    try {
        const Placement placement(picture.size(), picture.size(), options.area);
        const double mm_per_pixel = 1000.0 / placement.picture_pixels_per_metre();
        const double longer_side_mm = mm_per_pixel * std::max(picture.cols, picture.rows);
        // Reduced once, because every way of finding lines starts from at most a megapixel.
        const cv::Mat small = without_dots(reduced(picture, working_pixels));
        const cv::Mat sheet = within_sheet(small);
        ClassDecision decision = decided(sheet, options, !figure.empty());
        const bool is_photo = decision.picture_class == PictureClass::photo;
        ClassLines lines =
            class_lines(is_photo ? small : sheet, decision.picture_class, longer_side_mm, figure);
        if (lines.found.chains.empty())
            return failure(nothing_found(picture, mm_per_pixel, lines.found));
        if (lines.picture_class != decision.picture_class)
            decision = {lines.picture_class, "It could only be taken as a photo.",
                        decision.features};
        PhotoLines& found = lines.found;
        std::vector<Chain> chains = std::exchange(found.chains, {});
        return Found{{std::move(chains), found.size, picture.size(), found.high},
                     decision,
                     std::move(found)};
    } catch (const std::exception& e) {  // OpenCV reports lack of memory this way
        return failure(sentence_for(e));
    }
}

Result<Trace> trace_lines(const Found& found, const TraceOptions& options) {
    if (const Result<void> usable = check(options); !usable) return tl::unexpected(usable.error());
    Simplified simple = simplified(found.lines, options.area, options.detail, options.zoom);
    if (simple.map.outlines.empty()) {
        return failure(
            "no outline found, because there is none in this part of the picture; "
            "choose another part");
    }
    Trace trace;
    TraceReport& report = trace.report;
    trace.map = std::move(simple.map);
    report.simplified = std::move(simple.report);
    report.decision = found.decision;
    report.found = found.report;
    report.working_scale =
        static_cast<double>(found.lines.working.width) / found.lines.picture.width;
    report.pixels_per_metre = Placement(found.lines.picture, found.lines.working, trace.map.area)
                                  .picture_pixels_per_metre();
    report.outlines = static_cast<int>(trace.map.outlines.size());
    for (const Outline& outline : trace.map.outlines) {
        report.points += static_cast<int>(outline.points.size());
    }
    report.warning = warning_for(report);
    return trace;
}

Result<Trace> trace_outlines(const cv::Mat& picture, const TraceOptions& options,
                             const cv::Mat1b& figure) {
    return find_lines(picture, options, figure).and_then([&](const Found& found) {
        return trace_lines(found, options);
    });
}

}  // namespace touchline
