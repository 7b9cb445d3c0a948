#include "haptics/curve/level_error.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

double distance_m(Position p, const Segment& s) {
    return foot(p, s).distance_m;
}

/// Sums over the edges of level 0.
class ErrorSum {
  public:
    void add_stretch(const CurveSet& curves, int piece, int level, int j) {
        const Segment coarse = curves.rendered_segment(piece, level, j);
        const int stride =
            1 << std::min(level, curves.pieces()[static_cast<std::size_t>(piece)].coarsest);
        const int last = std::min((j + 1) * stride, curves.segment_count(piece, 0));
        double to_a = INFINITY;  // from the coarse points to the fine edges
        double to_b = INFINITY;
        for (int k = j * stride; k < last; ++k) {
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
        const Position e = fine.b - fine.a;
        const Position c = coarse.b - coarse.a;
        const double slope = std::abs(std::atan2(cross(e, c), dot(e, c)));
        slope_squares_ += slope * slope * norm(e);
        length_ += norm(e);
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

}  // namespace

LevelError level_error(const CurveSet& curves, int outline, int level) {
    ErrorSum sum;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const Piece& of = curves.pieces()[static_cast<std::size_t>(piece)];
        if (of.outline != outline) continue;
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            sum.add_stretch(curves, piece, level, j);
        }
        if (!of.is_closed && of.next < 0) sum.add_end();
    }
    return sum.result();
}

}  // namespace touchline
