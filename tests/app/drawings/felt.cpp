#include "tests/app/drawings/felt.h"

#include "app/documents/decode/opening.h"
#include "app/documents/trace/page_views.h"
#include "app/documents/trace/tracing.h"
#include "vision/simplify/detail_limits.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr double least_line_mm = 3.0;  // shorter lines are not judged

/// A point of a line: which line, and how far along it.
struct Mark {
    cv::Point2d at;
    std::size_t line = 0;
    double along_mm = 0.0;
};

/// Points sorted by place, to find those nearby.
class Marks {
  public:
    void add(const Mark& mark) {
        if (auto* cell = cell_at(cell_of(mark.at))) cell->push_back(mark);
    }

    [[nodiscard]] bool any_near(const cv::Point2d& at, double within_mm,
                                const std::function<bool(const Mark&)>& counts) const {
        const int reach = static_cast<int>(std::ceil(within_mm));
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
                if (const auto* cell =
                        const_cast<Marks*>(this)->cell_at(cell_of(at) + cv::Point(x, y)))
                    for (const Mark& mark : *cell)
                        if (cv::norm(mark.at - at) <= within_mm && counts(mark)) return true;
        return false;
    }

    [[nodiscard]] bool any_near(const cv::Point2d& at, double within_mm) const {
        return any_near(at, within_mm, [](const Mark&) { return true; });
    }

  private:
    static constexpr int columns = 120;
    static constexpr int rows = 90;

    /// Cells are a millimetre wide.
    static cv::Point cell_of(const cv::Point2d& at) {
        return {static_cast<int>(std::floor(at.x)) + 2, static_cast<int>(std::floor(at.y)) + 3};
    }

    std::vector<Mark>* cell_at(const cv::Point& cell) {
        if (!cv::Rect(0, 0, columns, rows).contains(cell)) return nullptr;
        return &cells_[static_cast<std::size_t>(cell.y * columns + cell.x)];
    }

    std::vector<std::vector<Mark>> cells_ = std::vector<std::vector<Mark>>(columns * rows);
};

std::vector<Mark> marks_of(std::span<const cv::Point2d> points, std::size_t line) {
    std::vector<Mark> out;
    double along = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) along += cv::norm(points[i] - points[i - 1]);
        out.push_back({points[i], line, along});
    }
    return out;
}

/// Converts points to the type that OpenCV measures.
std::vector<cv::Point2f> in_floats(const std::vector<cv::Point2d>& points) {
    return {points.begin(), points.end()};
}

/// Returns true if two lines, or one that comes back, lie within the gap: one of them is then
/// chosen, or led to the other.
bool is_crowded(const Marks& seen, const cv::Point2d& at, double gap_mm) {
    bool is_first = true;
    Mark first;
    return seen.any_near(at, gap_mm, [&](const Mark& mark) {
        if (std::exchange(is_first, false)) first = mark;
        return mark.line != first.line || std::abs(mark.along_mm - first.along_mm) > 4.0 * gap_mm;
    });
}

bool is_unjudged(const Drawing& drawing, const cv::Point2d& at) {
    return std::any_of(drawing.unjudged.begin(), drawing.unjudged.end(),
                       [&](const cv::Rect2d& r) { return r.contains(at); });
}

void reduce(Page& page, double most_pixels) {
    const cv::Mat pixels = pixels_of(page.picture);
    const double scale = std::sqrt(most_pixels / static_cast<double>(pixels.total()));
    if (scale >= 1.0) return;
    cv::Mat small;
    cv::resize(pixels, small, {}, scale, scale, cv::INTER_AREA);
    page.picture = {small.cols, small.rows, {small.data, small.data + 3 * small.total()}};
    page.answer.reset();
}

void judge_seen(const std::vector<SeenLine>& lines, const Marks& seen, const Marks& felt,
                const DetailLimits& limits, double tolerance_mm, Felt& out) {
    for (const SeenLine& line : lines) {
        const double length_mm = static_cast<double>(line.points.size()) * sample_step_mm;
        if (length_mm < least_line_mm) continue;
        for (const cv::Point2d& at : line.points) {
            if (felt.any_near(at, tolerance_mm)) {
                out.seen.right_mm += sample_step_mm;
                continue;
            }
            if (length_mm < limits.least_stroke_mm)
                out.seen.too_short_mm += sample_step_mm;
            else if (is_crowded(seen, at, limits.gap_mm + tolerance_mm))
                out.seen.too_near_mm += sample_step_mm;
            else {
                out.seen.wrong_mm += sample_step_mm;
                if (out.missed.empty() ||
                    cv::norm(out.missed.back().back() - at) > 4 * sample_step_mm)
                    out.missed.emplace_back();
                out.missed.back().push_back(at);
            }
        }
    }
}

void judge_felt(const Drawing& drawing, const std::vector<std::vector<cv::Point2d>>& lines,
                const Marks& seen, const DetailLimits& limits, double tolerance_mm, Felt& out) {
    for (const std::vector<cv::Point2d>& line : lines)
        for (const cv::Point2d& at : line) {
            if (is_unjudged(drawing, at)) continue;
            double& share = seen.any_near(at, tolerance_mm) ? out.felt.right_mm
                            : is_crowded(seen, at, limits.gap_mm + tolerance_mm)
                                ? out.felt.too_near_mm
                                : out.felt.wrong_mm;
            share += sample_step_mm;
        }
}

}  // namespace

std::vector<cv::Point2d> in_steps(const Outline& outline) {
    std::vector<cv::Point2d> corners;
    for (const Position& p : outline.points)
        corners.emplace_back(1e3 * p.x + 0.5 * sheet_mm.width, 0.5 * sheet_mm.height - 1e3 * p.y);
    if (outline.is_closed) corners.push_back(corners.front());
    std::vector<cv::Point2d> out;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const cv::Point2d side = corners[i] - corners[i - 1];
        const int steps = std::max(1, static_cast<int>(std::ceil(cv::norm(side) / sample_step_mm)));
        for (int k = 0; k < steps; ++k)
            out.push_back(corners[i - 1] + side * (static_cast<double>(k) / steps));
    }
    return out;
}

Counted& Counted::operator+=(const Counted& other) {
    right_mm += other.right_mm;
    wrong_mm += other.wrong_mm;
    too_near_mm += other.too_near_mm;
    too_short_mm += other.too_short_mm;
    too_many_mm += other.too_many_mm;
    return *this;
}

Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm) {
    return felt_of(drawing, detail, tolerance_mm, std::numeric_limits<double>::infinity());
}

cv::Mat pixels_of(Picture& picture) {
    return {picture.height, picture.width, CV_8UC3, picture.bgr.data()};
}

Result<Page> whole_page(std::string_view file) {
    const auto bytes = std::as_bytes(std::span(file));
    auto page = open_page(bytes);
    if (!page) return page;
    if (auto finer = finer_page(*page, view_count(*page),
                                [&](const PageOrder& order) { return open_page(bytes, order); }))
        *page = std::move(*finer);
    return page;
}

Result<WholeView> whole_view_of(const Drawing& drawing, int detail, double most_pixels) {
    const auto begin = std::chrono::steady_clock::now();
    auto page = whole_page(drawing.file);
    if (!page) return tl::unexpected(page.error());
    reduce(*page, most_pixels);
    if (drawing.has_words_in_pixels && needs_reading(*page)) {
        const auto words = read_words(page->picture);
        if (words && !words->labels.empty()) *page = with_words(std::move(*page), *words);
    }
    TraceRequest request;
    request.options.detail = detail;
    auto traced = trace_page(*page, request);
    if (!traced) return tl::unexpected(traced.error());
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    return WholeView{std::move(*page), std::move(traced->map), took.count()};
}

Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm, double most_pixels) {
    auto view = whole_view_of(drawing, detail, most_pixels);
    if (!view) return tl::unexpected(view.error());
    Felt out = felt_by(std::move(view->map), drawing, detail, tolerance_mm);
    out.milliseconds = view->milliseconds;
    return out;
}

Felt felt_by(TactileMap map, const Drawing& drawing, int detail, double tolerance_mm) {
    Felt out;
    out.map = std::move(map);
    const std::vector<SeenLine> lines = seen_lines(drawing);
    Marks seen;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        out.seen_mm += cv::arcLength(in_floats(lines[i].points), lines[i].is_closed);
        for (const Mark& mark : marks_of(lines[i].points, i)) seen.add(mark);
    }
    std::vector<std::vector<cv::Point2d>> felt_lines;
    Marks felt;
    for (const Outline& outline : out.map.outlines) {
        felt_lines.push_back(in_steps(outline));
        out.felt_mm += cv::arcLength(in_floats(felt_lines.back()), outline.is_closed);
        for (const Mark& mark : marks_of(felt_lines.back(), felt_lines.size())) felt.add(mark);
    }
    const DetailLimits limits = limits_for(detail, TraceRequest{}.options.area);
    judge_seen(lines, seen, felt, limits, tolerance_mm, out);
    judge_felt(drawing, felt_lines, seen, limits, tolerance_mm, out);
    return out;
}

cv::Mat sheet_of(const Drawing& drawing, const Felt& felt) {
    constexpr double pixels_of_mm = 5.0;
    const cv::Size size(static_cast<int>(sheet_mm.width * pixels_of_mm),
                        static_cast<int>(sheet_mm.height * pixels_of_mm));
    cv::Mat seen(size, CV_8UC3, cv::Scalar::all(255));
    const auto dot = [&](cv::Mat& on, const cv::Point2d& at, const cv::Scalar& colour) {
        cv::circle(on, cv::Point(at * pixels_of_mm), 1, colour, cv::FILLED);
    };
    for (const SeenLine& line : seen_lines(drawing))
        for (const cv::Point2d& at : line.points) dot(seen, at, {60, 160, 60});
    for (const auto& stretch : felt.missed)
        for (const cv::Point2d& at : stretch) dot(seen, at, {0, 0, 230});
    cv::Mat hand(size, CV_8UC3, cv::Scalar::all(255));
    for (const Outline& outline : felt.map.outlines)
        for (const cv::Point2d& at : in_steps(outline)) dot(hand, at, {0, 0, 0});
    cv::Mat both;
    cv::hconcat(seen, hand, both);
    return both;
}

}  // namespace touchline::testing
