#include "audio-cues/synth/earcon.h"

#include "audio-cues/synth/ramp.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr int ramp_frames = static_cast<int>(ramp_s * frame_rate_Hz);

int frames_of(const Note& note) {
    return std::max(static_cast<int>(std::lround(note.length_s * frame_rate_Hz)), 2 * ramp_frames);
}

/// Goes 0 ... 1 ... 0: swells and fades at the ends of the note.
float swell(int frame, int frames) {
    const int from_end = std::min(frame, frames - frame);
    if (from_end >= ramp_frames) return 1.0F;
    const float t = static_cast<float>(from_end) / static_cast<float>(ramp_frames);
    return t * t * (3.0F - 2.0F * t);
}

}  // namespace

double length_s(const Earcon& earcon) {
    int frames = 0;
    for (int i = 0; i < earcon.note_count; ++i) {
        frames += frames_of(earcon.notes[static_cast<std::size_t>(i)]);
    }
    return static_cast<double>(frames) / frame_rate_Hz;
}

Voice::Voice(const Earcon& earcon, double gain, double pan)
    : earcon_(earcon),
      gain_(std::isfinite(gain) ? std::clamp(gain, 0.0, 1.0) : 0.0),
      pan_(pan),
      tail_left_(PannedSource::tail_frames) {
    earcon_.note_count = std::clamp(earcon_.note_count, 0, 3);
    enter_note();
}

void Voice::enter_note() {
    if (note_ >= earcon_.note_count) return;
    const Note& note = earcon_.notes[static_cast<std::size_t>(note_)];
    note_frame_ = 0;
    note_frames_ = frames_of(note);
    level_ = static_cast<float>(gain_ * note.level);
    fall_ = note.decay_s > 0.0 ? static_cast<float>(std::exp(-1.0 / (note.decay_s * frame_rate_Hz)))
                               : 1.0F;
}

float Voice::next() {
    if (note_ >= earcon_.note_count) {
        --tail_left_;
        return 0.0F;
    }
    const Note& note = earcon_.notes[static_cast<std::size_t>(note_)];
    const double t = static_cast<double>(note_frame_) / note_frames_;
    const double frequency_Hz = note.begin_Hz + t * (note.end_Hz - note.begin_Hz);
    const float sample =
        level_ * swell(note_frame_, note_frames_) * oscillator_.next(note.timbre, frequency_Hz);
    level_ *= fall_;
    if (++note_frame_ >= note_frames_) {
        ++note_;
        enter_note();
    }
    return sample;
}

void Voice::add(std::span<StereoFrame> out, double width) {
    std::array<float, block_frames> mono;
    for (std::size_t i = 0; i < out.size(); ++i) mono[i] = next();
    source_.add(std::span(mono).first(out.size()), pan_ * width, out);
}

}  // namespace touchline
