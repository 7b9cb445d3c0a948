#include "app/documents/trace/finding_things.h"
#include "app/documents/trace/traced.h"
#include "config/types/fields.h"
#include "config/types/map_bytes.h"
#include "config/types/thing_name.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace touchline {
namespace {

constexpr std::uint32_t things_magic = 0x33474946;  // "FIG3"
constexpr std::uint32_t most_things = 20;           // none is smaller than a twentieth of all
constexpr std::uint32_t most_names = 50;            // more than are ever said
constexpr std::uint32_t most_faces = 20;            // more than anybody goes through
constexpr double farthest = 4.0;                    // pictures beyond the picture's sides

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

/// All fields except the name's number.
template <class Fields, class Thing>
void named_fields(Fields& f, Thing& thing) {
    f.number(thing.likelihood, 0.0, 1.0);
    box_fields(f, thing.box);
}

constexpr std::size_t box_bytes = 4 * sizeof(double);
constexpr std::size_t name_bytes = sizeof(std::uint32_t) + sizeof(double) + box_bytes;
constexpr std::size_t face_bytes = box_bytes + sizeof(std::uint32_t);  // without its map

/// These read one record each; false unless it is sound.
bool read_one(ByteReader& bytes, ThingBox& box) {
    box_fields(bytes, box);
    return bytes.is_good() && is_sound(box);
}

bool read_one(ByteReader& bytes, NamedThing& thing) {
    const auto name = thing_name_of(bytes.number<std::uint32_t>());
    const bool is_read =
        read_checked(bytes, thing, [](auto& f, auto& named) { named_fields(f, named); });
    if (name) thing.name = *name;
    return is_read && name && is_sound(thing.box);
}

bool read_one(ByteReader& bytes, DrawnFace& face) {
    box_fields(bytes, face.part);
    auto map = map_of(bytes.raw(bytes.number<std::uint32_t>()));
    if (!bytes.is_good() || !can_be_shown(face.part) || !map || !is_sound(*map)) return false;
    face.map = std::move(*map);
    return true;
}

/// Reads how many there are, and each; false for more than `most`, or for one that is not sound.
template <class Record>
bool read_all(ByteReader& bytes, std::size_t least_bytes, std::uint32_t most,
              std::vector<Record>& records) {
    const auto count = bytes.count(least_bytes);
    if (count > most) return false;
    for (std::uint32_t i = 0; i < count; ++i)
        if (!read_one(bytes, records.emplace_back())) return false;
    return true;
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
    for (const NamedThing& thing : things.names) {
        bytes.number(static_cast<std::uint32_t>(thing.name));
        named_fields(bytes, thing);
    }
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
    MainThings things;
    const bool is_sound =
        bytes.number<std::uint32_t>() == things_magic &&
        read_checked(bytes, things, [](auto& f, auto& seen) { things_fields(f, seen); }) &&
        read_all(bytes, box_bytes, most_things, things.boxes) &&
        read_all(bytes, name_bytes, most_names, things.names) &&
        read_all(bytes, face_bytes, most_faces, things.faces);
    auto mask = grey_of(bytes.raw(bytes.left()));
    if (!is_sound || !bytes.is_good() || !mask)
        return failure("its main thing could not be found safely");
    things.mask = std::move(*mask);
    things.is_sure = things.is_sure && !things.boxes.empty();
    return things;
}

}  // namespace touchline
