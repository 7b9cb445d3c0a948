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
constexpr auto slack_m = static_cast<float>(5.0 * contact_skin_m);
// More than products of rounded coordinates may be wrong by, of the lengths that are multiplied.
constexpr float rounding = 1e-6F;
constexpr float least_square_m2 = 1e-18F;  // of an edge's length: less leaves the range of floats
constexpr float least_cosine2 = 0.01F;     // of a turn, squared

/// Four edges in the direction of travel, each as the handle sees it.
struct FourEdges {
    Points along{};
    Floats square_m2{};  // of their lengths
    Masks is_passed{};   // the handle pulls beyond the edge's end
    Masks is_entered{};  // the handle presses on the edge and pulls along it from its start
};

/// `points` are five, `step` apart.
[[gnu::always_inline]] inline FourEdges four_edges(const Position* points, std::ptrdiff_t step,
                                                   const Pull& pull, float side) {
    const lanes::Pair p0 = lanes::pair(points[0]);
    const lanes::Pair p1 = lanes::pair(points[step]);
    const lanes::Pair p2 = lanes::pair(points[2 * step]);
    const lanes::Pair p3 = lanes::pair(points[3 * step]);
    const lanes::Pair handle = lanes::pair(pull.handle);
    const Points along =
        lanes::rounded(p1 - p0, p2 - p1, p3 - p2, lanes::pair(points[4 * step]) - p3);
    const Points to_handle = lanes::rounded(handle - p0, handle - p1, handle - p2, handle - p3);
    // All times the edge's length: exact signs, no root.
    const Floats length = lanes::length_bounds(along);
    const Floats square_m2 = lanes::dot(along, along);
    const Floats slack = (slack_m + rounding * (lanes::length_bounds(to_handle) + length)) * length;
    const Floats depth = -side * lanes::cross(along, to_handle);
    const Floats held = held_by_friction(static_cast<float>(pull.friction), depth);
    const Floats ahead = lanes::dot(along, to_handle) - held - slack;
    const Masks is_pressed = depth >= slack;
    return {along, square_m2, is_pressed & (ahead > square_m2),
            is_pressed & (ahead > 0.0F) & (square_m2 > least_square_m2)};
}

/// The same at the end of a row, where only `left` points follow the first one.
FourEdges last_edges(const Position* points, std::ptrdiff_t step, int left, const Pull& pull,
                     float side) {
    std::array<Position, width + 1> last;
    for (int k = 0; k <= width; ++k) {
        last[static_cast<std::size_t>(k)] = points[step * std::min(k, left)];
    }
    return four_edges(last.data(), 1, pull, side);
}

/// Returns the edges of `four` that follow on one that the handle pulls past, with a gentle turn.
[[gnu::always_inline]] inline unsigned edges_gone_to(const FourEdges& before,
                                                     const FourEdges& four) {
    const Points previous = lanes::moved_on<3>(before.along, four.along);
    const Floats previous_square_m2 = lanes::moved_on<3>(before.square_m2, four.square_m2);
    const Masks is_pulled = lanes::moved_on<3>(before.is_passed, four.is_passed);
    const Floats turn = lanes::dot(previous, four.along);
    const Masks is_gentle =
        (turn > 0.0F) & (turn * turn > least_cosine2 * previous_square_m2 * four.square_m2);
    return lanes::gathered(is_pulled & four.is_entered & is_gentle & Masks{1, 2, 4, 8});
}

/// Returns a bit for each of four edges that is alone, `first` and those after it in the direction
/// of travel.
unsigned edges_alone(const CollisionTree& tree, std::size_t first, bool is_forward) {
    if (is_forward) return static_cast<unsigned>(tree.alone_from(first)) & 0b1111U;
    const bool has_four = first + 1 >= width;
    const auto bits = static_cast<unsigned>(has_four ? tree.alone_from(first + 1 - width)
                                                     : tree.alone_from(0) << (width - 1 - first));
    return (bits >> 3U & 1U) | (bits >> 1U & 2U) | (bits << 1U & 4U) | (bits << 3U & 8U);
}

}  // namespace

int vertices_passed(const EdgeRow& row, const CollisionTree& tree, int index, bool is_forward,
                    const Pull& pull, int most) {
    const auto count = static_cast<int>(row.points.size());
    const int step = is_forward ? 1 : -1;
    const auto side = static_cast<float>(sign_of(pull.side) * step);
    int start = is_forward ? index : index + 1;  // of the first edge of four
    FourEdges before;
    int edges = 0;
    for (bool is_first = true; edges <= most; is_first = false) {
        // So many points follow.
        const int left = is_forward ? count - 1 - start : start;
        if (start < 0 || start >= count || left < 1) break;
        const Position* const points = row.points.data() + start;
        const FourEdges four = left < width ? last_edges(points, step, left, pull, side)
                                            : four_edges(points, step, pull, side);
        const std::size_t node =
            row.first_node + static_cast<std::size_t>(is_forward ? start : start - 1);
        unsigned gone = edges_gone_to(before, four) & edges_alone(tree, node, is_forward);
        if (is_first) gone |= 1U;
        const int some = std::countr_one(gone);
        edges += some;
        if (some < width) break;
        before = four;
        start += step * width;
    }
    return std::clamp(edges - 1, 0, most);
}

}  // namespace touchline
