#include "app/documents/packs/unpack_work.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

namespace touchline {
namespace {

constexpr double step_m = 0.0005;
constexpr double meeting_m = 0.0004;       // lines that cross have samples at most this far apart
constexpr double meeting_reach_m = 0.008;  // lines are always near each other around a meeting
constexpr std::size_t most_samples = 200'000;
constexpr std::size_t most_looks = 2'000'000;  // a map with room needs some 400 000
constexpr std::size_t most_meetings = 200;     // of two outlines; with more, they are one line

struct Sample {
    Position place;
    std::size_t outline = 0;
    double along_m = 0.0;  // along the outline
};

struct Sampled {
    std::vector<Sample> samples;
    std::vector<double> length_m;  // one for each outline
};

Sampled sampled(const TactileMap& map) {
    Sampled made;
    for (std::size_t o = 0; o < map.outlines.size(); ++o) {
        const Outline& outline = map.outlines[o];
        const std::size_t n = outline.points.size();
        double along = 0.0;
        for (std::size_t i = 0; i + (outline.is_closed ? 0 : 1) < n; ++i) {
            const Position from = outline.points[i];
            const Position edge = outline.points[(i + 1) % n] - from;
            const double length = norm(edge);
            const int parts = 1 + static_cast<int>(std::min(length / step_m, 1e4));
            for (int k = 0; k < parts && made.samples.size() < most_samples; ++k) {
                const double share = static_cast<double>(k) / parts;
                made.samples.push_back({from + share * edge, o, along + share * length});
            }
            along += length;
        }
        if (!outline.is_closed) made.samples.push_back({outline.points.back(), o, along});
        made.length_m.push_back(along);
    }
    return made;
}

/// Squares of least_gap_m, so that all nearer samples lie in nine of them.
class Grid {
  public:
    explicit Grid(const std::vector<Sample>& samples) : samples_(samples) {
        for (std::size_t i = 0; i < samples.size(); ++i)
            cells_[key(cell(samples[i].place.x), cell(samples[i].place.y))].push_back(i);
    }

    /// Returns false as soon as `visit` does.
    template <class Visit>
    bool near(const Sample& from, const Visit& visit) const {
        const auto x = cell(from.place.x);
        const auto y = cell(from.place.y);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                const auto found = cells_.find(key(x + dx, y + dy));
                if (found == cells_.end()) continue;
                for (const std::size_t i : found->second)
                    if (!visit(samples_[i])) return false;
            }
        return true;
    }

  private:
    static std::int64_t cell(double value_m) {
        return static_cast<std::int64_t>(std::floor(value_m / least_gap_m));
    }

    static std::int64_t key(std::int64_t x, std::int64_t y) { return x * 1'000'003 + y; }

    const std::vector<Sample>& samples_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

using Pair = std::pair<std::size_t, std::size_t>;

/// True for two places of different outlines, or of one outline that are no neighbours on it.
bool are_apart(const Sample& a, const Sample& b, const TactileMap& map, double length_m) {
    if (a.outline != b.outline) return true;
    const double along = std::abs(a.along_m - b.along_m);
    const bool is_closed = map.outlines[a.outline].is_closed;
    return (is_closed ? std::min(along, length_m - along) : along) > 2.0 * meeting_reach_m;
}

struct Nearness {
    std::vector<Position> meetings;
    double gap_m = std::numeric_limits<double>::infinity();
};

bool is_at_meeting(const std::vector<Position>& meetings, Position place) {
    return std::ranges::any_of(
        meetings, [place](Position meeting) { return norm(place - meeting) < meeting_reach_m; });
}

}  // namespace

std::vector<NearLines> near_lines(const TactileMap& map, std::size_t most) {
    const Sampled all = sampled(map);
    const Grid grid(all.samples);
    std::map<Pair, Nearness> pairs;
    const auto every_near_pair = [&](const auto& visit) {
        std::size_t looks_left = most_looks;
        for (const Sample& a : all.samples) {
            const bool goes_on = grid.near(a, [&](const Sample& b) {
                const bool is_other =
                    b.outline >= a.outline && are_apart(a, b, map, all.length_m[a.outline]);
                if (is_other) visit(pairs, a, b, norm(a.place - b.place));
                return --looks_left > 0;
            });
            if (!goes_on) return;
        }
    };
    every_near_pair([](auto& found, const Sample& a, const Sample& b, double gap_m) {
        if (gap_m > meeting_m) return;
        auto& meetings = found[{a.outline, b.outline}].meetings;
        if (meetings.size() == most_meetings) return;
        // Keeps one per place: a line that two outlines share would give thousands.
        const bool is_new = std::ranges::none_of(
            meetings, [&](Position meeting) { return norm(meeting - a.place) < 2.0 * step_m; });
        if (is_new) meetings.push_back(a.place);
    });
    every_near_pair([](auto& found, const Sample& a, const Sample& b, double gap_m) {
        if (gap_m >= least_gap_m) return;
        Nearness& nearness = found[{a.outline, b.outline}];
        if (gap_m < nearness.gap_m && !is_at_meeting(nearness.meetings, a.place))
            nearness.gap_m = gap_m;
    });
    std::vector<NearLines> near;
    for (const auto& [pair, nearness] : pairs)
        if (nearness.gap_m < least_gap_m && nearness.meetings.size() < most_meetings)
            near.push_back({pair.first, pair.second, nearness.gap_m});
    std::ranges::sort(near, {}, &NearLines::gap_m);
    if (near.size() > most) near.resize(most);
    return near;
}

std::size_t part_count(const TactileMap& map) {
    std::set<std::string> parts;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const Outline& outline = map.outlines[i];
        const std::string& name = outline.label.empty() ? outline.id : outline.label;
        parts.insert(name.empty() ? '\n' + std::to_string(i) : name);
    }
    return parts.size();
}

double line_length_m(const TactileMap& map) {
    double sum = 0.0;
    for (const Outline& outline : map.outlines) {
        const std::size_t n = outline.points.size();
        for (std::size_t i = 0; i + (outline.is_closed ? 0 : 1) < n; ++i)
            sum += norm(outline.points[(i + 1) % n] - outline.points[i]);
    }
    return sum;
}

int most_parts(int difficulty) {
    constexpr std::array<int, 5> parts{1, 4, 6, 9, 12};
    return parts[static_cast<std::size_t>(std::clamp(difficulty, 1, 5) - 1)];
}

bool is_near_rim(const Outline& outline, const Area& area) {
    constexpr double rounding_m = 1e-9;
    return std::ranges::any_of(outline.points, [&](Position p) {
        return std::abs(p.x) > area.width_m / 2.0 - least_rim_m + rounding_m ||
               std::abs(p.y) > area.height_m / 2.0 - least_rim_m + rounding_m;
    });
}

}  // namespace touchline
