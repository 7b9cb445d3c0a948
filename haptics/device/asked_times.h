// When a device was asked for its place: an answer that is not to the newest question is late.
// Threads: a plain value. O(1).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace touchline {

class AskedTimes {
  public:
    /// On any clock that never goes back.
    void ask(double now_s) { times_s_[++asked_ % times_s_.size()] = now_s; }

    /// Returns by how much an answer to the question `behind` ones before the newest is later than
    /// one to the newest: 0 for the newest itself. Knows the last sixteen questions.
    [[nodiscard]] double late_s(std::uint64_t behind) const {
        const std::uint64_t known = std::min<std::uint64_t>(asked_, times_s_.size());
        if (behind == 0 || known == 0) return 0.0;
        const std::uint64_t at = asked_ - std::min(behind, known - 1);
        return times_s_[asked_ % times_s_.size()] - times_s_[at % times_s_.size()];
    }

  private:
    std::array<double, 16> times_s_{};
    std::uint64_t asked_ = 0;
};

}  // namespace touchline
