#include "haptics/curve/pins.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

namespace touchline {
namespace {

/// Arc length at every vertex; one entry more than points, the last being the whole length.
std::vector<double> arc_lengths(const Outline& outline) {
    const auto& p = outline.points;
    std::vector<double> s(p.size() + 1, 0.0);
    for (std::size_t i = 1; i < p.size(); ++i) s[i] = s[i - 1] + norm(p[i] - p[i - 1]);
    s[p.size()] = s[p.size() - 1] + (outline.is_closed ? norm(p.front() - p.back()) : 0.0);
    return s;
}

/// Walks along an outline once, giving the point at a slowly growing arc length.
class Walker {
  public:
    Walker(const Outline& outline, const std::vector<double>& s) : outline_(outline), s_(s) {}

    Position at(double arc) {
        const double length = s_.back();
        if (!outline_.is_closed) arc = std::clamp(arc, 0.0, length);
        double turns = std::floor(arc / length);
        if (!outline_.is_closed) turns = 0.0;
        const double local = arc - turns * length;
        const std::size_t segments =
            outline_.is_closed ? outline_.points.size() : outline_.points.size() - 1;
        if (s_[segment_] > local) segment_ = 0;  // passed the seam
        while (segment_ + 1 < segments && s_[segment_ + 1] < local) ++segment_;
        const Position a = outline_.points[segment_];
        const Position b = outline_.points[(segment_ + 1) % outline_.points.size()];
        const double span = s_[segment_ + 1] - s_[segment_];
        return a + (span > 0.0 ? (local - s_[segment_]) / span : 0.0) * (b - a);
    }

  private:
    const Outline& outline_;
    const std::vector<double>& s_;
    std::size_t segment_ = 0;
};

/// Corners of one outline, strongest first, none nearer than `apart` to another pin.
std::vector<std::size_t> corners(const Outline& outline, const PinRule& rule) {
    const std::vector<double> turn = turns(outline, rule.reach_m);
    const std::vector<double> s = arc_lengths(outline);
    const double length = s.back();
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < turn.size(); ++i) {
        if (turn[i] > rule.turn_rad) candidates.push_back(i);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](std::size_t a, std::size_t b) { return turn[a] > turn[b]; });
    std::set<double> taken;
    if (!outline.is_closed) taken = {0.0, length};
    const auto is_near = [&](double arc) {
        const auto after = taken.lower_bound(arc - rule.apart_m);
        return after != taken.end() && *after < arc + rule.apart_m;
    };
    std::vector<std::size_t> kept;
    for (const std::size_t i : candidates) {
        const bool wraps = outline.is_closed && (is_near(s[i] - length) || is_near(s[i] + length));
        if (is_near(s[i]) || wraps) continue;
        taken.insert(s[i]);
        kept.push_back(i);
    }
    return kept;
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
    std::sort(ends.begin(), ends.end());
    return ends;
}

}  // namespace

std::vector<double> turns(const Outline& outline, double reach_m) {
    const auto& p = outline.points;
    const std::vector<double> s = arc_lengths(outline);
    // On a small closed outline the two chords must not reach round to each other.
    const double reach = outline.is_closed ? std::min(reach_m, s.back() / 16.0) : reach_m;
    std::vector<double> turn(p.size(), 0.0);
    Walker before(outline, s);
    Walker after(outline, s);
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!outline.is_closed && (i == 0 || i + 1 == p.size())) continue;
        const Position in = p[i] - before.at(s[i] - reach);
        const Position out = after.at(s[i] + reach) - p[i];
        turn[i] = std::abs(std::atan2(cross(in, out), dot(in, out)));
    }
    return turn;
}

std::vector<std::vector<std::size_t>> find_pins(const std::vector<Outline>& outlines,
                                                const PinRule& rule) {
    const std::vector<Place> ends = line_ends(outlines);
    std::vector<std::vector<std::size_t>> pins;
    for (const Outline& outline : outlines) {
        if (outline.points.empty()) {
            pins.emplace_back();
            continue;
        }
        std::vector<std::size_t> own = corners(outline, rule);
        for (std::size_t i = 0; i < outline.points.size(); ++i) {
            if (std::binary_search(ends.begin(), ends.end(), place(outline.points[i]))) {
                own.push_back(i);
            }
        }
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        pins.push_back(std::move(own));
    }
    return pins;
}

}  // namespace touchline
