#include "tests/haptics/probe/swept_judge.h"

#include "tests/exact/orientation.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double chord_error_m = 3e-9;

bool do_boxes_meet(Position a, Position b, Position c, Position d) {
    return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
           std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

bool meet(Position a, Position b, const Segment& s) {
    return do_boxes_meet(a, b, s.a, s.b) && exact::meet(a, b, s.a, s.b);
}

/// Converts from W to the shape's frame.
Position seen_from(const ProbePose& pose, Position p) {
    const Position d = p - pose.place();
    const double c = std::cos(pose.angle_rad);
    const double s = std::sin(pose.angle_rad);
    return {c * d.x + s * d.y, -s * d.x + c * d.y};
}

ProbePose between(const ProbePose& from, const ProbePose& to, double share) {
    return from + share * (to - from);
}

}  // namespace

SweptJudge::SweptJudge(const CurveSet& curves, double level, std::span<const Segment> shape)
    : shape_(shape.begin(), shape.end()) {
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            segments_.push_back(curves.rendered_segment(piece, level, j));
        }
    }
    for (const Segment& edge : shape_) {
        r_max_m_ = std::max({r_max_m_, norm(edge.a), norm(edge.b)});
    }
}

std::vector<Segment> SweptJudge::near(const ProbePose& from, double reach_m) const {
    std::vector<Segment> found;
    const double within_m = r_max_m_ + reach_m;
    for (const Segment& s : segments_) {
        if (scenes::distance_m(from.place(), s) <= within_m) found.push_back(s);
    }
    return found;
}

bool SweptJudge::is_clear(const ProbePose& pose) const {
    const ProbePlacement placed(pose);
    for (const Segment& line : near(pose, 1e-6)) {
        for (const Segment& edge : shape_) {
            const Segment at = placed(edge);
            if (meet(at.a, at.b, line)) return false;
        }
    }
    return true;
}

double SweptJudge::distance_m(const ProbePose& pose) const {
    const ProbePlacement placed(pose);
    double least_m = INFINITY;
    for (const Segment& line : segments_) {
        for (const Segment& edge : shape_) {
            const Segment at = placed(edge);
            least_m =
                std::min({least_m, scenes::distance_m(at.a, line), scenes::distance_m(at.b, line),
                          scenes::distance_m(line.a, at), scenes::distance_m(line.b, at)});
        }
    }
    return least_m;
}

bool SweptJudge::is_free(std::span<const ProbePose> path) const {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (!is_free(path[i], path[i + 1])) return false;
    }
    return true;
}

bool SweptJudge::is_free(const ProbePose& from, const ProbePose& to) const {
    const ProbeMove move = to - from;
    const double way_m = norm(move.by);
    const double turn = std::abs(move.turn_rad);
    const auto lines = near(from, way_m + 1e-6);
    if (lines.empty()) return true;
    const double arm_m = r_max_m_ + way_m + 1e-3;
    const double bend_m = turn * turn * arm_m + 2.0 * turn * way_m;
    const int parts = 1 + static_cast<int>(std::sqrt(bend_m / (8.0 * chord_error_m)));
    for (int k = 0; k < parts; ++k) {
        const ProbePose begin = between(from, to, static_cast<double>(k) / parts);
        const ProbePose end = k + 1 == parts ? to : between(from, to, (k + 1.0) / parts);
        const ProbePlacement placed_begin(begin);
        const ProbePlacement placed_end(end);
        for (const Segment& edge : shape_) {
            const Position a = placed_begin(edge.a);
            const Position b = placed_end(edge.a);
            const Position c = placed_begin(edge.b);
            const Position d = placed_end(edge.b);
            for (const Segment& line : lines) {
                if (meet(a, b, line) || meet(c, d, line)) return false;
            }
        }
        for (const Segment& line : lines) {
            for (const Position p : {line.a, line.b}) {
                const Position a = seen_from(begin, p);
                const Position b = seen_from(end, p);
                for (const Segment& edge : shape_) {
                    if (meet(a, b, edge)) return false;
                }
            }
        }
    }
    return true;
}

}  // namespace touchline
