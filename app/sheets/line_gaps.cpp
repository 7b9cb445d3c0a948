#include "app/sheets/line_gaps.h"

#include "app/sheets/stroke_grid.h"

#include <map>
#include <numeric>
#include <optional>

namespace touchline {
namespace {

constexpr double step_mm = 0.4;
constexpr double touch_mm = 0.5;        // middles this near meet
constexpr double shared_way_mm = 3.0;   // along which two lines are one
constexpr double least_piece_mm = 6.0;  // a shorter rest is no line
constexpr double least_share = 0.3;     // less of an outline is not worth feeling

/// What happens at a sample of a line, by what was drawn before. Of two reasons against a sample
/// the later in this list is the one that counts, for less is missing there.
enum class Fate : std::uint8_t { kept, beside, crossing, shared };

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
};

/// Lines of one part belong together: the strokes of an X, the cross of a window.
using IsOwnPart = std::function<bool(std::size_t source)>;

/// One stroke that was drawn before, at each sample of a line; nothing where it is far.
using NearSamples = std::vector<std::optional<NearStroke>>;

/// Decides about one stretch that is too near to a stroke that was drawn before.
void judge(const NearSamples& near, bool is_ring, const Stretch& stretch,
           const IsOwnPart& is_own_part, std::vector<Fate>& fates) {
    const std::size_t n = near.size();
    const auto touches = [&](std::size_t i) { return near[i % n]->centre_mm < touch_mm; };
    std::vector<std::size_t> contacts;
    bool is_joint = false;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
        if (!touches(i)) continue;
        contacts.push_back(i);
        const bool is_own_end = !is_ring && (i == 0 || i + 1 == n);
        const NearStroke& other = *near[i % n];
        is_joint = is_joint || is_own_end || other.is_end || is_own_part(other.source);
    }
    const bool is_shared = static_cast<double>(contacts.size()) * step_mm > shared_way_mm;
    const auto reach = static_cast<std::size_t>(joint_reach_mm / step_mm) - 2;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
        Fate fate = Fate::kept;
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
        fates[i % n] = std::max(fates[i % n], fate);
    }
}

/// Each stroke is judged by itself: a line that is joined to one may still run beside another.
std::vector<Fate> fates_of(const SampledLine& line, const StrokeGrid& drawn, double least_mm,
                           const IsOwnPart& is_own_part) {
    const std::size_t n = line.points.size();
    std::map<std::size_t, NearSamples> near;  // by the number of the stroke
    for (std::size_t i = 0; i < n; ++i)
        for (const NearStroke& other : drawn.all_near(line.points[i], least_mm))
            near.try_emplace(other.stroke, n).first->second[i] = other;
    std::vector<Fate> fates(n, Fate::kept);
    for (const auto& [stroke, samples] : near) {
        const auto is_near = [&samples](std::size_t i) { return samples[i].has_value(); };
        for (const Stretch& stretch : stretches_of(n, line.is_ring, is_near))
            judge(samples, line.is_ring, stretch, is_own_part, fates);
    }
    return fates;
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

/// What is left of one outline.
struct KeptPieces {
    std::vector<SheetStroke> pieces;
    double missing_mm = 0.0;  // for want of room; not what another line says, and no crossing
};

/// The piece that a stretch of samples makes. Where it goes on along a line that was drawn before,
/// it ends on that line: a gap would say that they are not joined.
SheetStroke piece_of(const SheetStroke& whole, const SampledLine& line,
                     const std::vector<Fate>& fates, const Stretch& stretch) {
    const std::size_t n = fates.size();
    const auto is_shared = [&](std::size_t i) { return fates[i % n] == Fate::shared; };
    SheetStroke piece{{}, false, whole.width_mm, whole.use, whole.source};
    if ((line.is_ring || stretch.begin > 0) && is_shared(stretch.begin + n - 1))
        piece.points.push_back(line.points[(stretch.begin + n - 1) % n]);
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
        piece.points.push_back(line.points[i % n]);
    if ((line.is_ring || stretch.end < n) && is_shared(stretch.end))
        piece.points.push_back(line.points[stretch.end % n]);
    return piece;
}

/// Adds to `kept`. Each piece is judged as the whole was, for it may have lost its joint; it is
/// shorter, so this ends.
void keep(const SheetStroke& whole, const StrokeGrid& drawn, const IsOwnPart& is_own_part,
          const GapRule& rule, KeptPieces& kept) {
    SampledLine line{sampled(whole, step_mm), whole.is_closed};
    if (line.is_ring) line.points.pop_back();
    const std::size_t n = line.points.size();
    const std::vector<Fate> fates =
        fates_of(line, drawn, rule.clear_mm + whole.width_mm / 2.0, is_own_part);
    const auto count = [&fates](Fate fate) {
        return static_cast<std::size_t>(std::ranges::count(fates, fate));
    };
    if (count(Fate::kept) == n) {
        kept.pieces.push_back(whole);
        return;
    }
    kept.missing_mm += step_mm * static_cast<double>(count(Fate::beside));
    const auto is_kept = [&](std::size_t i) { return fates[i] == Fate::kept; };
    for (const Stretch& stretch : stretches_of(n, line.is_ring, is_kept)) {
        const SheetStroke piece = piece_of(whole, line, fates, stretch);
        if (length_mm(piece) >= least_piece_mm) {
            keep(piece, drawn, is_own_part, rule, kept);
        } else {
            kept.missing_mm += step_mm * static_cast<double>(stretch.end - stretch.begin);
        }
    }
}

}  // namespace

std::vector<SheetStroke> whole_lines(const TactileMap& map, const PaperPlace& place,
                                     const GapRule& rule) {
    std::vector<SheetStroke> lines;
    for (std::size_t i = 0; i < map.outlines.size(); ++i)
        lines.push_back(stroke_of(map.outlines[i], i, place, rule));
    return lines;
}

PaperLines paper_lines(const TactileMap& map, const PaperPlace& place, PaperSize page,
                       const GapRule& rule) {
    const std::vector<SheetStroke> whole = whole_lines(map, place, rule);
    StrokeGrid drawn(page, rule.clear_mm + rule.outer_mm);  // of what is drawn, no more is asked
    PaperLines spaced;
    for (const std::size_t i : by_importance(map, whole)) {
        const auto is_own_part = [&map, i](std::size_t other) {
            const std::string& label = map.outlines[i].label;
            return !label.empty() && map.outlines[other].label == label;
        };
        KeptPieces kept;
        keep(whole[i], drawn, is_own_part, rule, kept);
        if (kept.missing_mm > (1.0 - least_share) * length_mm(whole[i])) {
            spaced.left_out.push_back(i);
            continue;
        }
        if (kept.missing_mm > least_piece_mm) spaced.broken.push_back(i);
        for (SheetStroke& piece : kept.pieces) {
            drawn.add(piece);
            spaced.strokes.push_back(std::move(piece));
        }
    }
    return spaced;
}

}  // namespace touchline
