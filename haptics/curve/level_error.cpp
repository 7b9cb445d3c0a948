#include "haptics/curve/curve_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr double widest_bump_m = 0.240;  // where the threshold was measured
constexpr double its_threshold_m = 0.008;
constexpr double threshold_power = 1.3;
constexpr double told_share = 0.5;                          // of the threshold of distance
constexpr double told_slope_rad = std::numbers::pi / 36.0;  // 5 degrees
constexpr double points_per_wavelength = 4.0;

double distance_m(Position p, const Segment& s) {
    return foot(p, s).distance_m;
}

double turn_rad(const Segment& fine, const Segment& coarse) {
    const Position e = fine.b - fine.a;
    const Position c = coarse.b - coarse.a;
    return std::abs(std::atan2(cross(e, c), dot(e, c)));
}

/// The edges of level 0 that one segment of a level stands for.
struct EdgeRange {
    int first = 0;
    int end = 0;
};

EdgeRange edges_of(const CurveSet& curves, int piece, int level, int j) {
    const int stride = 1 << std::min(level, curves.piece(piece).coarsest);
    return {j * stride, std::min((j + 1) * stride, curves.segment_count(piece, 0))};
}

/// Sums over the edges of level 0.
class ErrorSum {
  public:
    void add_stretch(const CurveSet& curves, int piece, int level, int j) {
        const Segment coarse = curves.rendered_segment(piece, level, j);
        const EdgeRange edges = edges_of(curves, piece, level, j);
        double to_a = INFINITY;  // from the coarse points to the fine edges
        double to_b = INFINITY;
        for (int k = edges.first; k < edges.end; ++k) {
            const Segment fine = curves.rendered_segment(piece, 0, k);
            add_edge(fine, coarse);
            to_a = std::min(to_a, distance_m(coarse.a, fine));
            to_b = std::min(to_b, distance_m(coarse.b, fine));
        }
        worst_ = std::max({worst_, to_a, to_b});
        ++points_;
    }

    [[nodiscard]] LevelError result() const {
        const double count = std::max(1.0, count_);
        return {std::sqrt(squares_ / count), worst_,
                length_ > 0.0 ? std::sqrt(slope_squares_ / length_) : 0.0, steepest_, points_};
    }

    void add_end() { ++points_; }

  private:
    void add_edge(const Segment& fine, const Segment& coarse) {
        const double distance = distance_m(fine.a, coarse);
        squares_ += distance * distance;
        count_ += 1.0;
        worst_ = std::max({worst_, distance, distance_m(fine.b, coarse)});
        const double slope = turn_rad(fine, coarse);
        const double length = norm(fine.b - fine.a);
        slope_squares_ += slope * slope * length;
        length_ += length;
        steepest_ = std::max(steepest_, slope);
    }

    double squares_ = 0.0;
    double count_ = 0.0;
    double worst_ = 0.0;
    double slope_squares_ = 0.0;
    double length_ = 0.0;
    double steepest_ = 0.0;
    std::size_t points_ = 0;
};

/// The largest change that cannot be told.
struct Tolerance {
    double distance_m;
    double slope;  // tangent of the angle
};

bool keeps_slope(const Segment& fine, const Segment& coarse, double slope) {
    const Position e = fine.b - fine.a;
    const Position c = coarse.b - coarse.a;
    return std::abs(cross(e, c)) <= slope * dot(e, c);
}

/// Returns whether a segment can be told from the edges of level 0 that it stands for.
bool is_told(const RenderedPiece& level_0, EdgeRange edges, const Segment& coarse,
             const Tolerance& kept) {
    bool is_near_a = false;
    bool is_near_b = false;
    for (int k = edges.first; k < edges.end; ++k) {
        const Segment fine = level_0.segment(k);
        if (!(distance_m(fine.a, coarse) <= kept.distance_m)) return true;
        if (!keeps_slope(fine, coarse, kept.slope)) return true;
        is_near_a = is_near_a || distance_m(coarse.a, fine) <= kept.distance_m;
    }
    for (int k = edges.end - 1; k >= edges.first && !is_near_b; --k) {
        is_near_b = distance_m(coarse.b, level_0.segment(k)) <= kept.distance_m;
    }
    const Position last = level_0.segment(edges.end - 1).b;
    return !is_near_a || !is_near_b || !(distance_m(last, coarse) <= kept.distance_m);
}

bool is_any_told(const CurveSet& curves, int level) {
    const double wavelength_m =
        points_per_wavelength * std::ldexp(curves.finest_spacing_m(), level);
    const Tolerance kept{told_share * detection_threshold_m(wavelength_m),
                         std::tan(told_slope_rad)};
    for (int piece = 0; piece < curves.piece_count(); ++piece) {
        if (curves.piece(piece).coarsest < level) continue;
        const RenderedPiece level_0 = curves.rendered(piece, 0.0);
        const RenderedPiece coarse = curves.rendered(piece, level);
        for (int j = 0; j < coarse.segment_count(); ++j) {
            const EdgeRange edges = edges_of(curves, piece, level, j);
            if (is_told(level_0, edges, coarse.segment(j), kept)) return true;
        }
    }
    return false;
}

}  // namespace

LevelError level_error(const CurveSet& curves, int outline, int level) {
    ErrorSum sum;
    for (int piece = 0; piece < curves.piece_count(); ++piece) {
        const Piece& of = curves.piece(piece);
        if (of.outline != outline) continue;
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            sum.add_stretch(curves, piece, level, j);
        }
        if (!of.is_closed && of.next < 0) sum.add_end();
    }
    return sum.result();
}

double detection_threshold_m(double width_m) {
    return its_threshold_m * std::pow(width_m / widest_bump_m, threshold_power);
}

int percept_level(const CurveSet& curves) {
    int level = 0;
    while (level < curves.coarsest() && !is_any_told(curves, level + 1)) ++level;
    return level;
}

}  // namespace touchline
