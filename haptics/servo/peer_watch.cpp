#include "haptics/servo/peer_watch.h"

#include <algorithm>

namespace touchline {

bool PeerWatch::step(std::uint64_t beats, double dt_s) {
    if (beats != beats_) {
        beats_ = beats;
        silent_s_ = 0.0;
        has_beaten_ = true;
    } else if (!(dt_s <= longest_step_s_)) {
        silent_s_ += longest_step_s_;
    } else {
        silent_s_ += std::max(dt_s, 0.0);
    }
    return !has_beaten_ || silent_s_ >= silence_s_;
}

double ForceShare::step(bool is_wanted_off, double dt_s) {
    const bool is_fading = share_ > 0.0 && share_ < 1.0;
    if (is_wanted_off || is_fading) {
        share_ = dt_s > 0.0 ? std::max(0.0, share_ - dt_s / fade_s) : 0.0;
    } else {
        share_ = 1.0;
    }
    return share_;
}

}  // namespace touchline
