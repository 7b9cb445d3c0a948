#include "app/sheets/leader_way.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace touchline {
namespace {

constexpr double leader_step_mm = 0.4;
constexpr double steepest_mm = 7.5;       // way of a leader from its line until it is clear of it
constexpr double least_stretch_mm = 4.0;  // of a piece that does not begin at the line
constexpr int most_breaks = 2;
constexpr double longest_gap_mm = 15.0;  // of a broken leader: further on, no finger finds the rest

/// How near lines are to a place on a leader.
enum class Room : std::uint8_t { taken, near, free };

/// At every sample of the way, steps + 1 of them. The distance to the nearest line changes by no
/// more than the way does, so samples for which it cannot matter are not looked at.
std::vector<Room> rooms_along(PaperPoint from, PaperPoint to, int steps, const StrokeGrid& grid) {
    const double step = distance_mm(from, to) / steps;
    std::vector<Room> rooms;
    while (static_cast<int>(rooms.size()) <= steps) {
        const PaperPoint p = between(from, to, static_cast<double>(rooms.size()) / steps);
        const double clear_mm = grid.near(p).clear_mm - leader_half_mm;
        const Room room = clear_mm < least_clear_mm         ? Room::taken
                          : clear_mm < 2.0 * least_clear_mm ? Room::near
                                                            : Room::free;
        const double same_mm = std::min(std::abs(clear_mm - least_clear_mm),
                                        std::abs(clear_mm - 2.0 * least_clear_mm));
        rooms.insert(rooms.end(), 1 + static_cast<std::size_t>(same_mm / step), room);
    }
    rooms.resize(static_cast<std::size_t>(steps) + 1);
    return rooms;
}

}  // namespace

std::optional<LeaderWay> leader_way(PaperPoint anchor, PaperPoint port, const StrokeGrid& grid) {
    const double length = distance_mm(anchor, port);
    if (!(length >= least_start_mm)) return std::nullopt;
    const int steps = static_cast<int>(std::ceil(length / leader_step_mm));
    const double step = length / steps;
    const std::vector<Room> rooms = rooms_along(anchor, port, steps, grid);
    const auto is_clear = [&rooms](int k) {
        return rooms[static_cast<std::size_t>(k)] != Room::taken;
    };
    int k = 0;
    while (k <= steps && !is_clear(k)) ++k;
    if (k * step > steepest_mm || k > steps) return std::nullopt;

    LeaderWay way;
    way.near_mm = step * static_cast<double>(std::ranges::count(rooms, Room::near));
    const auto add = [&](int from, int to) {
        const bool is_start = from == 0;
        if ((to - from) * step < (is_start ? least_start_mm : least_stretch_mm)) return !is_start;
        way.pieces.push_back({{between(anchor, port, static_cast<double>(from) / steps),
                               between(anchor, port, static_cast<double>(to) / steps)},
                              false,
                              thin_line_mm,
                              StrokeUse::leader,
                              0});
        return true;
    };
    int from = 0;
    for (; k <= steps; ++k) {
        if (is_clear(k)) continue;
        if (!add(from, k - 1)) return std::nullopt;
        while (k <= steps && !is_clear(k)) ++k;
        if (k > steps || ++way.breaks > most_breaks) return std::nullopt;
        from = k;
    }
    if ((steps - from) * step < least_stretch_mm || !add(from, steps)) return std::nullopt;
    for (std::size_t i = 0; i + 1 < way.pieces.size(); ++i)
        if (distance_mm(way.pieces[i].points.back(), way.pieces[i + 1].points.front()) >
            longest_gap_mm)
            return std::nullopt;
    return way;
}

}  // namespace touchline
