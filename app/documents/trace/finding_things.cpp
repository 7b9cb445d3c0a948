#include "app/documents/trace/finding_things.h"

#include "app/documents/trace/page_views.h"
#include "app/documents/trace/tracing.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/worker.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <utility>

namespace touchline {
namespace {

/// The memory that programs can still take without loss to others; all of it if the system does not
/// tell.
std::uint64_t free_memory_bytes() {
    std::ifstream file("/proc/meminfo");
    for (std::string name; file >> name;) {
        std::uint64_t kibibytes = 0;
        if (name == "MemAvailable:" && file >> kibibytes) return kibibytes << 10U;
        file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::numeric_limits<std::uint64_t>::max();
}

constexpr std::uint64_t least_free_bytes = 400'000'000;  // the small networks take 103 MB
constexpr std::uint64_t least_free_for_figure_bytes = 2'000'000'000;
constexpr double margin = 0.07;        // times a thing's longer side
constexpr double most_of_thing = 0.6;  // of a portrait's main thing; least share shown
constexpr double much_of_shown = 0.3;  // of what the face shows; least share of the thing

constexpr SaidOfEnds<const char*> said_of_things{
    "the part of Touchline that finds main things cannot be started safely here; have it installed "
    "anew",
    "finding its main thing takes too long here",
    "finding its main thing needs more memory than there is",
    "its main thing could not be found safely"};

/// A worker refuses by an answer that is no page.
Result<MainThings> things_in(std::span<const std::byte> answer) {
    auto things = main_things_of(answer);
    if (things) return things;
    const auto refused = page_of(answer);
    return refused ? things : tl::unexpected(refused.error());
}

WordBox box_of(const ThingBox& thing, const Picture& picture) {
    const double left_px = thing.left * picture.width;
    const double right_px = thing.right * picture.width;
    const double top_px = thing.top * picture.height;
    const double bottom_px = thing.bottom * picture.height;
    const double margin_px = margin * std::max(right_px - left_px, bottom_px - top_px);
    const auto low = [](double at_px) {
        return static_cast<std::uint16_t>(std::floor(std::max(0.0, at_px)));
    };
    const auto high = [](double at_px, int size_px) {
        return static_cast<std::uint16_t>(std::ceil(std::min<double>(size_px, at_px)));
    };
    return {low(left_px - margin_px), low(top_px - margin_px),
            high(right_px + margin_px, picture.width), high(bottom_px + margin_px, picture.height)};
}

ThingBox within_picture(const ThingBox& part) {
    return {std::max(part.left, 0.0), std::max(part.top, 0.0), std::min(part.right, 1.0),
            std::min(part.bottom, 1.0)};
}

/// True if the face shows most of the main thing, and the thing is much of what is shown: then both
/// are the same person.
bool is_portrait(const ThingBox& thing, const ThingBox& part) {
    const ThingBox shown = within_picture(part);
    const double width = std::min(thing.right, shown.right) - std::max(thing.left, shown.left);
    const double height = std::min(thing.bottom, shown.bottom) - std::max(thing.top, shown.top);
    const double both = std::max(width, 0.0) * std::max(height, 0.0);
    return both >= most_of_thing * area_of(thing) && both >= much_of_shown * area_of(shown);
}

Figure figure_of(DrawnFace face, const Picture& picture) {
    const auto px = [](double share, int size_px) {
        return static_cast<int>(std::lround(share * size_px));
    };
    const ThingBox& part = face.part;
    DrawnPart drawn{px(part.left, picture.width), px(part.top, picture.height),
                    px(part.right, picture.width), px(part.bottom, picture.height),
                    std::move(face.map)};
    drawn.right_px = std::max(drawn.right_px, drawn.left_px + 1);
    drawn.bottom_px = std::max(drawn.bottom_px, drawn.top_px + 1);
    return {box_of(within_picture(part), picture), "",
            std::make_shared<const DrawnPart>(std::move(drawn))};
}

Result<MainThings> found_by_worker(const Page& page, const PictureNetworks& networks,
                                   std::vector<std::string> words) {
    const auto input = sealed_behind(things_of(networks), page);
    if (!input) return tl::unexpected(input.error());
    const auto answer =
        call_worker({companion("touchline-figure"), std::move(words), WorkerKind::figure}, **input);
    if (!answer) return failure(said_of_things[answer.error()]);
    return things_in(answer->bytes());
}

}  // namespace

Result<PictureNetworks> with_room(PictureNetworks networks) {
    const std::uint64_t free_bytes = free_memory_bytes();
    if (free_bytes < least_free_bytes)
        return failure("looking at a photograph needs 400 MB of free memory");
    if (free_bytes < least_free_for_figure_bytes) networks.figure = {};
    return networks;
}

Result<MainThings> find_main_things(const Page& page, const PictureNetworks& networks) {
    return found_by_worker(page, networks, {});
}

Result<MainThings> find_thing_at(const PlaceInPicture& place, const Page& page,
                                 const PictureNetworks& networks) {
    auto found = found_by_worker(page, networks, words_of(place));
    if (found) found->is_sure = found->is_sure && found->boxes.size() == 1;
    return found;
}

Page with_main_things(Page page, MainThings things) {
    page.figures.clear();
    page.names = std::move(things.names);
    std::vector<DrawnFace>& faces = things.faces;
    for (const ThingBox& thing : things.is_sure ? things.boxes : std::vector<ThingBox>()) {
        const auto face = std::ranges::find_if(
            faces, [&thing](const DrawnFace& drawn) { return is_portrait(thing, drawn.part); });
        if (face == faces.end()) {
            page.figures.push_back({box_of(thing, page.picture), ""});
        } else {
            page.figures.push_back(figure_of(std::move(*face), page.picture));
            faces.erase(face);
        }
    }
    for (DrawnFace& face : faces) page.figures.push_back(figure_of(std::move(face), page.picture));
    if (things.is_sure) page.main_things = std::move(things.mask);
    return page;
}

Page with_further_thing(Page page, MainThings thing) {
    for (const ThingBox& box : thing.boxes) page.figures.push_back({box_of(box, page.picture), ""});
    std::vector<std::uint8_t>& known = page.main_things.grey;
    if (known.empty()) {
        page.main_things = std::move(thing.mask);
        return page;
    }
    const bool are_alike =
        thing.mask.width == page.main_things.width && thing.mask.grey.size() == known.size();
    if (!are_alike) return page;  // the worker is not trusted
    std::ranges::transform(known, thing.mask.grey, known.begin(),
                           [](auto one, auto other) { return std::max(one, other); });
    return page;
}

}  // namespace touchline
