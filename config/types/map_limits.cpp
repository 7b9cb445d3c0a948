#include "config/types/map_limits.h"

#include <algorithm>
#include <string>
#include <vector>

namespace touchline {
namespace {

// Every comparison is written so that NaN fails it.
bool is_within(double value, double least, double most) {
    return value >= least && value <= most;
}

bool is_place(Position p) {
    return is_within(p.x, -MapLimits::place_m, MapLimits::place_m) &&
           is_within(p.y, -MapLimits::place_m, MapLimits::place_m);
}

bool is_area(const Area& area) {
    return is_within(area.width_m, 1e-6, MapLimits::area_m) &&
           is_within(area.height_m, 1e-6, MapLimits::area_m);
}

bool is_outline(const Outline& outline) {
    return outline.points.size() >= 2 && outline.detail >= 1 &&
           outline.detail <= MapLimits::most_detail &&
           is_within(outline.weight, MapLimits::least_weight, MapLimits::most_weight) &&
           std::all_of(outline.points.begin(), outline.points.end(), is_place);
}

bool has_id_twice(const TactileMap& map) {
    std::vector<std::string_view> ids;
    for (const Outline& outline : map.outlines) {
        if (!outline.id.empty()) ids.emplace_back(outline.id);
    }
    std::sort(ids.begin(), ids.end());
    return std::adjacent_find(ids.begin(), ids.end()) != ids.end();
}

bool is_too_large(const TactileMap& map) {
    return map.outlines.size() > MapLimits::outlines || map.labels.size() > MapLimits::labels ||
           point_count(map) > MapLimits::points || text_bytes(map) > MapLimits::text_bytes;
}

}  // namespace

std::size_t point_count(const TactileMap& map) {
    std::size_t points = 0;
    for (const Outline& outline : map.outlines) points += outline.points.size();
    return points;
}

std::size_t text_bytes(const TactileMap& map) {
    std::size_t bytes = map.title.size() + map.description.size();
    for (const Outline& outline : map.outlines) bytes += outline.id.size() + outline.label.size();
    for (const Label& label : map.labels) bytes += label.text.size();
    return bytes;
}

std::string_view fault_of(const TactileMap& map) {
    if (is_too_large(map)) {
        return "it holds more outlines, points, labels or text than any picture needs";
    }
    if (!is_area(map.area)) return "its drawing area is not between 1 um and 1 m";
    if (!std::all_of(map.outlines.begin(), map.outlines.end(), is_outline)) {
        return "an outline has fewer than 2 points, a point beyond 1 m, or a weight or detail that "
               "does not exist";
    }
    if (!std::all_of(map.labels.begin(), map.labels.end(),
                     [](const Label& label) { return is_place(label.place); })) {
        return "a label lies beyond 1 m";
    }
    if (has_id_twice(map)) return "two outlines have the same id";
    return {};
}

}  // namespace touchline
