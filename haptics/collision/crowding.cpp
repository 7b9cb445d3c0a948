#include "haptics/collision/crowding.h"

#include "haptics/collision/box.h"

#include <algorithm>
#include <array>

namespace touchline {

Crowding::Crowding(const CollisionTree& tree, const CurveSet& curves, double reach_m)
    : tree_(tree),
      curves_(curves),
      reach_m_(2.0 * reach_m),
      alone_(curves.point_count(), true),
      left_(64 * curves.point_count() + 4096) {}

std::vector<bool> Crowding::find_alone() {
    walk();
    if (left_ == 0) alone_.assign(alone_.size(), false);
    return std::move(alone_);
}

Meetings Crowding::find_meetings() {
    walk();
    return {std::move(meetings_), left_ > 0};
}

void Crowding::walk() {
    if (!tree_.bounds_.empty()) within_hierarchy(0);
    for (int piece = 0; piece < static_cast<int>(curves_.pieces().size()); ++piece) {
        for (int level = curves_.pieces()[static_cast<std::size_t>(piece)].coarsest - 1; level >= 0;
             --level) {
            along_level(piece, level);
        }
    }
}

void Crowding::within_hierarchy(std::size_t bound) {
    const auto left = tree_.bounds_[bound].left;
    if (left < 0) {
        within_roots(static_cast<std::size_t>(-left - 1));
        return;
    }
    const auto child = static_cast<std::size_t>(left);
    within_hierarchy(child);
    within_hierarchy(child + 1);
    between_bounds(child, child + 1);
}

/// Opens both, so that the depth stays that of the hierarchy.
void Crowding::between_bounds(std::size_t a, std::size_t b) {
    const auto& bound_a = tree_.bounds_[a];
    const auto& bound_b = tree_.bounds_[b];
    if (left_ == 0) return;
    --left_;
    if (!overlap(bound_a.box(), bound_b.box(), reach_m_)) return;
    if (bound_a.left < 0 && bound_b.left < 0) {
        between_roots(static_cast<std::size_t>(-bound_a.left - 1),
                      static_cast<std::size_t>(-bound_b.left - 1));
        return;
    }
    const auto first = [](std::size_t at, const CollisionTree::Bound& bound) {
        return bound.left < 0 ? at : static_cast<std::size_t>(bound.left);
    };
    const auto last = [](std::size_t at, const CollisionTree::Bound& bound) {
        return bound.left < 0 ? at : static_cast<std::size_t>(bound.left) + 1;
    };
    for (std::size_t i = first(a, bound_a); i <= last(a, bound_a); ++i) {
        for (std::size_t j = first(b, bound_b); j <= last(b, bound_b); ++j) between_bounds(i, j);
    }
}

void Crowding::within_roots(std::size_t a) {
    const Stretch& roots = tree_.roots_[a];
    for (int i = 0; i < roots.count; ++i) {
        for (int j = i + 1; j < roots.count; ++j) {
            compare({roots.piece, roots.first + i}, {roots.piece, roots.first + j},
                    curves_.coarsest());
        }
    }
}

/// Compares nodes that are not neighbours although their parents are: the next but one, and from an
/// even node the one after that. All others of the piece are met through parents that meet.
void Crowding::along_level(int piece, int level) {
    const int count = curves_.segment_count(piece, level);
    const Piece& own = curves_.pieces()[static_cast<std::size_t>(piece)];
    const bool is_closed = own.is_closed || own.next == piece;  // or a loop with one pin
    std::array<Box, 4> window;  // of nodes j ... j + 3, each at its number's last two bits
    const auto box_at = [&](int j) -> Box& { return window[static_cast<std::size_t>(j) % 4]; };
    const auto load = [&](int j) {
        if (j < count || is_closed) box_at(j) = tree_.node_box(curves_, {piece, level, j % count});
    };
    for (int j = 0; j < 3; ++j) load(j);
    for (int j = 0; j < count; ++j) {
        load(j + 3);
        for (const int ahead : {2, 3}) {
            const bool is_one = (ahead == 2 || j % 2 == 0) && (j + ahead < count || is_closed);
            if (!is_one || !overlap(box_at(j), box_at(j + ahead), reach_m_)) continue;
            crowd({piece, j}, {piece, (j + ahead) % count}, level);
        }
    }
}

void Crowding::between_roots(std::size_t a, std::size_t b) {
    const Stretch& roots_a = tree_.roots_[a];
    const Stretch& roots_b = tree_.roots_[b];
    for (int i = 0; i < roots_a.count; ++i) {
        for (int j = 0; j < roots_b.count; ++j) {
            compare({roots_a.piece, roots_a.first + i}, {roots_b.piece, roots_b.first + j},
                    curves_.coarsest());
        }
    }
}

void Crowding::compare(Part a, Part b, int level) {
    if (are_neighbours(a, b, level)) {
        if (a.piece != b.piece) between_neighbours(a, b, level);
    } else {
        between_strangers(a, b, level);
    }
}

/// Compares the ends of two pieces that share a pin, at every level.
void Crowding::between_neighbours(Part a, Part b, int level) {
    if (level == 0) return;
    const Parts of_a = children(a, level);
    const Parts of_b = children(b, level);
    for (int i = 0; i < of_a.count; ++i) {
        for (int j = 0; j < of_b.count; ++j) compare(of_a.at[i], of_b.at[j], level - 1);
    }
}

void Crowding::between_strangers(Part a, Part b, int level) {
    if (left_ == 0) return;
    --left_;
    const Box box_a = tree_.node_box(curves_, {a.piece, level_of(a, level), a.index});
    const Box box_b = tree_.node_box(curves_, {b.piece, level_of(b, level), b.index});
    if (overlap(box_a, box_b, reach_m_)) crowd(a, b, level);
}

/// For two nodes that are not neighbours and whose boxes meet: neither is alone, and their children
/// may meet.
void Crowding::crowd(Part a, Part b, int level) {
    mark(a, level);
    mark(b, level);
    if (level == 0) return;
    meetings_.push_back({level, {{{a.piece, a.index}, {b.piece, b.index}}}});
    const Parts of_a = children(a, level);
    const Parts of_b = children(b, level);
    for (int i = 0; i < of_a.count; ++i) {
        for (int j = 0; j < of_b.count; ++j) {
            between_strangers(of_a.at[i], of_b.at[j], level - 1);
        }
    }
}

int Crowding::level_of(Part a, int level) const {
    return std::min(level, curves_.pieces()[static_cast<std::size_t>(a.piece)].coarsest);
}

/// Returns the nodes that replace it at the next finer level; level > 0.
Crowding::Parts Crowding::children(Part a, int level) const {
    if (level == 0 || level_of(a, level) < level) return {{a, a}, 1};
    const int first = 2 * a.index;
    const bool is_paired = first + 1 < curves_.segment_count(a.piece, level - 1);
    return {{{a.piece, first}, {a.piece, first + 1}}, is_paired ? 2 : 1};
}

bool Crowding::is_last(Part a, int level) const {
    return a.index + 1 == curves_.segment_count(a.piece, level_of(a, level));
}

bool Crowding::are_neighbours(Part a, Part b, int level) const {
    const auto follows = [&](Part before, Part after) {
        const Piece& piece = curves_.pieces()[static_cast<std::size_t>(before.piece)];
        if (before.piece == after.piece && after.index == before.index + 1) return true;
        const int next = piece.is_closed ? before.piece : piece.next;
        return after.index == 0 && after.piece == next && is_last(before, level);
    };
    return follows(a, b) || follows(b, a);
}

void Crowding::mark(Part a, int level) {
    alone_[curves_.first_point(a.piece, level_of(a, level)) + static_cast<std::size_t>(a.index)] =
        false;
}

}  // namespace touchline
