// A network and the picture that it looks at, in one piece of memory: the size of the network
// (u64), the network, the picture. Threads: pure functions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace touchline {

struct NetworkInput {
    std::span<const std::byte> network;
    std::span<const std::byte> picture;
};

[[nodiscard]] inline std::vector<std::byte> bytes_of(const NetworkInput& input) {
    const std::uint64_t size = input.network.size();
    std::vector<std::byte> bytes(sizeof size + input.network.size() + input.picture.size());
    std::memcpy(bytes.data(), &size, sizeof size);
    const auto picture = std::ranges::copy(input.network, bytes.begin() + sizeof size).out;
    std::ranges::copy(input.picture, picture);
    return bytes;
}

/// Both are empty where the sizes do not fit.
[[nodiscard]] inline NetworkInput network_input_of(std::span<const std::byte> bytes) {
    std::uint64_t size = 0;
    if (bytes.size() < sizeof size) return {};
    std::memcpy(&size, bytes.data(), sizeof size);
    const auto rest = bytes.subspan(sizeof size);
    if (size > rest.size()) return {};
    const auto network_bytes = static_cast<std::size_t>(size);
    return {rest.first(network_bytes), rest.subspan(network_bytes)};
}

}  // namespace touchline
