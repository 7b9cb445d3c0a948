#include "app/visit/keys/key_filter.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr double longest_double_strike_s = 0.5;

}  // namespace

KeyFilter::KeyFilter(double double_strike_s)
    : double_strike_s_(std::clamp(double_strike_s, 0.0, longest_double_strike_s)) {}

bool KeyFilter::takes(const KeyChange& change) {
    const auto found = std::find_if(known_.begin(), known_.end(),
                                    [&](const Known& known) { return known.key == change.key; });
    if (!change.is_down) {
        if (found != known_.end()) found->is_down = false;
        return false;
    }
    if (change.is_repeat) return false;
    if (found == known_.end()) {
        known_.push_back({change.key, true, change.time_s});
        return true;
    }
    const bool is_second_strike = change.time_s - found->down_s < double_strike_s_;
    if (found->is_down || is_second_strike) {
        found->is_down = true;
        return false;
    }
    *found = {change.key, true, change.time_s};
    return true;
}

}  // namespace touchline
