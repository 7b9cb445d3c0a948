// Repeatable damage, for what reads untrusted bytes. Threads: pure functions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace touchline {

/// Returns the bytes with one to eight of them changed, or a piece cut out, doubled or cut off.
[[nodiscard]] inline std::vector<std::byte> mutated(std::vector<std::byte> bytes,
                                                    std::mt19937& random) {
    if (bytes.empty()) return bytes;
    const auto place = [&] { return static_cast<std::ptrdiff_t>(random() % bytes.size()); };
    switch (random() % 6) {
        case 0:
            bytes.resize(static_cast<std::size_t>(place()) + 1);
            break;
        case 1: {
            const auto [first, last] = std::minmax({place(), place()});
            bytes.erase(bytes.begin() + first, bytes.begin() + last);
            break;
        }
        case 2: {
            const auto [first, last] = std::minmax({place(), place()});
            const std::vector<std::byte> piece(bytes.begin() + first, bytes.begin() + last);
            bytes.insert(bytes.begin() + place(), piece.begin(), piece.end());
            break;
        }
        default:
            for (unsigned hits = 1 + random() % 8; hits > 0; --hits)
                bytes[random() % bytes.size()] = static_cast<std::byte>(random());
    }
    return bytes;
}

}  // namespace touchline
