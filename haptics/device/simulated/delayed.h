// Commands on their way to a device in software, each to act from a moment on.
// Threads: a plain value. No allocation.
#pragma once

#include <array>
#include <cstddef>

namespace touchline {

template <class Command>
class Delayed {
  public:
    struct Timed {
        double from_s = 0.0;
        Command command;
    };

    /// The moments never go back. When 64 wait, the newest gives way. O(1).
    void push(double from_s, const Command& command) {
        if (count_ == pending_.size()) --count_;
        pending_[(first_ + count_) % pending_.size()] = {from_s, command};
        ++count_;
    }

    /// Returns the oldest that acts by t_s; null if there is none. O(1).
    [[nodiscard]] const Timed* due(double t_s) const {
        const bool is_due = count_ > 0 && pending_[first_].from_s <= t_s;
        return is_due ? &pending_[first_] : nullptr;
    }

    /// Drops the oldest of at least one.
    void pop() {
        first_ = (first_ + 1) % pending_.size();
        --count_;
    }

  private:
    std::array<Timed, 64> pending_{};
    std::size_t first_ = 0;  // the oldest
    std::size_t count_ = 0;
};

}  // namespace touchline
