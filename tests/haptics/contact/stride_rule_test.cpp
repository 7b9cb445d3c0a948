// Compares the vertices that a stride passes with the same rule in lengths and directions.
#include "haptics/contact/stride.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int vertices = 12;

/// A line with as many edges, all alone except those that the second line crosses.
Scene scene_of_nodes(bool is_crossed) {
    std::vector<Position> points;
    for (int i = 0; i < vertices; ++i) points.push_back({1e-3 * i, 0.0});
    std::vector<Outline> lines{scenes::outline(points, false)};
    if (is_crossed) lines.push_back(scenes::outline({{5.5e-3, -1e-3}, {5.5e-3, 1e-3}}, false));
    CurveOptions options;
    options.spacing_m = 1.0;
    return build_scene(scenes::map_of(lines), options, 0.0).value();
}

/// The handle as seen along an edge: how far ahead of its start, and how deep behind it.
struct Seen {
    double ahead_m;
    double depth_m;
    double slack_m;  // for it to be clear
};

Seen seen(Segment edge, double side, Position handle, double rounding_m) {
    const Position to = handle - edge.a;
    const Direction along = direction_of(edge.b - edge.a);
    return {dot(along, to), -side * cross(along, to),
            (5.0 * contact_skin_m + rounding_m) * (std::abs(along.x) + std::abs(along.y))};
}

int passed_by_rule(const EdgeRow& row, const CollisionTree& tree, int index, bool is_forward,
                   const Pull& pull, int most, bool is_wide) {
    std::vector<Position> way(row.points.begin(), row.points.end());
    if (!is_forward) std::ranges::reverse(way);
    const auto count = static_cast<int>(way.size());
    const int first = is_forward ? index : count - 2 - index;
    if (first < 0 || first + 1 >= count) return 0;
    const double side = is_forward ? sign_of(pull.side) : -sign_of(pull.side);
    const Position away = pull.handle - way[static_cast<std::size_t>(first)];
    // Twice what single precision may lose.
    const double rounding_m = is_wide ? 2e-6 * (std::abs(away.x) + std::abs(away.y)) : 0.0;
    int passed = 0;
    for (int i = first; passed < most && i + 2 < count; ++i, ++passed) {
        const auto at = way.begin() + i;
        const Seen here = seen({at[0], at[1]}, side, pull.handle, rounding_m);
        const Seen there = seen({at[1], at[2]}, side, pull.handle, rounding_m);
        const double beyond_m = here.ahead_m - norm(at[1] - at[0]);
        const bool is_beyond =
            here.depth_m >= here.slack_m && beyond_m > pull.friction * here.depth_m + here.slack_m;
        const bool is_pulled_on = there.depth_m >= there.slack_m &&
                                  there.ahead_m > pull.friction * there.depth_m + there.slack_m;
        const int edge = is_forward ? i + 1 : count - 3 - i;
        const bool is_clear = norm(at[2] - at[1]) > 1e-9 &&
                              tree.is_alone(row.first_node + static_cast<std::size_t>(edge));
        if (!is_beyond || !is_pulled_on || !is_clear) break;
    }
    return passed;
}

class Rows {
  public:
    explicit Rows(unsigned seed) : random_(seed) {}

    double between(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }

    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

    /// Makes long and tiny edges, gentle and sharp turns.
    std::vector<Position> points() {
        std::vector<Position> made{{between(-0.01, 0.01), between(-0.01, 0.01)}};
        double heading = between(-3.0, 3.0);
        const double bend = between(0.0, 1.2);
        while (made.size() < vertices) {
            heading += below(12) == 0 ? between(-1.8, 1.8) : between(-bend, bend);
            const double length_m = below(15) == 0 ? between(4e-10, 2e-9) : between(1e-4, 1e-3);
            made.push_back(made.back() + length_m * Position{std::cos(heading), std::sin(heading)});
        }
        return made;
    }

    /// Returns a place beside an edge's end, by a little or by much.
    Position handle(const std::vector<Position>& points) {
        const auto i = static_cast<std::size_t>(1 + below(vertices - 1));
        const Direction along = direction_of(points[i] - points[i - 1]);
        const double ahead_m = between(-1.0, 1.0) * (below(2) == 0 ? 3e-3 : 3e-10);
        const double aside_m = between(-1.0, 1.0) * (below(2) == 0 ? 3e-3 : 3e-10);
        return points[i] + touchline::along<Position>(along, ahead_m) +
               touchline::along<Position>(left_of(along), aside_m);
    }

  private:
    std::mt19937 random_;
};

TEST(StrideRule, PassesWhatTheHandlePullsItOver) {
    Rows rows(1);
    const Scene free = scene_of_nodes(false);
    const Scene crossed = scene_of_nodes(true);
    std::vector<int> counts(vertices);
    for (int i = 0; i < 3000; ++i) {
        const std::vector<Position> points = rows.points();
        const EdgeRow row{points, 0};
        const CollisionTree& tree = (rows.below(4) == 0 ? crossed : free).tree;
        const Pull pull{rows.handle(points), rows.below(2) == 0 ? Side::left : Side::right,
                        rows.below(2) == 0 ? 0.0 : rows.between(0.0, 1.0)};
        const int index = rows.below(vertices + 1) - 1;
        const bool is_forward = rows.below(2) == 0;
        const int most = rows.below(3) == 0 ? rows.below(4) : 64;
        const int passed = vertices_passed(row, tree, index, is_forward, pull, most);
        ASSERT_LE(passed, passed_by_rule(row, tree, index, is_forward, pull, most, false)) << i;
        ASSERT_GE(passed, passed_by_rule(row, tree, index, is_forward, pull, most, true)) << i;
        ++counts[static_cast<std::size_t>(passed)];
    }
    EXPECT_GT(counts[1], 30);
    EXPECT_GT(counts[3], 3);
}

}  // namespace
}  // namespace touchline
