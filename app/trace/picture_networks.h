// The files of the networks that look at a photograph, in the order in which their worker gets them
// (joined.h). Threads: plain values.
#pragma once

#include "app/trace/joined.h"

#include <cstddef>
#include <span>

namespace touchline {

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
