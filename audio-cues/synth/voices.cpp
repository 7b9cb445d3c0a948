#include "audio-cues/synth/voices.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr std::size_t table_size = 2048;
using Table = std::array<float, table_size + 1>;  // repeats the first at the end

Table table_of(const std::array<double, 3>& harmonics, const std::array<int, 3>& numbers) {
    Table table;
    double peak = 0.0;
    std::array<double, table_size + 1> wave{};
    for (std::size_t i = 0; i <= table_size; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i % table_size) /
                             static_cast<double>(table_size);
        for (std::size_t k = 0; k < 3; ++k) wave[i] += harmonics[k] * std::sin(numbers[k] * angle);
        peak = std::max(peak, std::abs(wave[i]));
    }
    for (std::size_t i = 0; i <= table_size; ++i) table[i] = static_cast<float>(wave[i] / peak);
    return table;
}

// In the order of Timbre; made before the first frame, so that rendering only reads.
const std::array<Table, 3> tables{table_of({1.0, 0.0, 0.0}, {1, 1, 1}),
                                  table_of({1.0, 0.33, 0.15}, {1, 3, 5}),
                                  table_of({1.0, 0.4, 0.25}, {1, 2, 3})};

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

const double glide = 1.0 - std::exp(-1.0 / (0.020 * frame_rate_Hz));
constexpr double pulse_share = 0.4;  // of a period that sounds

double in_range(double value, double low, double high) {
    return std::isfinite(value) ? std::clamp(value, low, high) : 0.0;
}

}  // namespace

Ears ears_of(double pan) {
    static_assert(far_ear_delay_s * frame_rate_Hz + 1.0 < PannedSource::tail_frames);
    const double side = std::isnan(pan) ? 0.0 : std::clamp(pan, -1.0, 1.0);
    const double quarter = std::numbers::pi / 4.0;
    const double turn = side * (quarter - std::atan(std::pow(10.0, -pan_limit_dB / 20.0)));
    const double delay_frames = far_ear_delay_s * frame_rate_Hz;
    return {static_cast<float>(std::cos(quarter + turn)),
            static_cast<float>(std::cos(quarter - turn)),
            static_cast<float>(std::max(side, 0.0) * delay_frames),
            static_cast<float>(std::max(-side, 0.0) * delay_frames)};
}

float PannedSource::delayed(int frame, float delay_frames) const {
    const float place = static_cast<float>(tail_frames + frame) - delay_frames;
    const auto before = static_cast<std::size_t>(place);
    const float part = place - static_cast<float>(before);
    if (part == 0.0F) return heard_[before];
    return heard_[before] + part * (heard_[before + 1] - heard_[before]);
}

void PannedSource::add(std::span<const float> mono, double pan, std::span<StereoFrame> out) {
    assert(mono.size() <= static_cast<std::size_t>(block_frames) && mono.size() == out.size());
    const Ears to = ears_of(pan);
    if (!is_placed_) ears_ = to;
    is_placed_ = true;
    std::copy(mono.begin(), mono.end(), heard_.begin() + tail_frames);
    const float share = 1.0F / static_cast<float>(std::max<std::size_t>(mono.size(), 1));
    for (std::size_t i = 0; i < mono.size(); ++i) {
        const float t = static_cast<float>(i + 1) * share;
        const auto between = [t](float a, float b) { return a + t * (b - a); };
        const int frame = static_cast<int>(i);
        out[i].left += between(ears_.left_gain, to.left_gain) *
                       delayed(frame, between(ears_.left_delay_frames, to.left_delay_frames));
        out[i].right += between(ears_.right_gain, to.right_gain) *
                        delayed(frame, between(ears_.right_delay_frames, to.right_delay_frames));
    }
    ears_ = to;
    const auto last = heard_.begin() + static_cast<std::ptrdiff_t>(mono.size());
    std::copy(last, last + tail_frames, heard_.begin());
}

float Oscillator::next(Timbre timbre, double frequency_Hz) {
    const Table& table = tables[static_cast<std::size_t>(timbre)];
    const double place = phase_ * static_cast<double>(table_size);
    const auto before = static_cast<std::size_t>(place);
    const auto part = static_cast<float>(place - static_cast<double>(before));
    const float sample = table[before] + part * (table[before + 1] - table[before]);
    const bool can_sound = frequency_Hz >= 0.0 && frequency_Hz <= 8000.0;  // false for NaN
    phase_ += can_sound ? frequency_Hz / frame_rate_Hz : 0.0;
    if (phase_ >= 1.0) phase_ -= 1.0;
    return can_sound ? sample : 0.0F;
}

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
