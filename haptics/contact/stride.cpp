#include "haptics/contact/stride.h"

#include "haptics/collision/touch.h"

#include <cmath>

namespace touchline {
namespace {

// The centre may lie up to two skins off beside a vertex, which moves its distance to the handle
// and, by friction, what holds it.
constexpr double slack_m = 5.0 * contact_skin_m;
constexpr double least_square_m2 = 64.0 * contact_skin_m * contact_skin_m;  // of an edge's length
constexpr double least_cosine2 = 0.01;                                      // of a turn, squared

/// A handle as seen from the start of an edge, times the edge's length: exact signs, no root.
struct Look {
    double along;  // ahead
    double depth;  // behind the edge
    double slack;
    double square;  // of the edge's length
};

Look look(Position edge, Position to_handle, double side_of_travel) {
    return {dot(edge, to_handle), -side_of_travel * cross(edge, to_handle),
            slack_m * (std::abs(edge.x) + std::abs(edge.y)), dot(edge, edge)};
}

}  // namespace

int vertices_passed(const EdgeRow& row, const CollisionTree& tree, int index, bool is_forward,
                    const Pull& pull, int most) {
    const int step = is_forward ? 1 : -1;
    const double side = static_cast<double>(pull.side) * step;
    const auto count = static_cast<int>(row.points.size());
    const Position* const points = row.points.data();
    int vertex = is_forward ? index + 1 : index;  // the one ahead
    const int behind = vertex - step;
    if (behind < 0 || behind >= count || vertex < 0 || vertex >= count) return 0;
    Position edge = points[vertex] - points[behind];
    Look at = look(edge, pull.handle - points[behind], side);
    int passed = 0;
    for (; passed < most; ++passed) {
        const int ahead = vertex + step;
        if (ahead < 0 || ahead >= count) break;
        const bool is_pulled_to_end =
            at.along - at.square > held_by_friction(pull.friction, at.depth) + at.slack &&
            at.depth >= 0.0;
        const Position next = points[ahead] - points[vertex];
        const Look there = look(next, pull.handle - points[vertex], side);
        const bool is_pulled_on =
            there.depth >= there.slack &&
            there.along > held_by_friction(pull.friction, there.depth) + there.slack;
        const double turn = dot(edge, next);
        const bool is_gentle = turn > 0.0 && turn * turn > least_cosine2 * at.square * there.square;
        const bool is_edge = there.square > least_square_m2;
        const auto node = row.first_node + static_cast<std::size_t>(is_forward ? vertex : ahead);
        if (!(is_pulled_to_end & is_pulled_on & is_gentle & is_edge) || !tree.is_alone(node)) break;
        edge = next;
        at = there;
        vertex = ahead;
    }
    return passed;
}

Passage passage(Position vertex, Direction before, Direction after, double side_of_travel,
                double skin_m) {
    const Direction normal_before = side_of_travel * left_of(before);
    const Direction normal = side_of_travel * left_of(after);
    if (dot(after, normal_before) < 0.0) {  // convex
        return {vertex + along<Position>(normal_before, skin_m),
                vertex + along<Position>(normal, skin_m), normal, 0.0};
    }
    const double share = 1.0 / (1.0 + dot(normal_before, normal));
    const auto offset = along<Position>(share * (normal_before + normal), skin_m);
    return {vertex + offset, vertex + offset, normal, dot(offset, after)};
}

}  // namespace touchline
