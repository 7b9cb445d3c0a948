// Keeps a query within its budget. Threads: a value on the stack of the query.
#pragma once

#include "config/types/steady_clock.h"
#include "haptics/collision/collision_tree.h"

namespace touchline {

/// Counts boxes; reads the clock only if a deadline is set.
class Spender {
  public:
    explicit Spender(const Budget& budget) : budget_(budget) {}

    bool spend(int boxes) {
        if (opened_ + boxes > budget_.boxes) return false;
        if (budget_.deadline_ns != 0 && steady_now_ns() >= budget_.deadline_ns) return false;
        opened_ += boxes;
        return true;
    }

    [[nodiscard]] int opened() const { return opened_; }

  private:
    Budget budget_;
    int opened_ = 0;
};

}  // namespace touchline
