// Turns key changes into presses that count: no repeat, no second strike (accessibility IN-4).
// Threads: plain values; one thread's.
#pragma once

#include "config/settings/keys.h"

#include <vector>

namespace touchline {

struct KeyChange {
    PhysicalKey key;
    bool is_down = true;
    bool is_repeat = false;  // the window system says so
    double time_s = 0.0;     // never goes back
};

class KeyFilter {
  public:
    /// `double_strike_s`: 0 ... 0.5; 0 lets every press through.
    explicit KeyFilter(double double_strike_s);

    /// True for a press that counts: the key was up, and was not pressed within double_strike_s
    /// before. The press acts, not the release. O(keys held or pressed before).
    [[nodiscard]] bool takes(const KeyChange& change);

  private:
    struct Known {
        PhysicalKey key;
        bool is_down = false;
        double down_s = 0.0;  // time of the last press that counted
    };

    double double_strike_s_;
    std::vector<Known> known_;
};

}  // namespace touchline
