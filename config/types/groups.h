// Which of n things belong together. Threads: plain values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace touchline {

/// Things 0 ... n - 1, each alone at first; the first of a group stands for it. Union and find: all
/// calls together take about O(n).
class Groups {
  public:
    explicit Groups(std::size_t n) : before_(n) {
        std::iota(before_.begin(), before_.end(), std::size_t{0});
    }

    void join(std::size_t a, std::size_t b) {
        const auto [first, second] = std::minmax({first_of(a), first_of(b)});
        before_[second] = first;
    }

    std::size_t first_of(std::size_t i) {
        while (before_[i] != i) i = before_[i] = before_[before_[i]];
        return i;
    }

  private:
    std::vector<std::size_t> before_;  // an earlier one of the same group, or itself
};

}  // namespace touchline
