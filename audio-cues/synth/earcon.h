// A short sound of a few notes, and its voice. Threads: values; a Voice is the rendering thread's.
#pragma once

#include "audio-cues/synth/oscillator.h"
#include "audio-cues/synth/pan.h"

#include <array>
#include <span>

namespace touchline {

/// A note that swells and fades within ramp_s at its ends, so that it never clicks.
struct Note {
    double begin_Hz = 440.0;  // 0 ... 8000; 0: a rest
    double end_Hz = 440.0;    // glides there
    double length_s = 0.05;
    double level = 1.0;    // peak, 0 ... 1
    double decay_s = 0.0;  // falls by 1/e in this time; 0: holds
    Timbre timbre = Timbre::pure;
};

struct Earcon {
    std::array<Note, 3> notes{};
    int note_count = 0;  // 0 ... 3
};

[[nodiscard]] double length_s(const Earcon& earcon);

/// An earcon while it sounds.
class Voice {
  public:
    /// Silent.
    Voice() = default;
    Voice(const Earcon& earcon, double gain, double pan);

    /// Adds its next frames, at most block_frames, to `out`; `width` scales the pan: 0 is mono.
    /// O(frames).
    void add(std::span<StereoFrame> out, double width);

    [[nodiscard]] bool is_over() const { return tail_left_ <= 0; }

  private:
    float next();
    void enter_note();

    Earcon earcon_;
    double gain_ = 0.0;
    double pan_ = 0.0;
    Oscillator oscillator_;
    PannedSource source_;
    int note_ = 0;
    int note_frame_ = 0;
    int note_frames_ = 0;
    float level_ = 0.0F;  // with its decay so far
    float fall_ = 1.0F;   // a frame
    int tail_left_ = 0;   // frames that the far ear still hears after the last note
};

}  // namespace touchline
