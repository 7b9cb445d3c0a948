// Several inputs of one worker in one piece of memory: the size of each (u64), then one after the
// other. Threads: pure functions.
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

}  // namespace touchline
