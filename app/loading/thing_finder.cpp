#include "app/loading/thing_finder.h"

#include "app/models/networks.h"
#include "app/trace/finding_things.h"

#include <cstddef>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t most_things = 50;  // a list that nobody goes through

}  // namespace

ThingFinder thing_finder() {
    const Network& network = *network_named("figure");
    if (!is_installed(network)) return {};
    return [&network](const Page& page,
                      const std::optional<PlaceInPicture>& place) -> Result<std::optional<Page>> {
        if (place && page.figures.size() >= most_things) return std::nullopt;
        const auto bytes = read_network(network);
        if (!bytes) return tl::unexpected(bytes.error());
        auto things = place ? find_thing_at(*place, page, *bytes) : find_main_things(page, *bytes);
        if (!things) return tl::unexpected(things.error());
        if (!things->is_sure) return std::nullopt;
        return place ? with_further_thing(page, std::move(*things))
                     : with_main_things(page, std::move(*things));
    };
}

}  // namespace touchline
