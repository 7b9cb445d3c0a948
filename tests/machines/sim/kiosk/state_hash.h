// A state as one number, the same wherever the same numbers were computed. Threads: a plain value.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace touchline {

class StateHash {
  public:
    void mix(std::uint64_t bits) {
        state_ = (state_ ^ bits) * 0x9fb21c651e98df25ULL;
        state_ ^= state_ >> 35U;
    }

    void mix(double value) { mix(std::bit_cast<std::uint64_t>(value)); }

    void mix(std::string_view text) {
        for (const char letter : text) mix(static_cast<std::uint64_t>(letter));
    }

    [[nodiscard]] std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace touchline
