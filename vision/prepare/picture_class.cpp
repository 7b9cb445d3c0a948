#include "vision/prepare/picture_class.h"

#include "vision/prepare/text_boxes.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double copy_pixels = 2e5;

// Texture: measured on half the copy.
constexpr double edge_sigma_px = 1.0;   // Gaussian sigma for the edges of shapes
constexpr double slow_sigma_px = 1.75;  // and for what changes between them
constexpr int near_edge_px = 11;        // across, where an edge still shows at slow_sigma_px
constexpr double edge_levels = 5.0;     // grey levels per pixel, at least
constexpr double edge_over_strongest = 0.18;
constexpr double still = 1.5;         // less is flat
constexpr double slow_levels = 1.0;   // more than a lamp's shade, less than a face's roundness
constexpr double significance = 5.0;  // x gradient noise
constexpr float grainless = 1.1F;     // grey levels off the mean of the pixels around: rounding
constexpr int flat_patch_px = 5;      // across: a patch of one colour
constexpr int near_flat_px = 11;      // across, round the middle of such a patch
constexpr int ruled_line_px = 16;     // long: a line that was ruled
constexpr int broad_mark_px = 9;      // across: no line is as broad, and its edges
constexpr int even_slope_px = 15;     // across: within these a computed shade has an even slope

// Decisions; README.md says what lies on either side.
constexpr double least_textured_part = 0.013;  // of the open parts: a photo
constexpr double much_open = 0.3;    // less: the picture is full of edges, and less texture tells
constexpr double least_open = 0.15;  // less is too little to judge texture by
constexpr double least_painted_part = 0.95;  // of the texture: no camera made it
constexpr double spotted = 0.6;              // the same if nothing else has grain: spots of a JPEG
constexpr double no_grain_at_all = 0.05;     // grey levels
constexpr double least_ruled_part = 0.65;    // of the texture: made-up photos have up to 0.59
constexpr double all_open = 0.995;           // with more, there is no shape, painted or not
constexpr double restless = 0.6;             // of all pixels change: grass, not a pattern
constexpr double little_paper = 0.45;        // with less, no colour is the ground under the others
constexpr double pen_part = 0.025;           // of the diagonal: the widest stroke of a pen
constexpr double least_thin_part = 0.7;      // of the ink: drawn with a pen
constexpr double much_paper = 0.7;
constexpr double much_ink = 0.3;
constexpr double pale_areas = 0.05;  // of the picture, neither paper nor ink
constexpr double clear = 4.0;        // ink over the paper's own spots
constexpr double text = 0.5;         // of the ink
constexpr int least_lines = 3;
constexpr int least_letters = 25;

double part_of(const cv::Mat& mask, double whole) {
    return whole > 0.0 ? cv::countNonZero(mask) / whole : 0.0;
}

/// Returns the greatest channel of each pixel.
cv::Mat greatest_channel(const cv::Mat& picture) {
    cv::Mat greatest;
    cv::reduce(picture.reshape(1, static_cast<int>(picture.total())), greatest, 1, cv::REDUCE_MAX);
    return greatest.reshape(1, picture.rows);
}

/// Returns where the pixels have one single colour, which no camera sees, and the pixels beside
/// them.
cv::Mat near_flat(const cv::Mat& picture) {
    cv::Mat low;
    cv::Mat high;
    const cv::Mat patch = cv::Mat::ones(flat_patch_px, flat_patch_px, CV_8U);
    cv::erode(picture, low, patch);
    cv::dilate(picture, high, patch);
    cv::Mat flat = greatest_channel(high - low) == 0;
    cv::dilate(flat, flat, cv::Mat::ones(near_flat_px, near_flat_px, CV_8U));
    return flat;
}

/// Returns how much of what changes does so as a program paints: evenly, or beside flat colour,
/// without the grain and spots of a camera's picture. It may be anywhere: a page may have one
/// shaded disc in a corner.
double painted_part(const cv::Mat& whole, const cv::Mat& whole_texture) {
    const cv::Rect changing = cv::boundingRect(whole_texture);
    if (changing.empty()) return 0.0;
    const cv::Point around(even_slope_px, even_slope_px);  // of a picture that is no smaller
    const cv::Rect box = cv::Rect(changing.tl() - around, changing.br() + around) &
                         cv::Rect({}, whole_texture.size());
    const auto in_picture = [&](const cv::Point& p) {
        return cv::Point(p.x * whole.cols / whole_texture.cols,
                         p.y * whole.rows / whole_texture.rows);
    };
    const cv::Mat picture = whole(cv::Rect(in_picture(box.tl()), in_picture(box.br())));
    cv::Mat values;
    cv::Mat means;
    picture.convertTo(values, CV_32F);
    cv::blur(values, means, {even_slope_px, even_slope_px});
    const cv::Mat even = greatest_channel(cv::abs(values - means)) <= grainless;
    cv::Mat asked;
    cv::resize(whole_texture(box), asked, picture.size(), 0.0, 0.0, cv::INTER_NEAREST);
    const auto all = static_cast<double>(cv::countNonZero(asked));
    return part_of(asked & (even | near_flat(picture)), all);
}

/// Returns how much of what changes does so along level or upright lines, as the pale grid of a
/// chart does.
double ruled_part(const cv::Mat& texture) {
    const auto opened = [&](int wide, int high) {
        cv::Mat kept;
        cv::morphologyEx(texture, kept, cv::MORPH_OPEN, cv::Mat::ones(high, wide, CV_8U));
        return kept;
    };
    cv::Mat ruled = opened(ruled_line_px, 1) | opened(1, ruled_line_px);
    cv::dilate(ruled, ruled, cv::Mat::ones(3, 3, CV_8U));  // leaning lines are stairs of level ones
    ruled &= texture & ~opened(broad_mark_px, broad_mark_px);
    return part_of(ruled, cv::countNonZero(texture));
}

/// Measures what changes away from edges, how much is away from edges, and how much changes at all.
void measure_texture(const cv::Mat& picture, const LabPicture& copy, PictureFeatures& features) {
    LabPicture half;
    cv::resize(copy, half, {std::max(1, copy.cols / 2), std::max(1, copy.rows / 2)}, 0.0, 0.0,
               cv::INTER_AREA);
    const double noise = 0.5 * features.noise;
    const cv::Mat1f edges = colour_gradient(half, edge_sigma_px).strength;
    const cv::Mat1f slow = colour_gradient(half, slow_sigma_px).strength;
    const double edge =
        std::max({edge_levels, 2.0 * significance * gradient_noise(noise, edge_sigma_px),
                  edge_over_strongest * static_cast<double>(quantile(edges, 0.98))});
    cv::Mat near_edge = edges >= edge;
    cv::dilate(near_edge, near_edge, cv::Mat::ones(near_edge_px, near_edge_px, CV_8U));
    const double least = std::max(slow_levels, significance * gradient_noise(noise, slow_sigma_px));
    const cv::Mat changing = slow > least;
    const cv::Mat open = ~near_edge;
    const auto all = static_cast<double>(half.total());
    features.open_part = part_of(open, all);
    features.texture = part_of(changing & open, cv::countNonZero(open));
    features.ruled_part = ruled_part(changing & open);
    if (features.noise < no_grain)  // a camera's grain answers the question at once
        features.painted_part = painted_part(picture, changing & open);
    features.changing_part =
        part_of(edges > std::max(still, significance * gradient_noise(noise, edge_sigma_px)), all);
}

/// Returns how much of the ink is within half a pen's width of the paper.
double thin_part(const cv::Mat1b& mask, double pen_px) {
    cv::Mat1f depth;
    cv::distanceTransform(mask, depth, cv::DIST_L2, 3);
    const cv::Mat away = depth <= 0.5 * pen_px;
    cv::Mat1f from_core;
    cv::distanceTransform(away, from_core, cv::DIST_L2, 3);
    const cv::Mat thin = (from_core > 0.5 * pen_px + 2.0) & mask;
    return part_of(thin, cv::countNonZero(mask));
}

/// Returns the median ink's contrast over that of the paper's spots (9 of 10 are fainter).
double clearness(const Ink& ink) {
    std::vector<float> inked;
    std::vector<float> bare;
    cv::Mat near_ink;
    cv::dilate(ink.mask, near_ink, cv::Mat::ones(5, 5, CV_8U));
    for (int y = 0; y < ink.mask.rows; y += 2) {
        for (int x = 0; x < ink.mask.cols; x += 2) {
            if (ink.mask(y, x) != 0) {
                inked.push_back(ink.contrast(y, x));
            } else if (near_ink.at<uchar>(y, x) == 0) {
                bare.push_back(ink.contrast(y, x));
            }
        }
    }
    if (inked.empty() || bare.empty()) return 0.0;
    return static_cast<double>(quantile(std::move(inked), 0.5)) /
           std::max(1.0, static_cast<double>(quantile(std::move(bare), 0.9)));
}

void measure_ink(const LabPicture& copy, PictureFeatures& features) {
    const Ink ink = ink_of(copy, features.noise);
    const auto inked = static_cast<double>(cv::countNonZero(ink.mask));
    features.paper_part = ink.paper_part;
    features.ink_part = inked / static_cast<double>(copy.total());
    features.thin_part = thin_part(ink.mask, pen_part * std::hypot(copy.cols, copy.rows));
    features.clearness = clearness(ink);
    const PageLayout layout = page_layout(ink);
    features.text_lines = static_cast<int>(layout.lines.size());
    double in_text = 0.0;
    for (const TextLine& line : layout.lines) {
        features.letters += line.letters;
        in_text += cv::countNonZero(ink.mask(line.box));
    }
    features.text_part = inked > 0.0 ? in_text / inked : 0.0;
}

ClassDecision decided(const PictureFeatures& f) {
    const bool is_paper = f.paper_part >= much_paper && f.ink_part <= much_ink;
    if (is_paper && f.text_part >= text && f.text_lines >= least_lines &&
        f.letters >= least_letters && f.clearness >= clear) {
        return {PictureClass::text_page,
                "This looks like a page of text: about " + std::to_string(f.text_lines) +
                    " lines of letters.",
                f};
    }
    const double textured = least_textured_part * std::min(1.0, f.open_part / much_open);
    // On paper, a ruled grid is not texture; elsewhere planks and blinds may be.
    const bool is_ruled = is_paper && f.ruled_part >= least_ruled_part;
    const double painted = f.noise < no_grain_at_all ? spotted : least_painted_part;
    const bool is_painted = f.painted_part >= painted && f.open_part < all_open;
    // A picture full of edges shows little of its paper's spots.
    const bool is_grainy = f.noise >= no_grain && f.paper_part < little_paper;
    const bool is_textured =
        f.open_part >= least_open
            ? f.texture > textured && !is_painted && !is_ruled
            : f.changing_part > restless && (f.clearness < 2.0 * clear || is_grainy);
    // In a scan, pale areas come from the light; in a picture that a program painted, they are
    // areas.
    const bool has_pale_areas = f.noise < no_grain && 1.0 - f.paper_part - f.ink_part > pale_areas;
    if (is_paper && !has_pale_areas && f.thin_part >= least_thin_part && f.clearness >= clear &&
        (!is_textured || f.clearness >= 2.0 * clear)) {
        return {PictureClass::line_art, "This looks like a drawing: thin lines on plain paper.", f};
    }
    if (is_textured) {
        return {PictureClass::photo,
                "This looks like a photo: colours change everywhere, not only at edges.", f};
    }
    return {PictureClass::diagram,
            "This looks like a logo or a diagram: areas of even colour with clear edges.", f};
}

}  // namespace

ClassDecision class_of(const cv::Mat& picture) {
    const LabPicture copy = to_lab(reduced(picture, copy_pixels));
    PictureFeatures features;
    features.noise = noise_of(copy);
    measure_texture(picture, copy, features);
    measure_ink(copy, features);
    return decided(features);
}

std::string name_of(PictureClass picture_class) {
    switch (picture_class) {
        case PictureClass::photo:
            return "photo";
        case PictureClass::diagram:
            return "diagram";
        case PictureClass::line_art:
            return "drawing";
        case PictureClass::text_page:
            return "text page";
    }
    return "";
}

}  // namespace touchline
