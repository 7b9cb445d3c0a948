#include "haptics/curve/curve_set.h"
#include "haptics/curve/spacing.h"
#include "haptics/curve/wavelet.h"

#include <algorithm>
#include <cmath>
#include <functional>
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

struct Corner {
    std::size_t vertex = 0;
    double turn_rad = 0.0;
};

/// Returns the vertices of an outline where it turns by more than the rule asks, measured over
/// +-reach (less near the ends of an open outline; the ends themselves do not turn). O(N).
std::vector<Corner> sharp_turns(const Outline& outline, const std::vector<double>& s,
                                const PinRule& rule) {
    const auto& p = outline.points;
    // On a small closed outline the two chords must not reach round to each other.
    const double reach = outline.is_closed ? std::min(rule.reach_m, s.back() / 16.0) : rule.reach_m;
    const double least_rad = rule.turn_rad - 1e-9;  // the arc tangent decides on the limit itself
    const double sine = std::sin(least_rad);
    const double cosine = std::cos(least_rad);
    const std::size_t margin = outline.is_closed ? 0 : 1;
    std::vector<Corner> sharp;
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
        const double turn_rad = std::atan2(across, along);
        if (turn_rad > rule.turn_rad) sharp.push_back({i, turn_rad});
    }
    return sharp;
}

/// Returns the corners of one outline, strongest first, none nearer than `apart` to another pin.
std::vector<std::size_t> corners(const Outline& outline, const PinRule& rule) {
    const std::vector<double> s = arc_lengths(outline);
    const double length = s.back();
    std::vector<Corner> candidates = sharp_turns(outline, s, rule);
    std::ranges::stable_sort(candidates, std::greater(), &Corner::turn_rad);
    std::set<double> taken;
    if (!outline.is_closed) taken = {0.0, length};
    const auto is_near = [&](double arc) {
        const auto after = taken.lower_bound(arc - rule.apart_m);
        return after != taken.end() && *after < arc + rule.apart_m;
    };
    std::vector<std::size_t> kept;
    for (const Corner& corner : candidates) {
        const double arc = s[corner.vertex];
        const bool wraps = outline.is_closed && (is_near(arc - length) || is_near(arc + length));
        if (is_near(arc) || wraps) continue;
        taken.insert(arc);
        kept.push_back(corner.vertex);
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

/// Finds the vertex nearest to a place, the first of several. It passes over runs of vertices whose
/// bounds are too far away.
class NearestVertex {
  public:
    explicit NearestVertex(std::span<const Position> points) : points_(points) {
        for (std::size_t first = 0; first < points.size(); first += run) {
            Bounds bounds{points[first], points[first]};
            for (const Position p : points.subspan(first, std::min(run, points.size() - first))) {
                bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y)};
                bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y)};
            }
            bounds_.push_back(bounds);
        }
    }

    [[nodiscard]] std::size_t near(Position place) const {
        std::size_t nearest = 0;
        double least_m2 = INFINITY;
        for (std::size_t i = 0; i < bounds_.size(); ++i) {
            const auto& [low, high] = bounds_[i];
            const Position out{std::max({low.x - place.x, place.x - high.x, 0.0}),
                               std::max({low.y - place.y, place.y - high.y, 0.0})};
            if (dot(out, out) >= least_m2) continue;
            const std::size_t end = std::min((i + 1) * run, points_.size());
            for (std::size_t k = i * run; k < end; ++k) {
                const Position way = points_[k] - place;
                if (dot(way, way) >= least_m2) continue;
                least_m2 = dot(way, way);
                nearest = k;
            }
        }
        return nearest;
    }

  private:
    static constexpr std::size_t run = 64;

    struct Bounds {
        Position low, high;
    };

    std::span<const Position> points_;
    std::vector<Bounds> bounds_;
};

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

void add_pins(const std::vector<Outline>& outlines, std::span<const PinPlace> wanted,
              std::vector<std::vector<std::size_t>>& pins) {
    std::vector<PinPlace> places(wanted.begin(), wanted.end());
    std::ranges::stable_sort(places, {}, &PinPlace::outline);
    for (auto pin = places.begin(); pin != places.end();) {
        const auto outline = static_cast<std::size_t>(pin->outline);
        const NearestVertex vertices(outlines[outline].points);
        std::vector<std::size_t>& own = pins[outline];
        for (; pin != places.end() && pin->outline == static_cast<int>(outline); ++pin) {
            if (!outlines[outline].points.empty()) own.push_back(vertices.near(pin->place));
        }
        std::ranges::sort(own);
        own.erase(std::unique(own.begin(), own.end()), own.end());
    }
}

}  // namespace touchline
