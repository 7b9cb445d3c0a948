#include "tests/app/drawings/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr double pixels_per_mm = 20.0;
constexpr int fixed_point_bits = 8;  // in OpenCV's drawing
constexpr double beside_mm = 0.16;
constexpr double least_difference = 25.0;  // in a channel, 0 ... 255

using Points = std::vector<cv::Point2d>;

cv::Point fixed(const cv::Point2d& mm) {
    const double scale = pixels_per_mm * (1 << fixed_point_bits);
    const double half =
        0.5 * (1 << fixed_point_bits);  // OpenCV counts from the middle of the first pixel
    return {static_cast<int>(std::lround(mm.x * scale - half)),
            static_cast<int>(std::lround(mm.y * scale - half))};
}

std::vector<std::vector<cv::Point>> fixed(const std::vector<Polyline>& lines) {
    std::vector<std::vector<cv::Point>> out;
    for (const Polyline& line : lines) {
        std::vector<cv::Point>& points = out.emplace_back();
        for (const cv::Point2d& point : line.points) points.push_back(fixed(point));
    }
    return out;
}

cv::Mat blank_mask() {
    return {cv::Size(static_cast<int>(sheet_mm.width * pixels_per_mm),
                     static_cast<int>(sheet_mm.height * pixels_per_mm)),
            CV_8U, cv::Scalar(0)};
}

void add_turns(const Points& ring, cv::Mat& turns) {
    for (int y = 0; y < turns.rows; ++y) {
        const double at = (y + 0.5) / pixels_per_mm;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const cv::Point2d& a = ring[i];
            const cv::Point2d& b = ring[(i + 1) % ring.size()];
            if ((a.y <= at) == (b.y <= at)) continue;
            const double x = a.x + (at - a.y) / (b.y - a.y) * (b.x - a.x);
            const int last =
                std::clamp(static_cast<int>(std::ceil(x * pixels_per_mm - 0.5)), 0, turns.cols);
            if (last > 0) turns(cv::Rect(0, y, last, 1)) += cv::Scalar(b.y > a.y ? 1 : -1);
        }
    }
}

/// Masks each pixel by how often the rings go round it, or by whether that number is odd.
cv::Mat inside_of(const std::vector<Polyline>& rings, bool is_even_odd) {
    cv::Mat mask = blank_mask();
    if (is_even_odd) {
        cv::fillPoly(mask, fixed(rings), cv::Scalar(255), cv::LINE_8, fixed_point_bits);
        return mask;
    }
    cv::Mat turns(mask.size(), CV_16S, cv::Scalar(0));  // Sunday's winding number, row by row
    for (const Polyline& line : rings) add_turns(line.points, turns);
    cv::compare(turns, 0, mask, cv::CMP_NE);
    return mask;
}

cv::Mat mask_of(const Paint& paint) {
    cv::Mat mask;
    if (paint.width_mm > 0.0) {
        mask = blank_mask();
        const int width =
            std::max(1, static_cast<int>(std::lround(paint.width_mm * pixels_per_mm)));
        for (const Polyline& line : paint.lines)
            cv::polylines(mask, fixed({line}), line.is_closed, cv::Scalar(255), width, cv::LINE_8,
                          fixed_point_bits);
    } else {
        mask = inside_of(paint.lines, paint.is_even_odd);
    }
    for (const std::vector<Polyline>& clip : paint.clips) mask &= inside_of(clip, false);
    return mask;
}

cv::Mat painted(const std::vector<Paint>& paints) {
    cv::Mat sheet(blank_mask().size(), CV_8UC3, cv::Scalar::all(255));
    for (const Paint& paint : paints) {
        cv::Mat over;
        cv::addWeighted(sheet, 1.0 - paint.opacity,
                        cv::Mat(sheet.size(), sheet.type(), paint.colour), paint.opacity, 0.0,
                        over);
        over.copyTo(sheet, mask_of(paint));
    }
    return sheet;
}

class Sheet {
  public:
    explicit Sheet(const Drawing& drawing)
        : colours_(painted(drawing.paints)), unjudged_(drawing.unjudged) {}

    /// Returns white beyond the sheet, where there is nothing to see.
    [[nodiscard]] cv::Vec3b at(const cv::Point2d& mm) const {
        const cv::Point pixel(static_cast<int>(std::floor(mm.x * pixels_per_mm)),
                              static_cast<int>(std::floor(mm.y * pixels_per_mm)));
        if (!cv::Rect({}, colours_.size()).contains(pixel)) return {255, 255, 255};
        return colours_.at<cv::Vec3b>(pixel);
    }

    [[nodiscard]] bool is_asked(const cv::Point2d& mm) const {
        const cv::Rect2d sheet(0.4, 0.4, sheet_mm.width - 0.8, sheet_mm.height - 0.8);
        return sheet.contains(mm) &&
               std::none_of(unjudged_.begin(), unjudged_.end(),
                            [&](const cv::Rect2d& r) { return r.contains(mm); });
    }

    [[nodiscard]] bool differ(const cv::Point2d& a, const cv::Point2d& b) const {
        const cv::Vec3b one = at(a);
        const cv::Vec3b other = at(b);
        double most = 0.0;
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(double(one[c]) - double(other[c])));
        return most >= least_difference;
    }

  private:
    cv::Mat colours_;
    std::vector<cv::Rect2d> unjudged_;
};

/// Points in even steps, and the normals there.
struct Walk {
    Points points;
    Points normals;  // of length 1
};

Walk walk_along(const Polyline& line) {
    Walk walk;
    const std::size_t sides = line.points.size() - (line.is_closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const cv::Point2d from = line.points[i];
        const cv::Point2d side = line.points[(i + 1) % line.points.size()] - from;
        const double length = cv::norm(side);
        if (length <= 0.0) continue;
        const int steps = std::max(1, static_cast<int>(std::ceil(length / sample_step_mm)));
        for (int k = 0; k < steps; ++k) {
            walk.points.push_back(from + side * ((k + 0.5) / steps));
            walk.normals.emplace_back(-side.y / length, side.x / length);
        }
    }
    return walk;
}

/// Adds stretches of neighbouring points that are set.
void add_stretches(const std::vector<std::optional<cv::Point2d>>& points, bool is_closed,
                   bool is_border, std::vector<SeenLine>& out) {
    if (std::all_of(points.begin(), points.end(), [](const auto& p) { return p.has_value(); })) {
        SeenLine line{{}, is_closed, is_border};
        for (const auto& point : points) line.points.push_back(*point);
        out.push_back(std::move(line));
        return;
    }
    std::size_t start = 0;  // a ring is cut at a missing point
    if (is_closed)
        start = static_cast<std::size_t>(std::find(points.begin(), points.end(), std::nullopt) -
                                         points.begin());
    SeenLine line{{}, false, is_border};
    const auto finish = [&] {
        if (!line.points.empty()) out.push_back(line);
        line.points.clear();
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& point = points[(start + i) % points.size()];
        if (point &&
            (line.points.empty() || cv::norm(*point - line.points.back()) < 3.0 * sample_step_mm)) {
            line.points.push_back(*point);
        } else {
            finish();
            if (point) line.points.push_back(*point);
        }
    }
    finish();
}

bool is_inside(const cv::Point2d& at, const Paint& paint) {
    return std::all_of(
        paint.clips.begin(), paint.clips.end(), [&](const std::vector<Polyline>& clip) {
            int turns = 0;
            for (const Polyline& ring : clip) {
                std::vector<cv::Point2f> points;
                for (const cv::Point2d& p : ring.points) points.emplace_back(p);
                turns += cv::pointPolygonTest(points, cv::Point2f(at), false) >= 0 ? 1 : 0;
            }
            return turns > 0;
        });
}

double distance_mm(const cv::Point2d& at, const Polyline& line) {
    double least = 1e9;
    const std::size_t sides = line.points.size() - (line.is_closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const cv::Point2d a = line.points[i];
        const cv::Point2d side = line.points[(i + 1) % line.points.size()] - a;
        const double square = side.dot(side);
        const double t = square > 0.0 ? std::clamp((at - a).dot(side) / square, 0.0, 1.0) : 0.0;
        least = std::min(least, cv::norm(at - a - side * t));
    }
    return least;
}

/// Returns true if the stroke itself goes on there, round a corner.
bool is_own(const Paint& paint, const cv::Point2d& at) {
    return std::any_of(paint.lines.begin(), paint.lines.end(), [&](const Polyline& line) {
        return distance_mm(at, line) < 0.5 * paint.width_mm + 0.5 * beside_mm;
    });
}

/// Returns where a thin stroke is felt here: its middle, or its one visible side.
std::optional<cv::Point2d> seen_stroke(const Sheet& sheet, const Paint& paint,
                                       const cv::Point2d& at, const cv::Point2d& across) {
    if (!sheet.is_asked(at) || !is_inside(at, paint)) return std::nullopt;
    const cv::Point2d beside = across * (0.5 * paint.width_mm + beside_mm);
    const bool left = sheet.differ(at, at + beside);
    const bool right = sheet.differ(at, at - beside);
    if (!left && !right) return std::nullopt;
    if ((left && right) || is_own(paint, left ? at - beside : at + beside)) return at;
    return at + across * ((left ? 0.5 : -0.5) * paint.width_mm);
}

std::optional<cv::Point2d> seen_border(const Sheet& sheet, const cv::Point2d& at,
                                       const cv::Point2d& across) {
    if (!sheet.is_asked(at)) return std::nullopt;
    if (!sheet.differ(at + across * beside_mm, at - across * beside_mm)) return std::nullopt;
    return at;
}

double turn_deg(const cv::Point2d& before, const cv::Point2d& at, const cv::Point2d& after) {
    const cv::Point2d in = at - before;
    const cv::Point2d out = after - at;
    return std::abs(std::atan2(in.cross(out), in.dot(out))) * 180.0 / std::numbers::pi;
}

/// Returns the sides of a wide stroke: beside each point of its line, and round its corners and
/// ends.
std::vector<Polyline> sides_of(const Polyline& line, double width_mm) {
    const double half = 0.5 * width_mm;
    std::vector<Polyline> out;
    const Walk walk = walk_along(line);
    for (const double offset : {half, -half}) {
        Polyline& side = out.emplace_back(Polyline{{}, line.is_closed});
        for (std::size_t i = 0; i < walk.points.size(); ++i)
            side.points.push_back(walk.points[i] + walk.normals[i] * offset);
    }
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_end = !line.is_closed && (i == 0 || i + 1 == n);
        if (is_end ||
            turn_deg(line.points[(i + n - 1) % n], line.points[i], line.points[(i + 1) % n]) > 15.0)
            out.push_back(arc(line.points[i], {half, half}));
    }
    return out;
}

void add_seen(const Sheet& sheet, const Paint& paint, const Polyline& line,
              std::vector<SeenLine>& out) {
    Polyline whole = line;
    whole.is_closed |= paint.width_mm <= 0.0;
    if (paint.width_mm > widest_line_mm) {
        for (const Polyline& side : sides_of(line, paint.width_mm))
            add_seen(sheet, Paint{}, side, out);
        return;
    }
    const bool is_border = paint.width_mm <= 0.0;
    const Walk walk = walk_along(whole);
    std::vector<std::optional<cv::Point2d>> points;
    for (std::size_t i = 0; i < walk.points.size(); ++i)
        points.push_back(is_border ? seen_border(sheet, walk.points[i], walk.normals[i])
                                   : seen_stroke(sheet, paint, walk.points[i], walk.normals[i]));
    add_stretches(points, whole.is_closed, is_border, out);
}

}  // namespace

std::vector<SeenLine> seen_lines(const Drawing& drawing) {
    const Sheet sheet(drawing);
    std::vector<SeenLine> out;
    for (const Paint& paint : drawing.paints) {
        for (const Polyline& line : paint.lines) add_seen(sheet, paint, line, out);
        for (const std::vector<Polyline>& clip : paint.clips)
            for (const Polyline& ring : clip) add_seen(sheet, {clip}, ring, out);
    }
    return out;
}

}  // namespace touchline::testing
