#include "app/loading/thing_finder.h"

#include "app/models/picture_network_files.h"
#include "app/trace/finding_things.h"

#include <cstddef>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t most_things = 50;  // a list that nobody goes through

}  // namespace

ThingFinder thing_finder() {
    return [](const Page& page,
              const std::optional<PlaceInPicture>& place) -> Result<std::optional<Page>> {
        if (place && page.figures.size() >= most_things) return std::nullopt;
        const auto files = read_picture_networks();
        if (!files) return tl::unexpected(files.error());
        const auto networks = with_room(files->networks());
        if (!networks) return tl::unexpected(networks.error());
        auto things =
            place ? find_thing_at(*place, page, *networks) : find_main_things(page, *networks);
        if (!things) return tl::unexpected(things.error());
        if (place && !things->is_sure) return std::nullopt;
        if (place) return with_further_thing(page, std::move(*things));
        Page seen = with_main_things(page, std::move(*things));
        seen.was_searched = !networks->figure.empty();
        return seen;
    };
}

}  // namespace touchline
