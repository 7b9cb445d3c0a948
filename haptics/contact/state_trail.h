// The contact states that one step passed through. Threads: a plain value.
#pragma once

#include "config/types/hand_state.h"

#include <cstdint>

namespace touchline {

/// Up to 16 states in order, beginning with the one before the step; further ones are left out.
/// Packed in two bits each, because clearing an array of them took longer than the arithmetic of a
/// free step.
class StateTrail {
  public:
    StateTrail() = default;

    explicit StateTrail(ContactState first) : states_(static_cast<std::uint32_t>(first)) {}

    /// 1 means no change.
    [[nodiscard]] int size() const { return size_; }

    /// State i, 0 <= i < size().
    [[nodiscard]] ContactState operator[](int i) const {
        return static_cast<ContactState>((states_ >> (2 * (size_ - 1 - i))) & 3U);
    }

    /// A walk along the outline (an edge, a vertex, an edge again) counts as one edge.
    void add(ContactState state) {
        const auto bits = static_cast<std::uint32_t>(state);
        if ((states_ & 3U) == bits) return;
        if (size_ >= 2 && state == ContactState::edge && (states_ & 15U) == edge_then_vertex) {
            states_ >>= 2U;
            --size_;
        } else if (size_ < capacity) {
            states_ = states_ << 2U | bits;
            ++size_;
        }
    }

  private:
    static constexpr int capacity = 16;
    static constexpr std::uint32_t edge_then_vertex =
        static_cast<std::uint32_t>(ContactState::edge) << 2U |
        static_cast<std::uint32_t>(ContactState::vertex);

    std::uint32_t states_ = 0;  // the newest in the lowest bits
    int size_ = 1;
};

}  // namespace touchline
