#include "app/trace/main_things.h"

#include "app/trace/grey_bytes.h"
#include "config/types/face_part.h"
#include "config/types/fields.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace touchline {
namespace {

constexpr std::uint32_t things_magic = 0x33474946;  // "FIG3"
constexpr std::uint32_t most_things = 20;           // none is smaller than a twentieth of all
constexpr std::uint32_t most_names = 50;            // more than are ever said
constexpr std::uint32_t most_faces = 20;            // more than anybody goes through
constexpr double farthest = 4.0;                    // pictures beyond the picture's sides

tl::unexpected<Error> not_safe() {
    return failure("its main thing could not be found safely");
}

template <class Fields, class Box>
void box_fields(Fields& f, Box& box) {
    f.number(box.left);
    f.number(box.top);
    f.number(box.right);
    f.number(box.bottom);
}

template <class Fields, class Things>
void things_fields(Fields& f, Things& things) {
    f.flag(things.is_sure);
    f.number(things.signs.area, 0.0, 1.0);
    f.number(things.signs.contrast, 0.0, 1.0);
}

/// True if the only texts are names of a face's parts, because every text is spoken.
bool is_sound(const TactileMap& map) {
    return !map.outlines.empty() && map.labels.empty() && map.title.empty() &&
           map.description.empty() && std::ranges::all_of(map.outlines, [](const Outline& outline) {
               return std::ranges::find(face_part_ids, outline.label) != face_part_ids.end();
           });
}

void put(ByteWriter& bytes, const NamedThing& thing) {
    bytes.number(static_cast<std::uint32_t>(thing.name));
    bytes.number(thing.likelihood);
    box_fields(bytes, thing.box);
}

constexpr std::size_t box_bytes = 4 * sizeof(double);
constexpr std::size_t name_bytes = sizeof(std::uint32_t) + sizeof(double) + box_bytes;
constexpr std::size_t face_bytes = box_bytes + sizeof(std::uint32_t);  // without its map

std::optional<NamedThing> named_thing_in(ByteReader& bytes) {
    const auto name = thing_name_of(bytes.number<std::uint32_t>());
    NamedThing thing;
    bytes.number(thing.likelihood);
    box_fields(bytes, thing.box);
    FieldCheck check;
    check.number(thing.likelihood, 0.0, 1.0);
    if (!bytes.is_good() || !name || !check.is_sound() || !is_sound(thing.box)) return std::nullopt;
    thing.name = *name;
    return thing;
}

std::optional<DrawnFace> face_in(ByteReader& bytes) {
    DrawnFace face;
    box_fields(bytes, face.part);
    auto map = map_of(bytes.raw(bytes.number<std::uint32_t>()));
    if (!bytes.is_good() || !can_be_shown(face.part) || !map || !is_sound(*map))
        return std::nullopt;
    face.map = std::move(*map);
    return face;
}

}  // namespace

bool can_be_shown(const ThingBox& part) {
    return part.left < part.right && part.top < part.bottom && part.left < 1.0 && part.top < 1.0 &&
           part.right > 0.0 && part.bottom > 0.0 && part.left >= -farthest &&
           part.top >= -farthest && part.right <= 1.0 + farthest && part.bottom <= 1.0 + farthest;
}

MainThings main_things_of(const Figures& figures) {
    MainThings things;
    things.mask = {
        figures.mask.cols, figures.mask.rows, {figures.mask.begin(), figures.mask.end()}};
    const double width = figures.mask.cols;
    const double height = figures.mask.rows;
    for (const cv::Rect& box : figures.boxes) {
        things.boxes.push_back(
            {box.x / width, box.y / height, box.br().x / width, box.br().y / height});
    }
    things.signs = figures.signs;
    things.is_sure = figures.is_sure;
    return things;
}

Result<std::vector<std::byte>> bytes_of(const MainThings& things) {
    ByteWriter bytes;
    bytes.number(things_magic);
    things_fields(bytes, things);
    bytes.count(things.boxes.size());
    for (const ThingBox& box : things.boxes) box_fields(bytes, box);
    bytes.count(things.names.size());
    for (const NamedThing& thing : things.names) put(bytes, thing);
    bytes.count(things.faces.size());
    for (const DrawnFace& face : things.faces) {
        const auto map = bytes_of(face.map);
        if (!map) return map;
        box_fields(bytes, face.part);
        bytes.count(map->size());
        bytes.raw(*map);
    }
    bytes.raw(bytes_of(things.mask));
    return bytes.take();
}

Result<MainThings> main_things_of(std::span<const std::byte> all) {
    ByteReader bytes(all);
    if (bytes.number<std::uint32_t>() != things_magic) return not_safe();
    MainThings things;
    things_fields(bytes, things);
    FieldCheck check;
    things_fields(check, things);
    const auto boxes = bytes.count(box_bytes);
    if (boxes > most_things || !check.is_sound()) return not_safe();
    for (std::uint32_t i = 0; i < boxes; ++i) {
        box_fields(bytes, things.boxes.emplace_back());
        if (!is_sound(things.boxes.back())) return not_safe();
    }
    const auto names = bytes.count(name_bytes);
    if (names > most_names) return not_safe();
    for (std::uint32_t i = 0; i < names; ++i) {
        const auto name = named_thing_in(bytes);
        if (!name) return not_safe();
        things.names.push_back(*name);
    }
    const auto faces = bytes.count(face_bytes);
    if (faces > most_faces) return not_safe();
    for (std::uint32_t i = 0; i < faces; ++i) {
        auto face = face_in(bytes);
        if (!face) return not_safe();
        things.faces.push_back(std::move(*face));
    }
    auto mask = grey_of(bytes.raw(bytes.left()));
    if (!bytes.is_good() || !mask) return not_safe();
    things.mask = std::move(*mask);
    things.is_sure = things.is_sure && !things.boxes.empty();
    return things;
}

}  // namespace touchline
