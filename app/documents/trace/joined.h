// Several inputs of one worker in one piece of memory: the size of each (u64), then one after the
// other; and the files of the networks that look at a photograph, in their order among the inputs.
// Threads: values and pure functions.
#pragma once

#include "config/types/fields.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

using ThingsInBytes = std::vector<std::span<const std::byte>>;

[[nodiscard]] inline std::vector<std::byte> joined(const ThingsInBytes& things) {
    std::size_t all = things.size() * sizeof(std::uint64_t);
    for (const auto thing : things) all += thing.size();
    ByteWriter bytes;
    bytes.reserve(all);
    for (const auto thing : things) bytes.number(std::uint64_t{thing.size()});
    for (const auto thing : things) bytes.raw(thing);
    return bytes.take();
}

/// Separates them again; empty if there are not so many, or their sizes do not fill the memory.
[[nodiscard]] inline ThingsInBytes parted(std::span<const std::byte> all, std::size_t count) {
    ByteReader bytes(all);
    std::vector<std::uint64_t> sizes(count);
    for (std::uint64_t& size : sizes) bytes.number(size);
    ThingsInBytes things;
    for (const std::uint64_t size : sizes) things.push_back(bytes.raw(size));
    return bytes.is_at_end() ? things : ThingsInBytes();
}

/// The files of the networks (app/documents/models).
struct PictureNetworks {
    std::span<const std::byte> figure = {};  // empty: it is not installed
    std::span<const std::byte> names = {};
    std::span<const std::byte> faces = {};
    std::span<const std::byte> meshes = {};
    std::span<const std::byte> persons = {};
};

inline constexpr std::size_t picture_network_count = 5;

[[nodiscard]] inline ThingsInBytes things_of(const PictureNetworks& networks) {
    return {networks.figure, networks.names, networks.faces, networks.meshes, networks.persons};
}

/// Takes the first of `things`, which must hold at least as many.
[[nodiscard]] inline PictureNetworks networks_in(const ThingsInBytes& things) {
    return {things[0], things[1], things[2], things[3], things[4]};
}

}  // namespace touchline
