#include "app/trace/main_things.h"

#include "app/trace/grey_bytes.h"
#include "app/trace/joined.h"
#include "config/types/face_part.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace touchline {
namespace {

struct ThingsHeader {
    std::uint32_t magic = 0;
    std::uint32_t is_sure = 0;
    std::uint32_t boxes = 0;
    std::uint32_t names = 0;
    std::uint32_t faces = 0;
    std::uint32_t unused = 0;
    FigureSigns signs;
};

struct CrossingName {
    std::uint32_t name = 0;
    std::uint32_t unused = 0;
    double likelihood = 0.0;
    ThingBox box;
};

constexpr std::uint32_t things_magic = 0x32474946;  // "FIG2"
constexpr std::uint32_t most_things = 20;           // none is smaller than a twentieth of all
constexpr std::uint32_t most_names = 50;            // more than are ever said
constexpr std::uint32_t most_faces = 20;            // more than anybody goes through
constexpr double farthest = 4.0;                    // pictures beyond the picture's sides

tl::unexpected<Error> not_safe() {
    return failure("its main thing could not be found safely");
}

bool is_share(double number) {
    return number >= 0.0 && number <= 1.0;
}

bool is_sound(const ThingsHeader& header) {
    const FigureSigns& signs = header.signs;
    return header.magic == things_magic && header.is_sure <= 1 && header.boxes <= most_things &&
           header.names <= most_names && header.faces <= most_faces && is_share(signs.area) &&
           is_share(signs.contrast);
}

/// True if the only texts are names of a face's parts, because every text is spoken.
bool is_sound(const TactileMap& map) {
    return !map.outlines.empty() && map.labels.empty() && map.title.empty() &&
           map.description.empty() && std::ranges::all_of(map.outlines, [](const Outline& outline) {
               return std::ranges::find(face_part_ids, outline.label) != face_part_ids.end();
           });
}

/// Takes flat pieces of memory, one after the other.
class Pieces {
  public:
    explicit Pieces(std::span<const std::byte> bytes) : rest_(bytes) {}

    /// Nothing if there are fewer bytes left.
    template <class Piece>
    std::optional<std::vector<Piece>> take(std::size_t count) {
        const std::size_t size = count * sizeof(Piece);
        if (size > rest_.size()) return std::nullopt;
        std::vector<Piece> pieces(count);
        std::ranges::copy(rest_.first(size), std::as_writable_bytes(std::span(pieces)).begin());
        rest_ = rest_.subspan(size);
        return pieces;
    }

    [[nodiscard]] std::span<const std::byte> rest() const { return rest_; }

  private:
    std::span<const std::byte> rest_;
};

template <class Piece>
void append(const std::vector<Piece>& pieces, std::vector<std::byte>& bytes) {
    const auto more = std::as_bytes(std::span(pieces));
    bytes.insert(bytes.end(), more.begin(), more.end());
}

std::optional<std::vector<NamedThing>> names_in(const std::vector<CrossingName>& crossed) {
    std::vector<NamedThing> names;
    for (const CrossingName& one : crossed) {
        const auto name = thing_name_of(one.name);
        if (!name || !is_sound(one.box) || !is_share(one.likelihood)) return std::nullopt;
        names.push_back({*name, one.box, one.likelihood});
    }
    return names;
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
    std::vector<ThingBox> boxes = things.boxes;
    std::vector<CrossingName> names;
    std::vector<std::vector<std::byte>> parts{bytes_of(things.mask)};
    for (const NamedThing& thing : things.names)
        names.push_back({static_cast<std::uint32_t>(thing.name), 0, thing.likelihood, thing.box});
    for (const DrawnFace& face : things.faces) {
        auto map = bytes_of(face.map);
        if (!map) return map;
        boxes.push_back(face.part);
        parts.push_back(std::move(*map));
    }
    const auto count = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
    const std::vector header{ThingsHeader{things_magic, things.is_sure ? 1U : 0U,
                                          count(things.boxes), count(names), count(things.faces), 0,
                                          things.signs}};
    std::vector<std::byte> bytes;
    append(header, bytes);
    append(boxes, bytes);
    append(names, bytes);
    append(joined(ThingsInBytes(parts.begin(), parts.end())), bytes);
    return bytes;
}

Result<MainThings> main_things_of(std::span<const std::byte> bytes) {
    Pieces pieces(bytes);
    const auto header = pieces.take<ThingsHeader>(1);
    if (!header || !is_sound(header->front())) return not_safe();
    const ThingsHeader& head = header->front();
    auto boxes = pieces.take<ThingBox>(head.boxes);
    const auto faces = pieces.take<ThingBox>(head.faces);
    const auto crossed = pieces.take<CrossingName>(head.names);
    if (!boxes || !faces || !crossed) return not_safe();
    auto names = names_in(*crossed);
    const ThingsInBytes parts = parted(pieces.rest(), head.faces + std::size_t{1});
    const bool are_sound =
        std::ranges::all_of(*boxes, [](const ThingBox& box) { return is_sound(box); }) &&
        std::ranges::all_of(*faces, can_be_shown) && names && !parts.empty();
    if (!are_sound) return not_safe();
    auto mask = grey_of(parts.front());
    if (!mask) return not_safe();
    MainThings things{
        std::move(*mask), std::move(*boxes), head.signs, false, std::move(*names), {}};
    for (std::size_t i = 0; i < faces->size(); ++i) {
        auto map = map_of(parts[i + 1]);
        if (!map || !is_sound(*map)) return not_safe();
        things.faces.push_back({(*faces)[i], std::move(*map)});
    }
    things.is_sure = head.is_sure == 1 && !things.boxes.empty();
    return things;
}

}  // namespace touchline
