#include "app/trace/finding_things.h"

#include "app/process/free_memory.h"
#include "app/process/memory.h"
#include "app/process/places.h"
#include "app/sandbox/worker.h"
#include "app/trace/page_views.h"
#include "app/trace/sealed_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace touchline {
namespace {

constexpr std::uint64_t least_free_bytes = 2'000'000'000;
constexpr double margin = 0.07;  // of a thing's longer side

std::string why_none(WorkerEnd end) {
    switch (end) {
        case WorkerEnd::not_started:
            return "the part of Touchline that finds main things cannot be started safely here; "
                   "have it installed anew";
        case WorkerEnd::out_of_time:
            return "finding its main thing takes too long here";
        case WorkerEnd::out_of_memory:
            return "finding its main thing needs more memory than there is";
        case WorkerEnd::done:
        case WorkerEnd::crashed:
        case WorkerEnd::no_answer:
            return "its main thing could not be found safely";
    }
    return {};
}

/// What a worker answers that refuses is a page that is none.
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

Result<MainThings> found_by_worker(const Page& page, std::span<const std::byte> network,
                                   std::vector<std::string> words) {
    if (free_memory_bytes() < least_free_bytes)
        return failure("finding its main thing needs 2 GB of free memory");
    const auto input = sealed_behind(network, page);
    if (!input) return tl::unexpected(input.error());
    auto outcome =
        run_worker({companion("touchline-figure"), std::move(words), WorkerKind::figure}, **input);
    if (outcome.end != WorkerEnd::done) return failure(why_none(outcome.end));
    const auto answer = map_sealed(outcome.output, limits_of(WorkerKind::figure).file_bytes);
    if (!answer) return failure(why_none(WorkerEnd::no_answer));
    return things_in(answer->bytes());
}

}  // namespace

Result<MainThings> find_main_things(const Page& page, std::span<const std::byte> network) {
    return found_by_worker(page, network, {});
}

Result<MainThings> find_thing_at(const PlaceInPicture& place, const Page& page,
                                 std::span<const std::byte> network) {
    auto found = found_by_worker(page, network, words_of(place));
    if (found) found->is_sure = found->is_sure && found->boxes.size() == 1;
    return found;
}

Page with_main_things(Page page, MainThings things) {
    page.figures.clear();
    for (const ThingBox& thing : things.boxes)
        page.figures.push_back({box_of(thing, page.picture), ""});
    page.main_things = std::move(things.mask);
    return page;
}

Page with_further_thing(Page page, MainThings thing) {
    if (!has_main_things(page)) return with_main_things(std::move(page), std::move(thing));
    for (const ThingBox& box : thing.boxes) page.figures.push_back({box_of(box, page.picture), ""});
    const bool are_alike = thing.mask.width == page.main_things.width &&
                           thing.mask.grey.size() == page.main_things.grey.size();
    if (!are_alike) return page;  // the worker's word is not taken for it
    std::ranges::transform(page.main_things.grey, thing.mask.grey, page.main_things.grey.begin(),
                           [](auto known, auto further) { return std::max(known, further); });
    return page;
}

}  // namespace touchline
