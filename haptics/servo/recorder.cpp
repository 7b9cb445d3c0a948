#include "haptics/servo/recorder.h"

#include <algorithm>

namespace touchline {

void Recorder::push(const HandState& hand) {
    if (ring_.empty()) return;
    ring_[pushed_ % ring_.size()] = {hand.time_s, hand.p_WH,  hand.p_WP,
                                     hand.force,  hand.level, hand.state};
    ++pushed_;
}

std::vector<TickRecord> Recorder::ticks() const {
    const std::size_t count = std::min(pushed_, ring_.size());
    std::vector<TickRecord> result;
    result.reserve(count);
    for (std::size_t i = pushed_ - count; i < pushed_; ++i)
        result.push_back(ring_[i % ring_.size()]);
    return result;
}

}  // namespace touchline
