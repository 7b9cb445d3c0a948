#include "vision/simplify/silhouettes.h"

#include "vision/contour/junctions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace touchline {
namespace {

/// The lines cut where others end on them, and which of the ends were one line before.
struct Arms {
    std::vector<Chain> chains;
    std::map<Place, std::vector<EndId>> meeting;  // of open ones
    std::map<Place, std::vector<std::pair<EndId, EndId>>> through;
};

std::set<Place> ends_of(const std::vector<Chain>& lines) {
    std::set<Place> ends;
    for (const Chain& line : lines) {
        if (!line.is_closed) {
            ends.insert(place_of(line.points.front().at));
            ends.insert(place_of(line.points.back().at));
        }
    }
    return ends;
}

/// Cuts one line into arms: from junction to junction.
void cut(Chain line, const std::set<Place>& junctions, Arms& arms) {
    const auto is_junction = [&](const EdgePoint& p) { return junctions.contains(place_of(p.at)); };
    if (line.is_closed) {
        const auto first = std::ranges::find_if(line.points, is_junction);
        if (first == line.points.end()) {
            arms.chains.push_back(std::move(line));
            return;
        }
        std::ranges::rotate(line.points, first);
        line.points.push_back(line.points.front());
    }
    const std::size_t before = arms.chains.size();
    std::vector<EdgePoint> points{line.points.front()};
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        points.push_back(line.points[i]);
        if (i + 1 == line.points.size() || is_junction(points.back())) {
            arms.chains.push_back(
                {std::exchange(points, {points.back()}), false, line.width_px, line.of});
        }
    }
    for (std::size_t arm = before; arm < arms.chains.size(); ++arm) {
        arms.meeting[place_of(arms.chains[arm].points.front().at)].push_back(front_of(arm));
        arms.meeting[place_of(arms.chains[arm].points.back().at)].push_back(back_of(arm));
        const bool is_last = arm + 1 == arms.chains.size();
        if (!is_last || line.is_closed) {
            const EndId next = front_of(is_last ? before : arm + 1);
            arms.through[place_of(arms.chains[arm].points.back().at)].emplace_back(back_of(arm),
                                                                                   next);
        }
    }
}

enum class Side { inside, round_a_thing, outside };

Side side_of(const Chain& line, const Outside& outside) {
    constexpr double kMostly = 0.5;
    if (outside.share_of(line) <= kMostly) {
        return Side::inside;
    }
    return outside.share_on_both_sides(line) > kMostly ? Side::outside : Side::round_a_thing;
}

/// Returns the two ends that go round a thing at a junction where everything else lies within it;
/// or none.
std::vector<EndId> round_at(const std::vector<EndId>& meeting, const std::vector<Side>& sides) {
    std::vector<EndId> round;
    for (const EndId end : meeting) {
        const Side side = sides[chain_of(end)];
        if (side == Side::outside) {
            return {};
        }
        if (side == Side::round_a_thing) {
            round.push_back(end);
        }
    }
    return round.size() == 2 ? round : std::vector<EndId>();
}

}  // namespace

std::vector<Chain> with_silhouettes_joined(std::vector<Chain> lines, const Outside& outside) {
    const std::set<Place> junctions = ends_of(lines);
    Arms arms;
    for (Chain& line : lines) {
        cut(std::move(line), junctions, arms);
    }
    std::vector<Side> sides;
    for (const Chain& arm : arms.chains) {
        sides.push_back(side_of(arm, outside));
    }
    JunctionSet set(0.0, 0.0);
    for (const auto& [place, meeting] : arms.meeting) {
        const std::vector<EndId> round = round_at(meeting, sides);
        if (!round.empty()) {
            set.add_joint(round[0], round[1]);
        }
        for (const auto& [a, b] : arms.through[place]) {
            if (!std::ranges::count(round, a) && !std::ranges::count(round, b)) {
                set.add_joint(a, b);
            }
        }
    }
    return set.assembled(std::move(arms.chains));
}

}  // namespace touchline
