#include "app/sheets/line_gaps.h"

#include "app/sheets/stroke_grid.h"

#include <numeric>

namespace touchline {
namespace {

constexpr double step_mm = 0.4;
constexpr double touch_mm = 0.5;        // middles this near meet
constexpr double shared_way_mm = 3.0;   // along which two lines are one
constexpr double least_piece_mm = 6.0;  // a shorter rest is no line
constexpr double least_share = 0.3;     // less of an outline is not worth feeling
constexpr double grid_reach_mm = 9.0;

/// What happens at a sample of a line, by what was drawn before.
enum class Fate : std::uint8_t { kept, crossing, beside, shared };

/// A stretch of samples, begin ... end - 1; of a closed line it may go on past the last one.
struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The maximal stretches on which `is_in` holds, for samples in a ring or in a row.
template <class IsIn>
std::vector<Stretch> stretches_of(std::size_t count, bool is_ring, const IsIn& is_in) {
    std::size_t start = 0;
    if (is_ring) {
        while (start < count && is_in(start)) ++start;
        if (start == count) return {{0, count}};
    }
    std::vector<Stretch> found;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = start + k;
        if (!is_in(i % count)) continue;
        if (!found.empty() && found.back().end == i) {
            ++found.back().end;
        } else {
            found.push_back({i, i + 1});
        }
    }
    return found;
}

/// A line in samples of even spacing, without a repeated first one.
struct SampledLine {
    std::vector<PaperPoint> points;
    bool is_ring = false;
    std::vector<NearStroke> near;  // what was drawn before, at each sample
};

/// Lines of one part belong together: the strokes of an X, the cross of a window.
using IsOwnPart = std::function<bool(std::size_t source)>;

/// Decides about one stretch that is too near to what was drawn before.
void judge(const SampledLine& line, const Stretch& stretch, const IsOwnPart& is_own_part,
           std::vector<Fate>& fates) {
    const std::size_t n = line.points.size();
    const auto touches = [&](std::size_t i) { return line.near[i % n].centre_mm < touch_mm; };
    std::vector<std::size_t> contacts;
    bool is_joint = false;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
        if (!touches(i)) continue;
        contacts.push_back(i);
        const bool is_own_end = !line.is_ring && (i == 0 || i + 1 == n);
        const NearStroke& other = line.near[i % n];
        is_joint = is_joint || is_own_end || other.is_end || is_own_part(other.source);
    }
    const bool is_shared = static_cast<double>(contacts.size()) * step_mm > shared_way_mm;
    const auto reach = static_cast<std::size_t>(joint_reach_mm / step_mm) - 2;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
        Fate& fate = fates[i % n];
        if (contacts.empty()) {
            fate = Fate::beside;
        } else if (!is_joint && !is_shared) {
            fate = Fate::crossing;
        } else if (is_shared && touches(i)) {
            fate = Fate::shared;
        } else {
            const auto next = std::ranges::lower_bound(contacts, i);
            const bool is_after = next != contacts.begin() && i - *std::prev(next) < reach;
            const bool is_before = next != contacts.end() && *next - i < reach;
            if (!is_after && !is_before) fate = Fate::beside;
        }
    }
}

SheetStroke stroke_of(const Outline& outline, std::size_t source, const PaperPlace& place,
                      const GapRule& rule) {
    SheetStroke stroke;
    for (const Position& p : outline.points) stroke.points.push_back(place(p));
    stroke.is_closed = outline.is_closed;
    stroke.width_mm = outline.detail <= 1 ? rule.outer_mm : rule.inner_mm;
    stroke.source = source;
    return stroke;
}

/// The most important first.
std::vector<std::size_t> by_importance(const TactileMap& map,
                                       const std::vector<SheetStroke>& strokes) {
    std::vector<std::size_t> order(map.outlines.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        const Outline& first = map.outlines[a];
        const Outline& second = map.outlines[b];
        if (first.detail != second.detail) return first.detail < second.detail;
        if (first.weight != second.weight) return first.weight > second.weight;
        return length_mm(strokes[a]) > length_mm(strokes[b]);
    });
    return order;
}

struct KeptPieces {
    std::vector<SheetStroke> pieces;
    bool lacks_some = false;  // beside another line, not only at a crossing
    bool lacks_most = false;
};

KeptPieces kept_of(const SheetStroke& whole, const StrokeGrid& drawn, const IsOwnPart& is_own_part,
                   const GapRule& rule) {
    SampledLine line{sampled(whole, step_mm), whole.is_closed, {}};
    if (line.is_ring) line.points.pop_back();
    const std::size_t n = line.points.size();
    for (const PaperPoint& p : line.points) line.near.push_back(drawn.near(p));
    const double least_mm = rule.clear_mm + whole.width_mm / 2.0;
    std::vector<Fate> fates(n, Fate::kept);
    const auto is_near = [&](std::size_t i) { return line.near[i].clear_mm < least_mm; };
    for (const Stretch& stretch : stretches_of(n, line.is_ring, is_near))
        judge(line, stretch, is_own_part, fates);

    KeptPieces kept;
    const auto count = [&fates](Fate fate) {
        return static_cast<double>(std::ranges::count(fates, fate));
    };
    kept.lacks_some = count(Fate::beside) * step_mm > least_piece_mm;
    if (std::ranges::all_of(fates, [](Fate fate) { return fate == Fate::kept; })) {
        kept.pieces.push_back(whole);
        return kept;
    }
    const auto is_kept = [&](std::size_t i) { return fates[i] == Fate::kept; };
    for (const Stretch& stretch : stretches_of(n, line.is_ring, is_kept)) {
        SheetStroke piece{{}, false, whole.width_mm, whole.use, whole.source};
        for (std::size_t i = stretch.begin; i < stretch.end; ++i)
            piece.points.push_back(line.points[i % n]);
        if (length_mm(piece) >= least_piece_mm) {
            kept.pieces.push_back(std::move(piece));
        } else if (static_cast<double>(stretch.end - stretch.begin) * step_mm > 1.0) {
            kept.lacks_some = true;
        }
    }
    // What another line already says is not missing.
    const double shown = count(Fate::kept) + count(Fate::shared) + count(Fate::crossing);
    kept.lacks_most = shown < least_share * static_cast<double>(n);
    if (kept.lacks_most) kept.pieces.clear();
    return kept;
}

}  // namespace

PaperLines paper_lines(const TactileMap& map, const PaperPlace& place, PaperSize page,
                       const GapRule& rule) {
    std::vector<SheetStroke> whole;
    for (std::size_t i = 0; i < map.outlines.size(); ++i)
        whole.push_back(stroke_of(map.outlines[i], i, place, rule));
    StrokeGrid drawn(page, std::max(grid_reach_mm, 2.0 * rule.clear_mm));
    PaperLines spaced;
    for (const std::size_t i : by_importance(map, whole)) {
        const auto is_own_part = [&map, i](std::size_t other) {
            const std::string& label = map.outlines[i].label;
            return !label.empty() && map.outlines[other].label == label;
        };
        KeptPieces kept = kept_of(whole[i], drawn, is_own_part, rule);
        if (kept.lacks_most) {
            spaced.left_out.push_back(i);
        } else if (kept.lacks_some) {
            spaced.broken.push_back(i);
        }
        for (SheetStroke& piece : kept.pieces) {
            drawn.add(piece);
            spaced.strokes.push_back(std::move(piece));
        }
    }
    return spaced;
}

}  // namespace touchline
