#include "tests/vision/simplify/touch_rules.h"

#include "config/types/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

constexpr double sample_pitch_mm = 0.3;

struct Place {
    Position at;  // millimetres
    std::size_t outline = 0;
    double along_mm = 0.0;
};

std::vector<Position> in_mm(const Outline& outline) {
    std::vector<Position> points;
    for (const Position& p : outline.points) points.push_back(1000.0 * p);
    if (outline.is_closed) points.push_back(points.front());
    return points;
}

std::vector<Place> places_along(const std::vector<Position>& points, std::size_t number) {
    std::vector<Place> places;
    double along_mm = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Position step = points[i + 1] - points[i];
        const int parts = 1 + static_cast<int>(norm(step) / sample_pitch_mm);
        for (int k = 0; k < parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            places.push_back({points[i] + t * step, number, along_mm + t * norm(step)});
        }
        along_mm += norm(step);
    }
    places.push_back({points.back(), number, along_mm});
    return places;
}

double distance_to(const std::vector<Position>& points, Position p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Position along = points[i + 1] - points[i];
        const double squared = dot(along, along);
        const double t =
            squared > 0.0 ? std::clamp(dot(p - points[i], along) / squared, 0.0, 1.0) : 0.0;
        best = std::min(best, norm(points[i] + t * along - p));
    }
    return best;
}

/// Returns how far an end of an outline is from the others, and from its own points beyond the
/// gap's reach.
double end_to_lines(const TactileMap& map, std::size_t number, bool at_back, double apart_mm) {
    const std::vector<Position> own = in_mm(map.outlines[number]);
    const Position end = at_back ? own.back() : own.front();
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        if (i != number) best = std::min(best, distance_to(in_mm(map.outlines[i]), end));
    }
    const std::vector<Place> places = places_along(own, number);
    for (const Place& place : places) {
        const double along_mm = at_back ? places.back().along_mm - place.along_mm : place.along_mm;
        if (along_mm > apart_mm) best = std::min(best, norm(place.at - end));
    }
    return best;
}

/// Returns where an outline turns by more than 40 degrees within 2 mm.
std::vector<Place> corners_of(const Outline& outline, std::size_t number) {
    const std::vector<Place> places = places_along(in_mm(outline), number);
    const auto reach = static_cast<std::size_t>(std::lround(1.0 / sample_pitch_mm));
    const std::size_t n = places.size() - (outline.is_closed ? 1 : 0);
    std::vector<Place> corners;
    for (std::size_t k = 0; k < n && n > 2 * reach; ++k) {
        if (!outline.is_closed && (k < reach || k + reach >= n)) continue;
        const Position in = places[k].at - places[(k + n - reach) % n].at;
        const Position out = places[(k + reach) % n].at - places[k].at;
        if (std::abs(std::atan2(cross(in, out), dot(in, out))) > radians(40.0))
            corners.push_back(places[k]);
    }
    return corners;
}

/// Whether the way along an outline from a to b is straight but for one corner, to half a
/// millimetre.
bool are_sides_of_a_corner(const Place& a, const Place& b, const std::vector<Place>& corners,
                           double around_mm) {
    const auto [low, high] = std::minmax(a.along_mm, b.along_mm);
    return std::ranges::any_of(corners, [&, low = low, high = high](const Place& corner) {
        const bool is_between = corner.along_mm >= low && corner.along_mm <= high;
        const double way_mm = is_between ? high - low : around_mm - (high - low);
        return way_mm - norm(a.at - corner.at) - norm(corner.at - b.at) < 0.5;
    });
}

bool holds(const std::vector<Position>& ring, Position p) {
    bool is_inside = false;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const Position a = ring[i];
        const Position b = ring[i + 1];
        is_inside ^=
            (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    }
    return is_inside;
}

/// Whether neither of two rings is within the other: a finger finds both 3.2 mm apart.
bool are_beside(const Outline& a, const Outline& b) {
    const auto first_mm = [](const Outline& outline) { return 1000.0 * outline.points.front(); };
    return &a != &b && a.is_closed && b.is_closed && !holds(in_mm(a), first_mm(b)) &&
           !holds(in_mm(b), first_mm(a));
}

/// Returns where spacing does not count: at ends on or just short of a line, and at corners.
std::vector<Position> exempt(const TactileMap& map, double gap_mm) {
    std::vector<Position> centres;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const Outline& outline = map.outlines[i];
        for (const bool at_back : {false, true}) {
            const std::vector<Position> points = in_mm(outline);
            if (!outline.is_closed && end_to_lines(map, i, at_back, 4.0 * gap_mm) < 2.6) {
                centres.push_back(at_back ? points.back() : points.front());
            }
        }
        for (const Place& corner : corners_of(outline, i)) centres.push_back(corner.at);
    }
    return centres;
}

void judge_spacing(const TactileMap& map, const TouchRules& rules,
                   std::vector<std::string>& faults) {
    const std::vector<Position> centres = exempt(map, rules.gap_mm);
    std::vector<Place> places;
    std::vector<double> lengths;
    std::vector<std::vector<Place>> corners;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const std::vector<Place> own = places_along(in_mm(map.outlines[i]), i);
        lengths.push_back(map.outlines[i].is_closed ? own.back().along_mm
                                                    : std::numeric_limits<double>::infinity());
        corners.push_back(corners_of(map.outlines[i], i));
        std::ranges::copy_if(own, std::back_inserter(places), [&](const Place& place) {
            return std::ranges::none_of(centres, [&](const Position& centre) {
                return norm(place.at - centre) <= rules.gap_mm + rules.bridge_mm;
            });
        });
    }
    std::ranges::sort(places, {}, [](const Place& place) { return place.at.x; });
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t k = i + 1;
             k < places.size() && places[k].at.x - places[i].at.x < rules.gap_mm; ++k) {
            const Place& a = places[i];
            const Place& b = places[k];
            double along_mm = std::numeric_limits<double>::infinity();
            if (a.outline == b.outline) {
                along_mm = std::abs(a.along_mm - b.along_mm);
                along_mm = std::min(along_mm, lengths[a.outline] - along_mm);
            }
            const double apart_mm = norm(a.at - b.at);
            if (along_mm > 4.0 * rules.gap_mm && apart_mm < rules.gap_mm - 1e-6 &&
                !(apart_mm > 3.2 && are_beside(map.outlines[a.outline], map.outlines[b.outline])) &&
                !(a.outline == b.outline &&
                  are_sides_of_a_corner(a, b, corners[a.outline], lengths[a.outline]))) {
                faults.push_back(
                    fmt::format("{} and {} are {:.3f} mm apart at {:.2f}, {:.2f}; {:.1f} mm along",
                                map.outlines[a.outline].id, map.outlines[b.outline].id, apart_mm,
                                a.at.x, a.at.y, along_mm));
                return;
            }
        }
    }
}

// --- Crossings, in whole nanometres --------------------------------------------------------------

struct Nanometres {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend bool operator==(const Nanometres&, const Nanometres&) = default;
};

struct Piece {
    Nanometres a;
    Nanometres b;
    std::size_t outline = 0;
};

Nanometres on_grid(Position p) {
    // W's origin may lie half a nanometre beside the grid of the viewBox, so count in halves.
    return {std::llround(2e9 * p.x), std::llround(2e9 * p.y)};
}

/// Says on which side of a b the point c lies; exact for coordinates of at most half a metre.
int side(const Nanometres& a, const Nanometres& b, const Nanometres& c) {
    const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

void judge_crossings(const TactileMap& map, std::vector<std::string>& faults) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const Outline& outline = map.outlines[i];
        const std::size_t n = outline.points.size();
        for (std::size_t k = 0; k + (outline.is_closed ? 0 : 1) < n; ++k) {
            pieces.push_back({on_grid(outline.points[k]), on_grid(outline.points[(k + 1) % n]), i});
        }
    }
    const auto left = [](const Piece& piece) { return std::min(piece.a.x, piece.b.x); };
    std::ranges::sort(pieces, {}, left);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& s = pieces[i];
        for (std::size_t k = i + 1; k < pieces.size() && left(pieces[k]) <= std::max(s.a.x, s.b.x);
             ++k) {
            const Piece& t = pieces[k];
            if (side(s.a, s.b, t.a) * side(s.a, s.b, t.b) < 0 &&
                side(t.a, t.b, s.a) * side(t.a, t.b, s.b) < 0) {
                faults.push_back(fmt::format("{} and {} cross at {:.3f}, {:.3f}",
                                             map.outlines[s.outline].id, map.outlines[t.outline].id,
                                             5e-7 * static_cast<double>(s.a.x),
                                             5e-7 * static_cast<double>(s.a.y)));
                return;
            }
        }
    }
}

}  // namespace

TouchRules touch_rules(int detail, const Area& area) {
    constexpr std::array<TouchRules, 5> table{{{2, 600.0, 60.0, 12.0},
                                               {5, 1000.0, 40.0, 8.0},
                                               {9, 1500.0, 25.0, 6.0},
                                               {16, 2500.0, 15.0, 5.0},
                                               {40, 5000.0, 10.0, 3.2}}};
    TouchRules rules = table[static_cast<std::size_t>(detail - 1)];
    const double scale = std::hypot(area.width_m, area.height_m) / 0.215;
    rules.strokes = std::max(2, static_cast<int>(std::floor(rules.strokes * scale)));
    rules.line_mm *= scale;
    rules.stroke_mm *= scale;
    return rules;
}

double length_of(const Outline& outline) {
    const std::vector<Position> points = in_mm(outline);
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += norm(points[i] - points[i - 1]);
    return sum;
}

std::vector<std::string> faults_of(const TactileMap& map, const TouchRules& rules) {
    std::vector<std::string> faults;
    if (static_cast<int>(map.outlines.size()) > rules.strokes) {
        faults.push_back(fmt::format("{} outlines", map.outlines.size()));
    }
    double line_mm = 0.0;
    for (const Outline& outline : map.outlines) {
        const double length_mm = length_of(outline);
        line_mm += length_mm;
        if (length_mm < rules.stroke_mm - 1e-3) {
            faults.push_back(fmt::format("{} is {:.1f} mm long", outline.id, length_mm));
        }
    }
    if (line_mm > rules.line_mm + 1e-3) {
        faults.push_back(fmt::format("{:.1f} mm of line", line_mm));
    }
    judge_spacing(map, rules, faults);
    judge_crossings(map, faults);
    return faults;
}

double covered_share(const std::vector<Position>& ring, const TactileMap& map, double reach_mm) {
    std::vector<Position> closed = ring;
    closed.push_back(ring.front());
    const std::vector<Place> places = places_along(closed, 0);
    std::vector<std::vector<Position>> lines;
    for (const Outline& outline : map.outlines) lines.push_back(in_mm(outline));
    const auto covered = std::ranges::count_if(places, [&](const Place& place) {
        return std::ranges::any_of(lines, [&](const std::vector<Position>& line) {
            return distance_to(line, place.at) <= reach_mm;
        });
    });
    return static_cast<double>(covered) / static_cast<double>(places.size());
}

}  // namespace touchline::testing
