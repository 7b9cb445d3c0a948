#include "app/sheets/label_places.h"

#include "app/sheets/free_lattice.h"
#include "app/sheets/leader_way.h"
#include "app/sheets/paper_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace touchline {
namespace {

constexpr double leader_end_mm = least_clear_mm + leader_half_mm;  // from the label's dots
constexpr double longest_mm = 110.0;
constexpr double spot_mm = 3.0;  // the dot at a place without a line
constexpr int most_tries = 4;
constexpr int most_ways = 400;            // leaders that are judged for one label
constexpr int most_ways_in_all = 8000;    // and for all, at one try
constexpr std::size_t tried_anchors = 4;  // of one place for a label: the nearest
constexpr double label_reach_mm = 9.0;

// What counts as a longer leader.
constexpr double of_break_mm = 40.0;
constexpr double of_nearness = 1.0;  // each millimetre that is nearer to a line than it should be
constexpr double of_inside_mm = 25.0;
constexpr double of_row_mm = 2.0;
constexpr double of_place_mm = 30.0;  // for a place, a label that does not lie upon it

/// A leader to a place for a label. To judge it costs much and does not depend on other labels, so
/// it is done at the first try that asks for it.
struct Leader {
    PaperPoint anchor;
    bool is_judged = false;
    std::optional<LeaderWay> way;
};

/// A place for a label that has not been judged wholly yet.
struct Candidate {
    double least_cost = 0.0;
    PaperBox box;
    std::size_t shape = 0;
    std::vector<Leader> leaders;          // empty until a try asks for them
    std::size_t face = PaperFaces::open;  // that it lies in; known as soon as the leaders are
};

struct Chosen {
    PlacedLabel label;
    PaperBox box;
    double cost = std::numeric_limits<double>::infinity();
    int breaks = 0;
};

/// A plan, and what each label costs in it: infinite for one that found no room.
struct TriedPlan {
    LabelPlan plan;
    std::vector<double> costs;
};

/// Labels that find room come before how good their places are.
bool is_better(const TriedPlan& a, const TriedPlan& b) {
    const auto sum = [](const std::vector<double>& costs) {
        double all = 0.0;
        for (const double cost : costs) all += std::isinf(cost) ? 0.0 : cost;
        return all;
    };
    const std::size_t of_a = a.plan.without_room.size();
    const std::size_t of_b = b.plan.without_room.size();
    return of_a != of_b ? of_a < of_b : sum(a.costs) < sum(b.costs);
}

class Placer {
  public:
    Placer(const std::vector<WantedLabel>& wanted, const std::vector<SheetStroke>& lines,
           const std::vector<SheetStroke>& shapes, PaperSize page, const PaperBox& zone)
        : wanted_(wanted), faces_(shapes, page), grid_(page, label_reach_mm) {
        for (const SheetStroke& line : lines) grid_.add(line);
        const FreeLattice lattice(grid_, zone);
        for (const WantedLabel& label : wanted) candidates_.push_back(candidates(label, lattice));
    }

    [[nodiscard]] TriedPlan place(const std::vector<std::size_t>& order) {
        TriedPlan tried{{}, std::vector<double>(wanted_.size())};
        Taken taken;
        for (const std::size_t i : order) {
            Chosen chosen = best_for(i, taken);
            tried.costs[i] = chosen.cost;
            if (std::isinf(chosen.cost)) {
                tried.plan.without_room.push_back(wanted_[i].part);
                continue;
            }
            tried.plan.breaks += chosen.breaks;
            taken.boxes.push_back(chosen.box);
            for (const SheetStroke& piece : chosen.label.leader) taken.leaders.push_back(piece);
            tried.plan.placed.push_back(std::move(chosen.label));
        }
        return tried;
    }

  private:
    struct Taken {
        std::vector<PaperBox> boxes;
        std::vector<SheetStroke> leaders;
    };

    /// A label in a part that lines close off seems to name that. It may be there if no line lies
    /// between it and what it names, or if the part is all around that.
    [[nodiscard]] bool seems_to_name_another(const Candidate& candidate, PaperPoint anchor,
                                             const LeaderWay& way) {
        return candidate.face != PaperFaces::open && way.breaks > 0 &&
               !faces_.is_around(candidate.face, anchor);
    }

    /// Whether a line lies between two boxes that are beside each other.
    [[nodiscard]] bool is_line_between(const PaperBox& a, const PaperBox& b) const {
        const double left_mm = std::min(a.right_mm, b.right_mm);
        const double right_mm = std::max(a.left_mm, b.left_mm);
        const double y_mm =
            (std::max(a.top_mm, b.top_mm) + std::min(a.bottom_mm, b.bottom_mm)) / 2.0;
        for (double x_mm = left_mm; x_mm < right_mm; x_mm += leader_half_mm)
            if (grid_.near({x_mm, y_mm}).clear_mm <= 0.0) return true;
        return false;
    }

    [[nodiscard]] bool is_free(const PaperBox& box, const Taken& taken) const {
        const bool meets_box = std::ranges::any_of(taken.boxes, [&](const PaperBox& other) {
            const double x = std::max(other.left_mm - box.right_mm, box.left_mm - other.right_mm);
            const double y = std::max(other.top_mm - box.bottom_mm, box.top_mm - other.bottom_mm);
            if (std::max(x, y) < braille_label_mm) return true;
            return y < 0.0 && x < braille_beside_mm && !is_line_between(box, other);
        });
        return !meets_box && std::ranges::none_of(taken.leaders, [&](const SheetStroke& piece) {
            return segment_distance_mm(piece.points.front(), piece.points.back(), box) <
                   least_clear_mm + piece.width_mm / 2.0;
        });
    }

    /// For a straight line of this half width.
    static bool is_free(PaperPoint from, PaperPoint to, double half_mm, const Taken& taken) {
        const bool meets_box = std::ranges::any_of(taken.boxes, [&](const PaperBox& other) {
            return segment_distance_mm(from, to, other) < least_clear_mm + half_mm;
        });
        return !meets_box && std::ranges::none_of(taken.leaders, [&](const SheetStroke& piece) {
            return segments_distance_mm(from, to, piece.points.front(), piece.points.back()) <
                   least_clear_mm + half_mm + piece.width_mm / 2.0;
        });
    }

    static std::vector<Candidate> candidates(const WantedLabel& wanted,
                                             const FreeLattice& lattice) {
        std::vector<Candidate> found;
        for (std::size_t s = 0; s < wanted.shapes.size(); ++s) {
            std::size_t cells = 1;
            for (const BrailleCells& line : wanted.shapes[s]) cells = std::max(cells, line.size());
            const std::size_t rows = wanted.shapes[s].size();
            const double more_mm = of_row_mm * static_cast<double>(rows - 1);
            lattice.each_box(braille_width_mm(cells), braille_height_mm(rows),
                             [&](const PaperBox& box) {
                                 double least = longest_mm;
                                 for (const PaperPoint& anchor : wanted.anchors)
                                     least = std::min(least, distance_mm(box, anchor));
                                 if (least < longest_mm)
                                     found.push_back({least + more_mm, box, s, {}});
                             });
        }
        std::ranges::sort(found, {}, &Candidate::least_cost);
        return found;
    }

    /// From the anchors nearest to the box, the nearest first.
    static std::vector<Leader> near_leaders(const WantedLabel& wanted, const PaperBox& box) {
        std::vector<PaperPoint> anchors = wanted.anchors;
        const auto count = static_cast<std::ptrdiff_t>(std::min(anchors.size(), tried_anchors));
        std::ranges::partial_sort(anchors, anchors.begin() + count, {},
                                  [&box](PaperPoint p) { return distance_mm(box, p); });
        std::vector<Leader> leaders;
        for (auto i = anchors.begin(); i != anchors.begin() + count; ++i)
            leaders.push_back({*i, false, std::nullopt});
        return leaders;
    }

    [[nodiscard]] Chosen best_for(std::size_t label, const Taken& taken) {
        const WantedLabel& wanted = wanted_[label];
        Chosen best;
        int ways_left = std::min(most_ways, most_ways_in_all / static_cast<int>(wanted_.size()));
        for (Candidate& candidate : candidates_[label]) {
            if (candidate.least_cost >= best.cost || ways_left <= 0) break;
            if (!is_free(candidate.box, taken)) continue;
            const PaperPoint middle{(candidate.box.left_mm + candidate.box.right_mm) / 2.0,
                                    (candidate.box.top_mm + candidate.box.bottom_mm) / 2.0};
            if (wanted.is_place && distance_mm(candidate.box, wanted.anchors.front()) <= 0.0) {
                const double cost = distance_mm(middle, wanted.anchors.front());
                if (cost < best.cost) best = chosen(wanted, candidate, cost, {});
                continue;
            }
            if (candidate.leaders.empty()) {
                candidate.leaders = near_leaders(wanted, candidate.box);
                candidate.face = faces_.face_at(middle);
            }
            const double more_mm = (candidate.face == PaperFaces::open ? 0.0 : of_inside_mm) +
                                   (wanted.is_place ? of_place_mm : 0.0);
            for (Leader& leader : candidate.leaders)
                try_leader(wanted, candidate, leader, more_mm, taken, ways_left, best);
        }
        return best;
    }

    void try_leader(const WantedLabel& wanted, const Candidate& candidate, Leader& leader,
                    double more_mm, const Taken& taken, int& ways_left, Chosen& best) {
        const PaperPoint anchor = leader.anchor;
        const PaperPoint port = port_of(candidate.box, anchor);
        const double length = distance_mm(anchor, port);
        const double rows = static_cast<double>(wanted.shapes[candidate.shape].size());
        const double cost = length + more_mm + of_row_mm * (rows - 1.0);
        if (length < least_start_mm || cost >= best.cost) return;
        if (!is_free(anchor, port, leader_half_mm, taken)) return;
        const bool has_spot =
            wanted.is_place && grid_.near(anchor).clear_mm > least_clear_mm + spot_mm / 2.0;
        if (has_spot && !is_free(anchor, anchor, spot_mm / 2.0, taken)) return;
        --ways_left;
        if (!leader.is_judged) {
            leader = {anchor, true, leader_way(anchor, port, grid_)};
            if (leader.way && seems_to_name_another(candidate, anchor, *leader.way))
                leader.way.reset();
        }
        if (!leader.way) return;
        const LeaderWay& way = *leader.way;
        const double whole_cost = cost + of_break_mm * way.breaks + of_nearness * way.near_mm;
        if (whole_cost >= best.cost) return;
        best = chosen(wanted, candidate, whole_cost, way.pieces);
        best.breaks = way.breaks;
        std::vector<SheetStroke>& drawn = best.label.leader;
        if (has_spot) drawn.insert(drawn.begin(), {{anchor}, false, spot_mm, StrokeUse::leader, 0});
    }

    /// On the straight way to the label's nearest place, and as near to it at a corner as
    /// elsewhere: a finger that leaves the leader's end goes on to the label.
    static PaperPoint port_of(const PaperBox& box, PaperPoint anchor) {
        const PaperPoint nearest{std::clamp(anchor.x_mm, box.left_mm, box.right_mm),
                                 std::clamp(anchor.y_mm, box.top_mm, box.bottom_mm)};
        const double way_mm = distance_mm(nearest, anchor);
        return between(nearest, anchor, std::min(1.0, leader_end_mm / way_mm));
    }

    static Chosen chosen(const WantedLabel& wanted, const Candidate& candidate, double cost,
                         std::vector<SheetStroke> leader) {
        Chosen made{{wanted.part, {}, std::move(leader)}, candidate.box, cost, 0};
        const double half_mm = braille_dot_mm / 2.0;
        PaperPoint first{candidate.box.left_mm + half_mm, candidate.box.top_mm + half_mm};
        for (const BrailleCells& line : wanted.shapes[candidate.shape]) {
            made.label.rows.push_back({first, line});
            first.y_mm += braille_line_mm;
        }
        return made;
    }

    const std::vector<WantedLabel>& wanted_;
    PaperFaces faces_;
    StrokeGrid grid_;
    std::vector<std::vector<Candidate>> candidates_;  // of each label, the best first
};

}  // namespace

LabelPlan placed_labels(const std::vector<WantedLabel>& wanted,
                        const std::vector<SheetStroke>& lines,
                        const std::vector<SheetStroke>& shapes, PaperSize page,
                        const PaperBox& zone) {
    Placer placer(wanted, lines, shapes, page, zone);
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Those with the least choice first: places, then what has few anchors.
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        if (wanted[a].is_place != wanted[b].is_place) return wanted[a].is_place;
        return wanted[a].anchors.size() < wanted[b].anchors.size();
    });
    if (order.empty()) return {};
    TriedPlan best = placer.place(order);
    TriedPlan last = best;
    for (int t = 1; t < most_tries; ++t) {
        const double worst = std::ranges::max(last.costs);
        std::ranges::stable_partition(order, [&](std::size_t i) { return last.costs[i] >= worst; });
        last = placer.place(order);
        if (is_better(last, best)) best = last;
    }
    return std::move(best.plan);
}

}  // namespace touchline
