// Keeps track, from step to step, of which edges of a shape are near which lines: pairs of a node
// of the scene's tree and a node of the shape's, each with the way that the shape must move before
// the pair can matter. Of a pair that is near, finds how far the turning edge may go before it
// comes too near to the line, by conservative advancement along separating directions. Threads:
// one, the servo's. Allocates only in reset().
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/rendered_outlines.h"
#include "haptics/probe/probe_shape.h"

#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

namespace touchline {

/// An edge of the shape, in its frame, beside a line.
struct EdgeAndLine {
    Segment edge;
    Segment line;
    Separation at;  // where the motion starts
};

/// Returns the share of the move, at most `most`, over which the edge stays `keep_m` or more from
/// the line; 0 if it starts nearer than that and comes nearer still. `start` is where it starts. Up
/// to that share the two stay apart at every moment: either along a fixed direction, where the
/// edge's ends stay beyond the line, or along one that turns with the edge, where the line's ends
/// do. Their approach is bounded by its rate at the start and their greatest acceleration.
[[nodiscard]] double clear_share(const EdgeAndLine& pair, const ProbePlacement& start,
                                 const ProbeMove& move, double keep_m, double most);

/// An edge of the shape and a rendered segment that it can reach.
struct NearPair {
    EdgeAndLine geometry;
    TreeNode node{};  // level -1: index of a rendered segment; else a node that is straight
};

/// What the pairs of a front end at.
enum class FrontEnd : std::uint8_t {
    segments,  // as rendered
    nodes,     // that hold everything rendered up to the next whole level
};

class ProbeFront {
  public:
    /// Allocates all memory: room for 4096 pairs.
    void reserve();

    /// Both must outlive its use of them.
    void reset(const ProbeShape& shape, const Scene& scene, double level,
               FrontEnd end = FrontEnd::segments);

    /// Sets another level; the next look makes the front anew.
    void set_level(double level);

    [[nodiscard]] double level() const { return outlines_.level(); }

    /// Finds what comes within `keep_m` of the shape before it has moved by `reach_m`. Looks at a
    /// pair only if its allowance is used up; opens nodes within the budget.
    void look(const ProbePlacement& shape, double keep_m, double reach_m, Spender& spender);

    /// The same for one move: leaves out pairs that stay apart along their shortest way.
    void look_along(const ProbeMove& move, const ProbePlacement& shape, double keep_m,
                    Spender& spender);

    /// Finds again how near the pairs of the last look are, after a move that it looked along, or a
    /// part of it. They hold all that is `probe_mind_m` or less too far to count.
    void look_again(const ProbePlacement& shape);

    /// The pairs that the last look found, until the next one.
    [[nodiscard]] auto near() const {
        return near_ | std::views::transform(
                           [this](std::uint32_t i) -> const NearPair& { return pairs_[i].ends; });
    }

    /// Returns the rendered segment of a pair, at the line's point nearest to the edge.
    [[nodiscard]] SegmentRef segment_of(const NearPair& pair) const;

    /// The way that is free of everything the last look left unopened; infinity if it opened all.
    [[nodiscard]] double unopened_m() const { return unopened_m_; }

    /// Tells the front that the shape has moved, no point of it by more than `way_m`.
    void spend(double way_m) {
        way_m_ += way_m;
        ++moves_;
    }

    /// The number of pairs kept.
    [[nodiscard]] std::size_t size() const { return due_m_.size(); }

    /// The outlines at the rendered level.
    [[nodiscard]] RenderedOutlines& outlines() { return outlines_; }

  private:
    struct Look {
        const ProbePlacement& shape;
        double keep_m;
        double reach_m;  // nothing further off counts
        Spender& spender;
        const ProbeMove* move = nullptr;  // nullptr: any of that reach
        Position sets_out{};              // the shape's origin
        double bend_m = 0.0;              // of the move, and how near counts at its ends
        double mind_m = 0.0;
    };

    /// What a look needs of a pair that stays apart.
    struct Sight {
        Direction normal;            // parts the two longer, as long as it leaves room
        Segment chord;               // of the shape's node, in its frame
        double line_m = 0.0;         // how far along the normal the scene's node comes
        double thick_m = 0.0;        // of both nodes
        double probe_thick_m = 0.0;  // of the shape's

        void turn(Direction n, const Segment& line) {
            normal = n;
            line_m = std::max(dot(n, line.a), dot(n, line.b));
        }

        /// How far the two are apart along the normal, at most by how far they are.
        [[nodiscard]] double gap_m(const Look& look) const {
            const Direction m = look.shape.seen_by_shape(normal);
            return dot(normal, look.shape.origin()) + std::min(dot(m, chord.a), dot(m, chord.b)) -
                   line_m - (thick_m + look.keep_m);
        }

        /// Returns whether the two, `gap_m` off along the normal, stay apart along it. A point that
        /// turns falls short of its rate at the start by at most the move's bend.
        [[nodiscard]] bool leaves_room(double gap_m, const Look& look) const {
            if (gap_m > look.reach_m) return true;
            if (look.move == nullptr || !(gap_m >= look.mind_m)) return false;
            const double turn = look.move->turn_rad;
            const Direction m = look.shape.seen_by_shape(normal);
            const double turned_m = std::min(turn * cross(chord.a, m), turn * cross(chord.b, m));
            return gap_m + dot(normal, look.sets_out) + turned_m - std::abs(turn) * probe_thick_m -
                       look.bend_m >=
                   look.mind_m;
        }
    };

    struct Pair {
        NearPair ends;  // the chords of both; how they lie to each other holds before a move
        std::uint64_t seen = 0;  // this one
        double scene_thick_m = 0.0;
        std::int32_t probe = 0;
        bool is_end = false;
    };

    void remake(double reach_m);
    void look(const Look& look);
    void look_at_block(std::size_t first, const Look& look);
    void add(const Pair& pair, Direction normal);
    void put(std::size_t i, const Pair& pair, Direction normal);
    void see(std::size_t i, const ProbePlacement& shape);
    /// This and the next return whether pair i is done; if not, its place holds another or none.
    bool put_off(std::size_t i, double gap_m);
    bool examine(std::size_t i, const Look& look);
    bool split(std::size_t i, bool is_scene);
    void drop(std::size_t i);
    [[nodiscard]] TreeChildren parts_of(const TreeNode& node) const;
    [[nodiscard]] int leaf_level(int piece) const;
    void see_scene(Pair& pair, const TreeNode& node);
    [[nodiscard]] Capsule capsule(const TreeNode& node, bool& is_end);

    const ProbeShape* shape_ = nullptr;
    RenderedOutlines outlines_;
    FrontEnd end_ = FrontEnd::segments;
    std::vector<double> due_m_;        // the way at which a pair may matter
    std::vector<double> block_due_m_;  // the least of 16 neighbours, or less: most are skipped
    std::vector<Sight> sights_;
    std::vector<Pair> pairs_;
    std::vector<std::uint32_t> near_;  // pairs
    double way_m_ = 0.0;               // moved since the front was made
    double far_m_ = 0.0;               // nothing that was dropped matters before
    std::uint64_t moves_ = 1;
    double unopened_m_ = 0.0;
    bool is_stale_ = true;
};

}  // namespace touchline
