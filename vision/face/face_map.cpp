#include "vision/face/face_map.h"

#include "config/types/map_frame.h"
#include "vision/contour/chain.h"
#include "vision/simplify/shaping.h"
#include "vision/simplify/surroundings.h"
#include "vision/simplify/zoom.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace touchline {
namespace {

constexpr int parts_per_side = 48;  // of each side, which is some 10 to 20 mm long

/// The two sides of a ring, from its first corner to its second, each in the same number of parts.
struct RingSides {
    std::vector<EdgePoint> upper;
    std::vector<EdgePoint> lower;

    [[nodiscard]] cv::Point2d middle(std::size_t i) const {
        return 0.5 * (upper[i].at + lower[i].at);
    }
};

/// Returns nothing for a ring without two corners, or for a line that is not a ring.
std::optional<RingSides> sides_of(const Chain& ring) {
    if (!ring.is_closed || std::ranges::count(ring.points, true, &EdgePoint::is_fixed) != 2)
        return std::nullopt;
    std::vector<EdgePoint> points = ring.points;
    std::ranges::rotate(points, std::ranges::find(points, true, &EdgePoint::is_fixed));
    const auto corner =
        std::ranges::find(points.begin() + 1, points.end(), true, &EdgePoint::is_fixed);
    const std::vector<EdgePoint> upper(points.begin(), corner + 1);
    std::vector<EdgePoint> lower(corner, points.end());
    lower.push_back(points.front());
    std::ranges::reverse(lower);
    return RingSides{evenly_spaced(upper, parts_per_side), evenly_spaced(lower, parts_per_side)};
}

/// Returns the ring with its sides `factor` times as far apart.
Chain widened(const RingSides& sides, double factor) {
    Chain ring{{}, true};
    const std::size_t last = sides.upper.size() - 1;
    const auto add = [&](const EdgePoint& p, std::size_t i, bool is_corner) {
        const cv::Point2d middle = sides.middle(i);
        ring.points.push_back({middle + factor * (p.at - middle), 0.0, is_corner});
    };
    for (std::size_t i = 0; i <= last; ++i) add(sides.upper[i], i, i == 0 || i == last);
    for (std::size_t i = last - 1; i > 0; --i) add(sides.lower[i], i, false);
    return ring;
}

constexpr double head_margin_mm = 2.0;  // above the head, so that a finger can go round it
constexpr double face_step_mm = 0.25;
constexpr double clear_of_lines_mm = least_apart_mm + 0.5 * face_step_mm;  // of points
constexpr double most_moved_mm = 3.0;
constexpr double least_shown = 0.4;  // of a part, or it is not shown at all

constexpr ShapingScale outline_scale{face_step_mm, 0.7, 6.0};
constexpr ShapingScale part_scale{face_step_mm, 0.3, 2.0};

int detail_of(FacePart part) {
    switch (part) {
        case FacePart::person:
        case FacePart::face:
            return 1;
        case FacePart::left_eye:
        case FacePart::right_eye:
        case FacePart::mouth:
            return 2;
        case FacePart::nose:
        case FacePart::left_brow:
        case FacePart::right_brow:
            return 3;
        case FacePart::nostrils:
            break;
    }
    return 4;
}

bool is_eye(FacePart part) {
    return part == FacePart::left_eye || part == FacePart::right_eye;
}

/// Returns the top of hair or hat, above the face.
double top_of(const cv::Rect2d& face, const std::vector<PartLine>& lines) {
    constexpr double beside = 0.75;  // of the face's width, from its middle
    constexpr double highest = 1.0;  // of its height, above it
    double top = face.y;
    for (const PartLine& line : lines) {
        if (line.part != FacePart::person) continue;
        for (const EdgePoint& p : line.line.points) {
            const bool is_above =
                std::abs(p.at.x - face.x - 0.5 * face.width) < beside * face.width;
            if (is_above) top = std::min(top, p.at.y);
        }
    }
    return std::max(top, face.y - highest * face.height);
}

/// Returns the part of the picture that fills the area.
cv::Rect2d part_shown(const cv::Rect2d& face, const std::vector<PartLine>& lines,
                      cv::Size2d area_mm) {
    constexpr double shoulders = 0.35;  // of the face's height, below the chin
    constexpr double beside = 0.2;      // of its width, on either side
    const double top = top_of(face, lines);
    const double height = face.br().y + shoulders * face.height - top;
    const double mm_per_px =
        std::min((area_mm.height - head_margin_mm) / height,
                 (area_mm.width - 2.0 * head_margin_mm) / ((1.0 + 2.0 * beside) * face.width));
    const cv::Size2d size(area_mm.width / mm_per_px, area_mm.height / mm_per_px);
    return {face.x + 0.5 * (face.width - size.width), top - head_margin_mm / mm_per_px, size.width,
            size.height};
}

/// Returns the direction along the line through eyes and mouth, or through what there is of them,
/// to the right of an upright face.
cv::Point2d across_face(const std::vector<PartLine>& lines) {
    cv::Point2d across;
    for (const PartLine& line : lines) {
        if (!is_eye(line.part) && line.part != FacePart::mouth) continue;
        const std::vector<EdgePoint>& points = line.line.points;
        if (points.empty()) continue;
        const auto corner =
            std::ranges::find(points.begin() + 1, points.end(), true, &EdgePoint::is_fixed);
        across += (corner == points.end() ? points.back() : *corner).at - points.front().at;
    }
    const double length = cv::norm(across);
    return length > 0.0 ? across / length : cv::Point2d(1.0, 0.0);
}

/// Returns the direction in which, to and fro, a part may be moved away from what is there: eyes
/// and mouth across the face, from its sides; brows and nostrils up, from what lies below them.
cv::Point2d way_out(FacePart part, cv::Point2d across) {
    switch (part) {
        case FacePart::left_eye:
        case FacePart::mouth:
            return across;
        case FacePart::right_eye:
            return -across;
        case FacePart::left_brow:
        case FacePart::right_brow:
        case FacePart::nostrils:
            return {across.y, -across.x};
        default:
            return {};
    }
}

/// The face's lines on the area.
class FaceDrawing {
  public:
    explicit FaceDrawing(cv::Size2d area_mm)
        : area_mm_(area_mm), spaced_(area_mm, least_apart_mm, face_step_mm) {}

    /// Adds the part of a line that lies in the area.
    void add_outline(FacePart part, const Chain& line) {
        const auto is_within = [&](const EdgePoint& p) {
            return p.at.x >= 0.0 && p.at.y >= 0.0 && p.at.x <= area_mm_.width &&
                   p.at.y <= area_mm_.height;
        };
        cut_by_place(shaped(line, outline_scale), is_within, [&](const Chain& stretch, bool is_in) {
            if (!is_in || stretch.points.size() < 2) return;
            for (const Chain& simple : without_self_crossings(stretch, shortest_line_mm)) {
                add_spaced(part, {simple, false, false});
            }
        });
    }

    /// Adds a part by itself, moved a little if that keeps it clear; it touches nothing. A ring is
    /// shown whole or as one line; one without corners, which has no middle, is left out.
    void add_part(FacePart part, const Chain& whole, cv::Point2d way) {
        Chain line = clear_of_others(shaped(whole, part_scale), way);
        if (line.is_closed && !(is_clear(line) && !too_near_itself(line, spaced_.scale()))) {
            line = middle_of(whole);
            if (line.is_closed) return;
            line = clear_of_others(shaped(line, part_scale), way);
        }
        std::optional<Chain> longest;
        cut_by_place(
            line, [&](const EdgePoint& p) { return has_room(p); },
            [&](const Chain& stretch, bool has_room) {
                if (has_room && (!longest || length_of(stretch) > length_of(*longest)))
                    longest = stretch;
            });
        if (!longest || crosses_itself_in_map(*longest)) return;
        const double least_mm = std::max(shortest_line_mm, least_shown * length_of(line));
        if (length_of(*longest) >= least_mm) keep(part, {std::move(*longest), {}, {}, 0, {}});
    }

    [[nodiscard]] const std::vector<FacePart>& parts() const { return parts_; }

    [[nodiscard]] std::vector<Chain> lines() const { return spaced_.lines(); }

  private:
    [[nodiscard]] bool has_room(const EdgePoint& p) const {
        return p.at.x >= 0.0 && p.at.y >= 0.0 && p.at.x <= area_mm_.width &&
               p.at.y <= area_mm_.height && !spaced_.has_near(p.at, clear_of_lines_mm);
    }

    [[nodiscard]] bool is_clear(const Chain& line) const {
        return std::ranges::all_of(line.points, [&](const EdgePoint& p) { return has_room(p); });
    }

    /// Returns the line moved as little as needed, or unchanged if that is too far.
    [[nodiscard]] Chain clear_of_others(const Chain& line, cv::Point2d way) const {
        if (way == cv::Point2d() || is_clear(line)) return line;
        for (double by_mm = face_step_mm; by_mm <= most_moved_mm; by_mm += face_step_mm) {
            for (const double sign : {1.0, -1.0}) {
                Chain moved = line;
                for (EdgePoint& p : moved.points) p.at += sign * by_mm * way;
                if (is_clear(moved)) return moved;
            }
        }
        return line;
    }

    /// Returns whether a line goes along others all the way, so that a hand that follows them
    /// misses nothing of it.
    [[nodiscard]] bool runs_beside(const Chain& line) const {
        return std::ranges::all_of(line.points, [&](const EdgePoint& p) {
            return spaced_.has_near(p.at, 2.0 * least_apart_mm);
        });
    }

    /// Adds everything of a line that is clear of the others; elsewhere it meets them.
    void add_spaced(FacePart part, Candidate candidate) {
        std::vector<Candidate> open{std::move(candidate)};
        while (!open.empty()) {
            auto fit = spaced_.fit(open.back());
            open.pop_back();
            if (!fit) continue;
            std::ranges::move(fit->rest, std::back_inserter(open));
            const bool is_felt = length_of(fit->line) >= shortest_line_mm &&
                                 (part == FacePart::person || !runs_beside(fit->line));
            if (is_felt) keep(part, std::move(*fit));
        }
    }

    void keep(FacePart part, Fit fit) {
        spaced_.add(std::move(fit));
        parts_.push_back(part);
    }

    cv::Size2d area_mm_;
    SpacedLines spaced_;
    std::vector<FacePart> parts_;
};

/// Removes the lower end of the ridge if the nostrils are nearer than a finger can tell.
void shorten_ridge(std::vector<PartLine>& lines) {
    const auto nose = std::ranges::find(lines, FacePart::nose, &PartLine::part);
    const auto nostrils = std::ranges::find(lines, FacePart::nostrils, &PartLine::part);
    if (nose == lines.end() || nostrils == lines.end()) return;
    std::vector<EdgePoint>& ridge = nose->line.points;
    const auto is_near = [&](const EdgePoint& p) {
        return std::ranges::any_of(nostrils->line.points, [&](const EdgePoint& other) {
            return distance(p.at, other.at) < clear_of_lines_mm + face_step_mm;
        });
    };
    ridge.erase(std::ranges::find_if(ridge, is_near), ridge.end());
    if (ridge.size() < 2) lines.erase(nose);
}

std::vector<PartLine> on_area(const std::vector<PartLine>& lines, const cv::Rect2d& shown,
                              cv::Size2d area_mm) {
    const double mm_per_px = area_mm.width / shown.width;
    std::vector<PartLine> placed;
    std::vector<Chain> outlines;
    for (auto [part, line] : lines) {
        for (EdgePoint& p : line.points) p.at = (p.at - shown.tl()) * mm_per_px;
        if (part == FacePart::person) {
            outlines.push_back(std::move(line));
        } else {
            const SpacingScale scale{area_mm, least_apart_mm, face_step_mm};
            placed.push_back({part, opened_for_finger(line, scale)});
        }
    }
    for (Chain& line : with_breaks_closed(std::move(outlines), small_break_mm)) {
        placed.push_back({FacePart::person, std::move(line)});
    }
    std::ranges::stable_sort(placed, {}, [](const PartLine& line) {
        return line.part == FacePart::person ? 0 : detail_of(line.part);
    });
    shorten_ridge(placed);
    return placed;
}

}  // namespace

Chain middle_of(const Chain& ring) {
    const auto sides = sides_of(ring);
    if (!sides) return ring;
    Chain line;
    for (std::size_t i = 0; i < sides->upper.size(); ++i) line.points.push_back({sides->middle(i)});
    return line;
}

Chain opened_for_finger(const Chain& ring, const SpacingScale& scale) {
    constexpr double least_opening_mm = 3.6;
    constexpr double most_opening_mm = 6.0;
    const auto sides = sides_of(ring);
    if (!sides) return ring;
    double opening_mm = 0.0;
    for (std::size_t i = 0; i < sides->upper.size(); ++i) {
        opening_mm = std::max(opening_mm, distance(sides->upper[i].at, sides->lower[i].at));
    }
    if (!(opening_mm > 0.0)) return ring;
    double wanted_mm = std::max(least_opening_mm, opening_mm);
    Chain opened = widened(*sides, wanted_mm / opening_mm);
    while (wanted_mm < most_opening_mm && too_near_itself(opened, scale)) {
        wanted_mm += scale.step_mm;
        opened = widened(*sides, wanted_mm / opening_mm);
    }
    return opened;
}

FaceMap face_map(const cv::Rect2d& face, const std::vector<PartLine>& lines, const Area& area) {
    FaceMap result;
    result.map.area = area_of(view_box_of(area));
    const cv::Size2d area_mm(1000.0 * result.map.area.width_m, 1000.0 * result.map.area.height_m);
    if (!(face.width > 0.0 && face.height > 0.0)) return result;
    result.shown = part_shown(face, lines, area_mm);
    const std::vector<PartLine> placed = on_area(lines, result.shown, area_mm);
    const cv::Point2d across = across_face(placed);
    FaceDrawing drawing(area_mm);
    for (const auto& [part, line] : placed) {
        if (line.points.size() < 2 || !(length_of(line) > 0.0)) continue;
        if (part == FacePart::person || part == FacePart::face) {
            drawing.add_outline(part, line);
        } else {
            drawing.add_part(part, line, way_out(part, across));
        }
    }
    result.parts = drawing.parts();
    for (const Chain& line : drawing.lines()) {
        Outline outline = outline_of(line, result.map.area);
        const std::size_t number = result.map.outlines.size();
        outline.id = "outline-" + std::to_string(number + 1);
        outline.weight = 1.0 / static_cast<double>(number + 1);
        outline.detail = detail_of(result.parts[number]);
        result.map.outlines.push_back(std::move(outline));
    }
    return result;
}

}  // namespace touchline
