#include "config/types/map_bytes.h"

#include "config/types/fields.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

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

constexpr std::uint32_t magic = 0x504d4c54;  // "TLMP"
constexpr std::uint32_t layout = 3;
constexpr std::size_t outline_bytes = 25;  // without points and texts
constexpr std::size_t label_bytes = 20;

/// A sound map has no more: what is read of others, too, stays small.
constexpr std::size_t most_bytes = 56 + MapLimits::outlines * outline_bytes +
                                   MapLimits::labels * label_bytes +
                                   MapLimits::points * sizeof(Position) + MapLimits::text_bytes;

tl::unexpected<Error> refused(std::string_view why) {
    return failure("the map cannot be handed over: " + std::string(why));
}

template <class Fields, class Map>
void map_fields(Fields& f, Map& map) {
    f.number(map.area.width_m);
    f.number(map.area.height_m);
    f.number(map.version);
    f.number(map.drawing);
    f.template text<std::uint32_t>(map.title);
    f.template text<std::uint32_t>(map.description);
}

/// An outline without its points.
template <class Fields, class Line>
void outline_fields(Fields& f, Line& outline) {
    f.flag(outline.is_closed);
    f.number(outline.weight);
    f.number(outline.detail);
    f.template text<std::uint32_t>(outline.id);
    f.template text<std::uint32_t>(outline.label);
}

template <class Fields, class Text>
void label_fields(Fields& f, Text& label) {
    f.number(label.place.x);
    f.number(label.place.y);
    f.template text<std::uint32_t>(label.text);
}

void take_points(ByteReader& bytes, std::vector<Position>& points) {
    static_assert(std::is_trivially_copyable_v<Position> && sizeof(Position) == 16);
    points.resize(bytes.count(sizeof(Position)));
    const auto from = bytes.raw(points.size() * sizeof(Position));
    if (!from.empty()) std::memcpy(points.data(), from.data(), from.size());
}

/// Calls `what` with every text of a map.
template <class Map, class What>
void each_text(Map& map, What&& what) {
    what(map.title);
    what(map.description);
    for (auto& outline : map.outlines) {
        what(outline.id);
        what(outline.label);
    }
    for (auto& label : map.labels) what(label.text);
}

bool is_all_utf8(const TactileMap& map) {
    bool is_so = true;
    each_text(map, [&is_so](const std::string& text) { is_so = is_so && is_utf8(text); });
    return is_so;
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

Result<std::vector<std::byte>> bytes_of(const TactileMap& given) {
    TactileMap map = given;
    each_text(map, [](std::string& text) { text = utf8_of(text); });
    if (const std::string_view fault = fault_of(map); !fault.empty()) return refused(fault);
    ByteWriter bytes;
    bytes.number(magic);
    bytes.number(layout);
    map_fields(bytes, map);
    bytes.count(map.outlines.size());
    for (const Outline& outline : map.outlines) {
        outline_fields(bytes, outline);
        bytes.count(outline.points.size());
        bytes.raw(std::as_bytes(std::span(outline.points)));
    }
    bytes.count(map.labels.size());
    for (const Label& label : map.labels) label_fields(bytes, label);
    return bytes.take();
}

Result<TactileMap> map_of(std::span<const std::byte> all) {
    if (all.size() > most_bytes) return refused("it is larger than a map may be");
    ByteReader bytes(all);
    if (bytes.number<std::uint32_t>() != magic || bytes.number<std::uint32_t>() != layout)
        return refused("its bytes do not begin like one");
    TactileMap map;
    map_fields(bytes, map);
    const auto outlines = bytes.count(outline_bytes);
    if (outlines > MapLimits::outlines) return refused("it has too many outlines");
    for (std::uint32_t i = 0; i < outlines && bytes.is_good(); ++i) {
        Outline& outline = map.outlines.emplace_back();
        outline_fields(bytes, outline);
        take_points(bytes, outline.points);
    }
    const auto labels = bytes.count(label_bytes);
    if (labels > MapLimits::labels) return refused("it has too many labels");
    for (std::uint32_t i = 0; i < labels && bytes.is_good(); ++i)
        label_fields(bytes, map.labels.emplace_back());
    if (!bytes.is_at_end()) return refused("its parts do not fit its bytes");
    if (!is_all_utf8(map)) return refused("its texts are no UTF-8");
    if (const std::string_view fault = fault_of(map); !fault.empty()) return refused(fault);
    return map;
}

}  // namespace touchline
