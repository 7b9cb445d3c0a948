#include "audio-cues/synth/continuous_voice.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

const double glide = 1.0 - std::exp(-1.0 / (0.020 * frame_rate_Hz));
constexpr double pulse_share = 0.4;  // of a period that sounds

double in_range(double value, double low, double high) {
    return std::isfinite(value) ? std::clamp(value, low, high) : 0.0;
}

}  // namespace

void ContinuousVoice::set(const ContinuousTone& tone) {
    const bool begins = level_.is_silent();
    tone_ = tone;
    tone_.frequency_Hz = in_range(tone.frequency_Hz, 0.0, 8000.0);
    tone_.pulse_Hz = in_range(tone.pulse_Hz, 0.0, 20.0);
    level_.go_to(in_range(tone.level, 0.0, 1.0));
    if (begins) {
        frequency_Hz_ = tone_.frequency_Hz;
        pulse_phase_ = 0.0;
    }
}

float ContinuousVoice::next() {
    pulse_phase_ += tone_.pulse_Hz / frame_rate_Hz;
    if (pulse_phase_ >= 1.0) pulse_phase_ -= 1.0;
    const bool sounds = tone_.pulse_Hz == 0.0 || pulse_phase_ < pulse_share;
    pulse_.go_to(sounds ? 1.0 : 0.0);
    frequency_Hz_ += glide * (tone_.frequency_Hz - frequency_Hz_);
    return level_.next() * pulse_.next() * oscillator_.next(tone_.timbre, frequency_Hz_);
}

void ContinuousVoice::add(std::span<StereoFrame> out, double width) {
    std::array<float, block_frames> mono;
    const bool sounds = !level_.is_silent();
    for (std::size_t i = 0; i < out.size(); ++i) mono[i] = level_.is_silent() ? 0.0F : next();
    source_.add(std::span(mono).first(out.size()), tone_.pan * width, out);
    tail_left_ =
        sounds ? PannedSource::tail_frames : std::max(0, tail_left_ - static_cast<int>(out.size()));
}

}  // namespace touchline
