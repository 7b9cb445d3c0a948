#include "app/servo/arrived_scene.h"

#include "config/types/map_bytes.h"

#include <cstddef>
#include <exception>
#include <string>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t most_map_bytes = std::size_t{64} << 20U;

}  // namespace

Result<BuiltScene> scene_of(const Arrival& arrival) {
    try {
        const auto memory = map_sealed(arrival.attached, most_map_bytes);
        if (!memory) return tl::unexpected(memory.error());
        const auto map = map_of(memory->bytes());
        if (!map) return tl::unexpected(map.error());
        auto scene = build_scene(*map, arrival.message.scene);
        if (!scene) return tl::unexpected(scene.error());
        return BuiltScene{
            std::make_shared<const Scene>(std::move(*scene)),
            {map->version, line_of(arrival.message), arrival.message.scene.detail, hash_of(*map)}};
    } catch (const std::exception& problem) {
        return failure(std::string("the scene cannot be built: ") + problem.what());
    }
}

}  // namespace touchline
