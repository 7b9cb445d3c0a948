#include "haptics/curve/curve_set.h"
#include "haptics/curve/spacing.h"
#include "haptics/curve/wavelet.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

namespace touchline {
namespace {

/// Arc length at every vertex, with one entry more than points: the last is the whole length.
std::vector<double> arc_lengths(const Outline& outline) {
    const auto& p = outline.points;
    std::vector<double> s(p.size() + 1, 0.0);
    for (std::size_t i = 1; i < p.size(); ++i) s[i] = s[i - 1] + norm(p[i] - p[i - 1]);
    s[p.size()] = s[p.size() - 1] + (outline.is_closed ? norm(p.front() - p.back()) : 0.0);
    return s;
}

/// Walks along an outline once and returns the point at an arc length that grows from call to call,
/// from -length to 2 length. Beyond the ends of an open outline it returns the end.
class Walker {
  public:
    Walker(const Outline& outline, const std::vector<double>& s, double from)
        : points_(outline.points.data()),
          s_(s.data()),
          last_(s.size() - (outline.is_closed ? 2 : 3)),
          wrap_(outline.is_closed ? 0 : last_ + 1),
          length_(s.back()),
          is_closed_(outline.is_closed) {
        if (!is_closed_ || from >= 0.0) return;
        passed_ = -length_;
        const double* const end = std::lower_bound(s_ + 1, s_ + last_ + 1, from - passed_);
        segment_ = static_cast<std::size_t>(end - s_) - 1;
    }

    Position at(double arc) {
        if (is_closed_) {
            if (arc - passed_ >= length_) {
                passed_ += length_;
                segment_ = 0;
            }
        } else {
            arc = std::clamp(arc, 0.0, length_);
        }
        const double local = arc - passed_;
        while (segment_ < last_ && s_[segment_ + 1] < local) ++segment_;
        const Position a = points_[segment_];
        const Position b = points_[segment_ == last_ ? wrap_ : segment_ + 1];
        const double span = s_[segment_ + 1] - s_[segment_];
        return a + (span > 0.0 ? (local - s_[segment_]) / span : 0.0) * (b - a);
    }

  private:
    const Position* points_;
    const double* s_;
    std::size_t last_;  // segment
    std::size_t wrap_;  // vertex at the end of the last segment
    double length_;
    bool is_closed_;
    double passed_ = 0.0;  // arc length at the start of this turn round a closed outline
    std::size_t segment_ = 0;
};

/// A vertex where an outline turns, by the products of the chords before and after it.
struct Corner {
    std::size_t vertex = 0;
    double along = 0.0;
    double across = 0.0;  // >= 0

    [[nodiscard]] double turn_rad() const { return std::atan2(across, along); }
};

/// Compares turns with a limit, mostly without an arc tangent.
class TurnLimit {
  public:
    explicit TurnLimit(double limit_rad)
        : limit_rad_(limit_rad), sine_(std::sin(limit_rad)), cosine_(std::cos(limit_rad)) {}

    /// As turn_rad() >= the limit.
    [[nodiscard]] bool is_reached(const Corner& corner) const {
        const double short_of = corner.along * sine_ - corner.across * cosine_;
        const double rounding = 1e-12 * (std::abs(corner.along) + corner.across);
        return short_of < -rounding || (short_of <= rounding && corner.turn_rad() >= limit_rad_);
    }

  private:
    double limit_rad_;
    double sine_;
    double cosine_;
};

/// Returns the vertices of an outline where it turns by more than the rule asks, measured over
/// +-reach (less near the ends of an open outline; the ends themselves do not turn). O(N).
std::vector<Corner> sharp_turns(const Outline& outline, const std::vector<double>& s,
                                const PinRule& rule) {
    const auto& p = outline.points;
    // On a small closed outline the two chords must not reach round to each other.
    const double reach = outline.is_closed ? std::min(rule.reach_m, s.back() / 16.0) : rule.reach_m;
    const double least_rad = rule.turn_rad - 1e-9;  // whatever turns less is surely not sharp
    const TurnLimit sharper(std::nextafter(rule.turn_rad, INFINITY));
    const double sine = std::sin(least_rad);
    const double cosine = std::cos(least_rad);
    const std::size_t margin = outline.is_closed ? 0 : 1;
    std::vector<Corner> sharp;
    sharp.reserve(p.size() / 2);  // a rough line has about as many; memory not written is free
    Walker before(outline, s, -reach);
    Walker after(outline, s, reach);
    double calm_until = 0.0;
    for (std::size_t i = margin; i + margin < p.size(); ++i) {
        if (s[i] < calm_until) continue;
        const Position in = p[i] - before.at(s[i] - reach);
        const Position out = after.at(s[i] + reach) - p[i];
        const double along = dot(in, out);
        const double across = std::abs(cross(in, out));
        // Chords are no longer than the reach and change by at most 2 d over an arc of d, so this
        // value changes by less than 5 d reach: if it is large, no vertex near is sharp.
        const double calm = along * sine - across * cosine;
        if (calm > 0.0) {
            calm_until = s[i] + calm / (5.0 * reach);
            continue;
        }
        const Corner corner{i, along, across};
        if (sharper.is_reached(corner)) sharp.push_back(corner);
    }
    return sharp;
}

/// Returns how sharp a corner must be to be among about a sixteenth of them; all may be as sharp.
double sharp_enough_rad(const std::vector<Corner>& corners) {
    constexpr std::size_t samples = 1024;
    std::vector<double> turns_rad;
    const std::size_t stride = std::max<std::size_t>(1, corners.size() / samples);
    for (std::size_t i = 0; i < corners.size(); i += stride) {
        turns_rad.push_back(corners[i].turn_rad());
    }
    const auto sharp = turns_rad.begin() + static_cast<std::ptrdiff_t>(turns_rad.size() / 16);
    std::nth_element(turns_rad.begin(), sharp, turns_rad.end(), std::greater());
    return *sharp;
}

/// Returns the corners of one outline, none nearer than `apart` to another pin, as if they were
/// taken one by one from the strongest on. Where one is taken, those near drop out, mostly before
/// anyone sorts them.
std::vector<std::size_t> corners(const Outline& outline, const PinRule& rule) {
    const std::vector<double> s = arc_lengths(outline);
    const double length = s.back();
    std::set<double> taken;
    if (!outline.is_closed) taken = {0.0, length};
    const auto is_taken = [&](double arc) {
        const auto after = taken.lower_bound(arc - rule.apart_m);
        return after != taken.end() && *after < arc + rule.apart_m;
    };
    const double seam_m = outline.is_closed ? 2.0 * rule.apart_m : -1.0;  // more than it matters
    const auto is_near = [&](std::size_t vertex) {
        const double arc = s[vertex];
        return is_taken(arc) || (length - arc < seam_m && is_taken(arc - length)) ||
               (arc < seam_m && is_taken(arc + length));
    };
    std::vector<std::size_t> kept;
    std::vector<Corner> rest = sharp_turns(outline, s, rule);
    while (!rest.empty()) {
        const TurnLimit strong_from(sharp_enough_rad(rest));
        std::vector<std::pair<double, std::size_t>> strong;  // turn and vertex
        for (const Corner& corner : rest) {
            if (strong_from.is_reached(corner))
                strong.emplace_back(corner.turn_rad(), corner.vertex);
        }
        std::ranges::stable_sort(strong, std::greater(), &std::pair<double, std::size_t>::first);
        for (const auto& [turn_rad, vertex] : strong) {
            if (is_near(vertex)) continue;
            taken.insert(s[vertex]);
            kept.push_back(vertex);
        }
        std::vector<Corner> weak;
        auto after = taken.begin();  // runs along with the vertices
        for (const Corner& corner : rest) {
            const double arc = s[corner.vertex];
            while (after != taken.end() && *after < arc - rule.apart_m) ++after;
            const bool is_beside = after != taken.end() && *after < arc + rule.apart_m;
            if (is_beside || strong_from.is_reached(corner) || is_near(corner.vertex)) continue;
            weak.push_back(corner);
        }
        rest = std::move(weak);
    }
    return kept;
}

/// Returns the outline with its noise taken out, so that noise is not taken for corners.
Outline without_noise(Outline outline, double noise_m) {
    const std::size_t segments = outline.points.size() - (outline.is_closed ? 0 : 1);
    Decomposition curve = decompose(std::move(outline.points), {segments, 1, outline.is_closed},
                                    halvings(segments, outline.is_closed));
    denoise(curve, noise_m);
    outline.points = reconstruct(curve);
    return outline;
}

using Place = std::pair<double, double>;

Place place(Position p) {
    return {p.x, p.y};
}

/// Places where an open outline ends.
std::vector<Place> line_ends(const std::vector<Outline>& outlines) {
    std::vector<Place> ends;
    for (const Outline& outline : outlines) {
        if (outline.is_closed || outline.points.empty()) continue;
        ends.push_back(place(outline.points.front()));
        ends.push_back(place(outline.points.back()));
    }
    std::ranges::sort(ends);
    return ends;
}

}  // namespace

std::vector<std::vector<std::size_t>> find_pins(const std::vector<Outline>& outlines,
                                                const PinRule& rule) {
    const std::vector<Place> ends = line_ends(outlines);
    std::vector<std::vector<std::size_t>> pins;
    for (const Outline& outline : outlines) {
        if (outline.points.empty()) {
            pins.emplace_back();
            continue;
        }
        std::vector<std::size_t> own = rule.noise_m > 0.0
                                           ? corners(without_noise(outline, rule.noise_m), rule)
                                           : corners(outline, rule);
        for (std::size_t i = 0; i < outline.points.size() && !ends.empty(); ++i) {
            if (std::ranges::binary_search(ends, place(outline.points[i]))) {
                own.push_back(i);
            }
        }
        std::ranges::sort(own);
        own.erase(std::unique(own.begin(), own.end()), own.end());
        pins.push_back(std::move(own));
    }
    return pins;
}

}  // namespace touchline
