// Several things that one worker looks at, in one piece of memory: the size of each (u64), then one
// behind the other. Threads: pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace touchline {

using ThingsInBytes = std::vector<std::span<const std::byte>>;

[[nodiscard]] inline std::vector<std::byte> joined(const ThingsInBytes& things) {
    std::vector<std::uint64_t> sizes;
    std::size_t all = things.size() * sizeof(std::uint64_t);
    for (const auto thing : things) {
        sizes.push_back(thing.size());
        all += thing.size();
    }
    const auto head = std::as_bytes(std::span(sizes));
    std::vector<std::byte> bytes;
    bytes.reserve(all);
    bytes.assign(head.begin(), head.end());
    for (const auto thing : things) bytes.insert(bytes.end(), thing.begin(), thing.end());
    return bytes;
}

/// The things again; none where there are not so many, or their sizes do not fill the memory.
[[nodiscard]] inline ThingsInBytes parted(std::span<const std::byte> bytes, std::size_t count) {
    std::vector<std::uint64_t> sizes(count);
    const std::size_t head = count * sizeof(std::uint64_t);
    if (bytes.size() < head) return {};
    std::memcpy(sizes.data(), bytes.data(), head);
    auto rest = bytes.subspan(head);
    ThingsInBytes things;
    for (const std::uint64_t size : sizes) {
        if (size > rest.size()) return {};
        things.push_back(rest.first(static_cast<std::size_t>(size)));
        rest = rest.subspan(things.back().size());
    }
    return rest.empty() ? things : ThingsInBytes();
}

}  // namespace touchline
