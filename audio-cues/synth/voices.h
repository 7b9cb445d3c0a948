// What sounds: waves from a table, short sounds of a few notes, and a continuous sound that follows
// the hand (position tone, distance, sonar); all placed left and right by level and by time.
// Threads: values; an Oscillator, a PannedSource and the voices are the rendering thread's.
#pragma once

#include "audio-cues/synth/frames.h"
#include "audio-cues/synth/gain.h"

#include <array>
#include <cstdint>
#include <span>

namespace touchline {

/// The limit lets a listener with one good ear still hear the other side.
inline constexpr double pan_limit_dB = 20.0;

/// The delay of the far ear.
inline constexpr double far_ear_delay_s = 0.0006;

struct Ears {
    float left_gain = 0.0F;  // squares sum to 1
    float right_gain = 0.0F;
    float left_delay_frames = 0.0F;  // one of the two is 0
    float right_delay_frames = 0.0F;
};

/// `pan`: -1 left ... 1 right, clamped; NaN is the middle. Constant power; the difference in dB
/// reaches pan_limit_dB at the sides. In the middle both ears are the same, bit for bit.
[[nodiscard]] Ears ears_of(double pan);

/// A mono sound at a place that may move. It sounds far_ear_delay_s longer than it is fed.
class PannedSource {
  public:
    /// Adds `mono` (at most block_frames) to `out`, of the same length, and moves to `pan`
    /// meanwhile; the first call begins there. O(frames).
    void add(std::span<const float> mono, double pan, std::span<StereoFrame> out);

    static constexpr int tail_frames = 32;

  private:
    [[nodiscard]] float delayed(int frame, float delay_frames) const;

    std::array<float, tail_frames + block_frames> heard_{};  // the tail of the last call first
    Ears ears_{};
    bool is_placed_ = false;
};

/// pure: a sine. hollow: odd harmonics, like a clarinet. bright: octave and twelfth, like a bell.
enum class Timbre : std::uint8_t { pure, hollow, bright };

/// Its phase is continuous whatever the frequency does, and stays in 0 ... 1, so that an hour adds
/// no error of its own.
class Oscillator {
  public:
    /// Advances one frame. `frequency_Hz` in 0 ... 8000, so that no harmonic folds back; else 0.
    /// Peaks at most at 1, begins at 0 and rises.
    float next(Timbre timbre, double frequency_Hz);

  private:
    double phase_ = 0.0;
};

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

/// A continuous sound: position tone, distance, sonar, or torque of a shape.
struct ContinuousTone {
    double frequency_Hz = 440.0;  // 0 ... 8000
    double level = 0.0;           // peak, 0 ... 1; 0: silence
    double pan = 0.0;             // -1 left ... 1 right
    double pulse_Hz = 0.0;        // 0: steady; at most 20
    Timbre timbre = Timbre::pure;
};

/// Glides to each new tone: the level within ramp_s, the pitch by 1/e in 20 ms.
class ContinuousVoice {
  public:
    void set(const ContinuousTone& tone);

    /// See Voice::add().
    void add(std::span<StereoFrame> out, double width);

    [[nodiscard]] bool is_silent() const { return level_.is_silent() && tail_left_ == 0; }

  private:
    float next();

    ContinuousTone tone_;
    Ramp level_;
    Ramp pulse_;
    double pulse_phase_ = 0.0;
    double frequency_Hz_ = 0.0;
    Oscillator oscillator_;
    PannedSource source_;
    int tail_left_ = 0;  // frames that the far ear still hears
};

}  // namespace touchline
