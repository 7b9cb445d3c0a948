#include "haptics/contact/stride.h"

#include "haptics/collision/lanes.h"
#include "haptics/collision/touch.h"
#include "haptics/contact/friction.h"

#include <algorithm>
#include <array>
#include <bit>

namespace touchline {
namespace {

using lanes::Floats;
using lanes::Masks;
using lanes::Points;

constexpr int width = 4;

// The centre may lie up to two skins off beside a vertex, which moves its distance to the handle
// and, by friction, what holds it.
constexpr double slack_m = 5.0 * contact_skin_m;
// More than products of rounded coordinates may be wrong by, of the lengths that are multiplied.
constexpr double rounding = 1e-6;
constexpr float least_square_m2 = 1e-18F;  // of an edge's length: its corners must fit on it

/// The handle's pull, for four edges at a time.
struct Pulled {
    lanes::Pair handle;
    float side;  // of the proxy, seen in the direction of travel
    float friction;
    float slack_m;
};

/// Four edges in the direction of travel, each as the handle sees it.
struct FourEdges {
    Masks is_passed{};   // the handle pulls beyond the edge's end
    Masks is_entered{};  // the handle presses on the edge and pulls along it from its start
};

/// `points` are five, `step` apart.
[[gnu::always_inline]] inline FourEdges four_edges(const Position* points, std::ptrdiff_t step,
                                                   const Pulled& pull) {
    const lanes::Pair p0 = lanes::pair(points[0]);
    const lanes::Pair p1 = lanes::pair(points[step]);
    const lanes::Pair p2 = lanes::pair(points[2 * step]);
    const lanes::Pair p3 = lanes::pair(points[3 * step]);
    const Points along =
        lanes::rounded(p1 - p0, p2 - p1, p3 - p2, lanes::pair(points[4 * step]) - p3);
    const Points to_handle =
        lanes::rounded(pull.handle - p0, pull.handle - p1, pull.handle - p2, pull.handle - p3);
    // All times the edge's length: exact signs, no root.
    const Floats square_m2 = lanes::dot(along, along);
    const Floats slack = pull.slack_m * lanes::length_bounds(along);
    const Floats depth = pull.side * lanes::cross(to_handle, along);
    const Floats ahead =
        lanes::dot(along, to_handle) - held_by_friction(pull.friction, depth) - slack;
    const Masks is_pressed = depth >= slack;
    return {is_pressed & (ahead > square_m2),
            is_pressed & (ahead > 0.0F) & (square_m2 > least_square_m2)};
}

/// The same at the end of a row, where only `left` points follow the first one.
FourEdges last_edges(const Position* points, std::ptrdiff_t step, int left, const Pulled& pull) {
    std::array<Position, width + 1> last;
    for (int k = 0; k <= width; ++k) {
        last[static_cast<std::size_t>(k)] = points[step * std::min(k, left)];
    }
    return four_edges(last.data(), 1, pull);
}

/// Returns how many edges that follow on a node's are alone, in the direction of travel: at most
/// 64. Backwards, the node is not the first.
int edges_alone(const CollisionTree& tree, std::size_t node, bool is_forward) {
    if (is_forward) return std::countr_one(tree.alone_from(node + 1));
    return std::countl_one(node < 64 ? tree.alone_from(0) << (64 - node)
                                     : tree.alone_from(node - 64));
}

}  // namespace

int vertices_passed(const EdgeRow& row, const CollisionTree& tree, int index, bool is_forward,
                    const Pull& pull, int most) {
    const auto count = static_cast<int>(row.points.size());
    const int step = is_forward ? 1 : -1;
    int start = is_forward ? index : index + 1;         // of the first edge of four
    int left = is_forward ? count - 1 - start : start;  // so many points follow
    if (start < 0 || start >= count || left < 2) return 0;
    const std::size_t node = row.first_node + static_cast<std::size_t>(index);
    most = std::min({most, left - 1, edges_alone(tree, node, is_forward)});
    // No vertex that is passed is farther from the handle than the first edge's start.
    const double away_m = length_bound(pull.handle - row.points[static_cast<std::size_t>(start)]);
    const Pulled pulled{lanes::pair(pull.handle), static_cast<float>(sign_of(pull.side) * step),
                        static_cast<float>(pull.friction),
                        static_cast<float>(slack_m + rounding * away_m)};
    Masks is_passed{};  // of the four before
    int edges = 0;
    while (edges <= most) {
        const Position* const points = row.points.data() + start;
        const FourEdges four = left < width ? last_edges(points, step, left, pulled)
                                            : four_edges(points, step, pulled);
        // Two edges that both turn less than a right angle from the handle's direction turn by
        // less than that from one to the next too.
        unsigned gone = lanes::gathered(lanes::moved_on<3>(is_passed, four.is_passed) &
                                        four.is_entered & Masks{1, 2, 4, 8});
        if (edges == 0) gone |= 1U;
        const int some = std::countr_one(gone);
        edges += some;
        if (some < width) break;
        is_passed = four.is_passed;
        start += step * width;
        left -= width;
    }
    return std::clamp(edges - 1, 0, std::max(most, 0));
}

}  // namespace touchline
