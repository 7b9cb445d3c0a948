// Two things that one worker looks at, in one piece of memory: the size of the first (u64), the
// first, the second. Threads: pure functions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace touchline {

struct TwoParts {
    std::span<const std::byte> first;
    std::span<const std::byte> second;
};

[[nodiscard]] inline std::vector<std::byte> bytes_of(const TwoParts& parts) {
    const std::uint64_t size = parts.first.size();
    std::vector<std::byte> bytes(sizeof size + parts.first.size() + parts.second.size());
    std::memcpy(bytes.data(), &size, sizeof size);
    const auto second = std::ranges::copy(parts.first, bytes.begin() + sizeof size).out;
    std::ranges::copy(parts.second, second);
    return bytes;
}

/// Both are empty where the sizes do not fit.
[[nodiscard]] inline TwoParts two_parts_of(std::span<const std::byte> bytes) {
    std::uint64_t size = 0;
    if (bytes.size() < sizeof size) return {};
    std::memcpy(&size, bytes.data(), sizeof size);
    const auto rest = bytes.subspan(sizeof size);
    if (size > rest.size()) return {};
    const auto first_bytes = static_cast<std::size_t>(size);
    return {rest.first(first_bytes), rest.subspan(first_bytes)};
}

}  // namespace touchline
