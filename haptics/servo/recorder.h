// The newest ticks, for drawings and replay.
// Threads: one at a time. push() allocates nothing; ticks() is for when the servo rests.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <vector>

namespace touchline {

struct TickRecord {
    double time_s = 0.0;
    Position p_WH;  // handle
    Position p_WP;  // proxy
    Force force;    // commanded
    double level = 0.0;
    ContactState state = ContactState::free;
};

class Recorder {
  public:
    /// Keeps the newest `capacity` ticks; 0 keeps none.
    explicit Recorder(std::size_t capacity = 0) : ring_(capacity) {}

    void push(const HandState& hand);

    /// Oldest first. O(n).
    [[nodiscard]] std::vector<TickRecord> ticks() const;

  private:
    std::vector<TickRecord> ring_;
    std::size_t pushed_ = 0;
};

}  // namespace touchline
