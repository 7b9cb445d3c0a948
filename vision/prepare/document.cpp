#include "vision/prepare/document.h"

#include "vision/prepare/page_candidates.h"
#include "vision/prepare/page_light.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double coarse_pixels = 120e3;
constexpr double fine_pixels = 1e6;
constexpr double coarse_sigma_px = 1.2;
constexpr double fine_sigma_px = 1.0;
constexpr double coarse_reach_px = 6.0;
constexpr double exact_slack_px = 1.3;
constexpr std::size_t most_refined = 12;
constexpr double same_corner_px = 4.0;

constexpr double least_side = 0.6;      // support of every side, and ...
constexpr double least_mean = 0.85;     // ... of the outline
constexpr double least_contrast = 8.0;  // grey levels, and
constexpr double least_visible = 1.2;   // sides' worth of outline in the picture
constexpr double least_visible_side = 0.7;
constexpr double near_frame_px = 8.0;
constexpr double least_area = 0.10;  // of the picture; below it is too small, ...
constexpr double speck_area = 0.03;  // ... and below this it is no page

constexpr int clipped_level = 250;
constexpr double most_clipped_frame = 0.4;
constexpr double most_clipped_page = 0.6;
constexpr double least_glare = 0.02;  // of the page
constexpr int glare_contrast = 25;    // the page's median is at least this far below

cv::Size size_for(cv::Size size, double pixels) {
    const double scale = std::min(1.0, std::sqrt(pixels / size.area()));
    return {static_cast<int>(size.width * scale), static_cast<int>(size.height * scale)};
}

struct Judged {
    Quad corners;
    QuadEvidence evidence;
    double score = 0.0;  // 0 ... 1
};

double visible_of(const QuadEvidence& evidence) {
    double sum = 0.0;
    for (const SideEvidence& side : evidence) sum += side.visible;
    return sum;
}

/// Returns the mean of one kind of evidence over all of the outline in the picture.
double mean_of(const QuadEvidence& evidence, double SideEvidence::*kind) {
    double sum = 0.0;
    for (const SideEvidence& side : evidence) sum += side.visible * side.*kind;
    return sum / std::max(visible_of(evidence), 1e-9);
}

/// Prefers supported outlines; among these the larger, because a frame drawn on a page has good
/// edges, too.
Judged judged(const cv::Mat1b& light, const Quad& corners, const QuadEvidence& evidence) {
    Judged one{corners, evidence};
    const double share = std::min(1.0, area_of(corners) / static_cast<double>(light.total()));
    const double support = mean_of(one.evidence, &SideEvidence::support);
    one.score = support * support * std::sqrt(share);
    return one;
}

bool is_page(const Judged& one) {
    if (!is_sheet_like(one.corners) || visible_of(one.evidence) < least_visible) return false;
    const bool has_sides = std::all_of(
        one.evidence.begin(), one.evidence.end(),
        [](const SideEvidence& side) { return side.visible == 0.0 || side.support >= least_side; });
    return has_sides && mean_of(one.evidence, &SideEvidence::support) >= least_mean &&
           mean_of(one.evidence, &SideEvidence::contrast) >= least_contrast;
}

bool is_same(const Quad& a, const Quad& b) {
    for (std::size_t i = 0; i < 4; ++i)
        if (cv::norm(a[i] - b[i]) > same_corner_px) return false;
    return true;
}

/// Returns the best few of all candidates, without doubles.
std::vector<Judged> best_candidates(const cv::Mat1b& light) {
    std::vector<Quad> quads = bright_regions(light);
    const std::vector<Quad> by_lines = line_quads(light);
    quads.insert(quads.end(), by_lines.begin(), by_lines.end());
    std::vector<Judged> all;
    for (const Quad& quad : quads) all.push_back(judged(light, quad, rough_evidence(light, quad)));
    std::stable_sort(all.begin(), all.end(),
                     [](const Judged& a, const Judged& b) { return a.score > b.score; });
    std::vector<Judged> best;
    for (const Judged& one : all) {
        const bool is_double = std::any_of(best.begin(), best.end(), [&](const Judged& known) {
            return is_same(known.corners, one.corners);
        });
        if (!is_double) best.push_back(one);
        if (best.size() >= most_refined) break;
    }
    return best;
}

Judged sharpened(const Judged& coarse, const cv::Mat1b& coarse_light, const cv::Mat1b& light) {
    const Quad near =
        refined(coarse_light, coarse.corners, coarse_reach_px).value_or(coarse.corners);
    const Quad large = rescaled(near, coarse_light.size(), light.size());
    const double scale = static_cast<double>(light.cols) / coarse_light.cols;
    const double reach_px = 2.0 + 2.0 * scale;
    auto exact = refined(light, large, reach_px);
    if (exact) exact = refined(light, *exact, reach_px);
    const Quad corners = exact.value_or(large);
    return judged(light, corners, exact_evidence(light, corners, exact_slack_px));
}

/// Tells by how far the page crosses each side of the picture's frame. A page so near to it that
/// its edge cannot be told from the frame crosses it, too.
CaptureTrouble where_it_leaves(const Judged& page, cv::Size size) {
    double left = 0.0;
    double right = 0.0;
    double up = 0.0;
    double down = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool is_hidden = page.evidence[i].visible < least_visible_side;
        for (const cv::Point2d p : {page.corners[i], page.corners[(i + 1) % 4]}) {
            const double margin_px = is_hidden ? near_frame_px : 0.0;
            left = std::max(left, margin_px - p.x);
            right = std::max(right, p.x + margin_px - (size.width - 1));
            up = std::max(up, margin_px - p.y);
            down = std::max(down, p.y + margin_px - (size.height - 1));
        }
    }
    if ((left > 0.0 && right > 0.0) || (up > 0.0 && down > 0.0)) return CaptureTrouble::too_large;
    const double most = std::max({left, right, up, down});
    if (most == 0.0) return CaptureTrouble::none;
    if (most == left) return CaptureTrouble::too_far_left;
    if (most == right) return CaptureTrouble::too_far_right;
    return most == up ? CaptureTrouble::too_far_up : CaptureTrouble::too_far_down;
}

CaptureTrouble light_on(const cv::Mat1b& light, const Quad& corners) {
    std::vector<cv::Point> polygon(corners.begin(), corners.end());
    cv::Mat1b page(light.size(), std::uint8_t{0});
    cv::fillConvexPoly(page, polygon, 255);
    const double clipped = cv::countNonZero((light >= clipped_level) & page) /
                           std::max(1.0, static_cast<double>(cv::countNonZero(page)));
    if (clipped > most_clipped_page) return CaptureTrouble::too_bright;
    const bool is_spot = level_at(light, page, 0.5) < clipped_level - glare_contrast;
    return clipped > least_glare && is_spot ? CaptureTrouble::glare : CaptureTrouble::none;
}

PaperFormat format_of(double aspect) {
    const double upright = std::min(aspect, 1.0 / aspect);
    if (upright == 1.0 / a4_aspect) return PaperFormat::a4;
    return upright == 1.0 / letter_aspect ? PaperFormat::letter : PaperFormat::other;
}

}  // namespace

PageSearch find_page(const cv::Mat& bgr) {
    const cv::Mat1b coarse = page_light(bgr, size_for(bgr.size(), coarse_pixels), coarse_sigma_px);
    if (is_too_dark(coarse)) return {std::nullopt, CaptureTrouble::too_dark};
    const cv::Mat1b light = page_light(bgr, size_for(bgr.size(), fine_pixels), fine_sigma_px);
    std::optional<Judged> best;
    for (const Judged& candidate : best_candidates(coarse)) {
        const Judged one = sharpened(candidate, coarse, light);
        if (is_page(one) && (!best || one.score > best->score)) best = one;
    }
    const double total = static_cast<double>(light.total());
    if (!best || area_of(best->corners) < speck_area * total) {
        const bool is_flooded = cv::countNonZero(coarse >= clipped_level) >
                                most_clipped_frame * static_cast<double>(coarse.total());
        return {std::nullopt, is_flooded ? CaptureTrouble::too_bright : CaptureTrouble::no_page};
    }
    const CaptureTrouble place = where_it_leaves(*best, light.size());
    if (place != CaptureTrouble::none) return {std::nullopt, place};
    if (area_of(best->corners) < least_area * total)
        return {std::nullopt, CaptureTrouble::too_small};
    const CaptureTrouble trouble = light_on(light, best->corners);
    if (trouble != CaptureTrouble::none) return {std::nullopt, trouble};
    return {ordered(rescaled(best->corners, light.size(), bgr.size())), CaptureTrouble::none};
}

std::string_view sentence(CaptureTrouble trouble) {
    switch (trouble) {
        case CaptureTrouble::none:
            return "";
        case CaptureTrouble::too_dark:
            return "It is too dark here. Ask the staff for more light.";
        case CaptureTrouble::too_bright:
            return "There is too much light. Ask the staff to turn the lamp away.";
        case CaptureTrouble::glare:
            return "The lamp is reflected in the sheet. Ask the staff to move it.";
        case CaptureTrouble::no_page:
            return "No sheet is found. Lay it flat on the tray.";
        case CaptureTrouble::too_small:
            return "The sheet is too far away. Bring it closer.";
        case CaptureTrouble::too_large:
            return "The sheet is too close. Move it away from the camera.";
        case CaptureTrouble::too_far_left:
            return "Move the sheet to the right.";
        case CaptureTrouble::too_far_right:
            return "Move the sheet to the left.";
        case CaptureTrouble::too_far_up:
            return "Move the sheet down, towards you.";
        case CaptureTrouble::too_far_down:
            return "Move the sheet up, away from you.";
    }
    return "";
}

Document document_in(const cv::Mat& bgr) {
    const PageSearch search = find_page(bgr);
    if (!search.corners) return {{}, PaperFormat::other, search.trouble};
    const double aspect = snapped_aspect(aspect_of(*search.corners, bgr.size()));
    return {evenly_lit(rectified(bgr, *search.corners, aspect)), format_of(aspect),
            CaptureTrouble::none};
}

}  // namespace touchline
