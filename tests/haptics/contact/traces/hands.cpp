#include "tests/haptics/contact/traces/hands.h"

#include <cmath>

namespace touchline::traces {
namespace {

constexpr int ticks = 192;
constexpr int ticks_at_a_place = 3;
constexpr double new_mode = 0.02;  // chance per tick

/// Goes along the points of an outline, from any of them, forwards or back; at an end it goes on at
/// the other.
class Walk {
  public:
    Walk(const TactileMap& map, Chance& chance)
        : points_(chance.one_of(map.outlines).points),
          at_(chance.below(static_cast<int>(points_.size()))),
          step_(chance.unit() < 0.5 ? 1 : -1) {}

    Position next(double way_m) {
        double edge_m = norm(point(at_ + step_) - point(at_));
        for (gone_m_ += way_m; gone_m_ > edge_m; edge_m = norm(point(at_ + step_) - point(at_))) {
            gone_m_ -= edge_m;
            at_ += step_;
        }
        const Position a = point(at_);
        return a + (edge_m > 0.0 ? gone_m_ / edge_m : 0.0) * (point(at_ + step_) - a);
    }

  private:
    [[nodiscard]] Position point(int i) const {
        const auto count = static_cast<int>(points_.size());
        return points_[static_cast<std::size_t>(((i % count) + count) % count)];
    }

    std::vector<Position> points_;
    int at_;
    int step_;
    double gone_m_ = 0.0;  // since point at_
};

std::int64_t rounded(double value, Column column) {
    return std::llround(value * columns[column].per_unit);
}

}  // namespace

std::vector<Row> hand_over(const TactileMap& map, const Hand& hand, const std::vector<Mode>& modes,
                           const std::vector<double>& levels, unsigned seed) {
    Chance chance(seed);
    const bool leaps = hand.speed_m_per_s == 0.0;
    Walk walk(map, chance);
    Position aside;
    double wanted = levels[0];
    Mode now = modes[0];
    std::vector<Row> rows(ticks);
    for (int tick = 0; tick < ticks; ++tick) {
        Row& row = rows[static_cast<std::size_t>(tick)];
        row[starts] = tick % hand.ticks_at_a_line == 0 ? 1 : 0;
        if (tick % (leaps ? ticks_at_a_place : hand.ticks_at_a_line) == 0) walk = Walk(map, chance);
        if (chance.unit() < hand.new_level) wanted = chance.one_of(levels);
        if (chance.unit() < new_mode) now = chance.one_of(modes);
        aside = hand.kept * aside +
                3.0 * (1.0 - hand.kept) *
                    Position{chance.about(hand.aside_m), chance.about(hand.aside_m)};
        Position handle = walk.next(1e-3 * hand.speed_m_per_s) + aside;
        if (hand.grid_m > 0.0) {
            handle = hand.grid_m * Position{std::round(handle.x / hand.grid_m),
                                            std::round(handle.y / hand.grid_m)};
        }
        row[mode] = static_cast<std::int64_t>(now);
        row[level] = rounded(wanted, level);
        row[handle_x] = rounded(handle.x, handle_x);
        row[handle_y] = rounded(handle.y, handle_y);
    }
    return rows;
}

}  // namespace touchline::traces
