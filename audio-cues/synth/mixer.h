// Everything that is heard, as a function of the commands: no device, no clock.
#pragma once

#include "audio-cues/synth/command_queue.h"
#include "audio-cues/synth/limiter.h"
#include "audio-cues/synth/speech_feed.h"
#include "audio-cues/synth/voices.h"

#include <array>
#include <atomic>
#include <span>
#include <variant>

namespace touchline {

inline constexpr double duck_dB = -12.0;
inline constexpr double duck_down_s = 0.03;  // all the way
inline constexpr double duck_hold_s = 0.30;  // the pause between two sentences
inline constexpr double duck_up_s = 0.25;    // all the way

/// Lowers one bus while another sounds.
class Ducker {
  public:
    /// Advances by `seconds`, during which `is_other_sounding` holds. Returns the gain to arrive
    /// at, 1 if nothing has sounded for duck_hold_s and duck_up_s.
    double step(bool is_other_sounding, double seconds);

    [[nodiscard]] double gain() const { return gain_; }

  private:
    double level_dB_ = 0.0;
    double hold_s_ = 0.0;
    double gain_ = 1.0;
};

enum class Bus : std::uint8_t { speech, earcon, continuous, alert };

inline constexpr std::size_t bus_count = 4;

/// Sounds on the earcon or alert bus. At most Mixer::voice_count sound at once; more are dropped.
struct PlayEarcon {
    Earcon earcon;
    double level = 1.0;  // 0 ... 1
    double pan = 0.0;    // -1 left ... 1 right
    bool is_alert = false;
};

struct SetContinuous {
    ContinuousTone tone;
};

struct SetBusLevel {
    Bus bus = Bus::speech;
    double level = 1.0;  // 0 ... 1
};

struct PauseSpeech {
    bool is_paused = false;
};

/// The output's setting, from its profile (audio-cues/output/outputs.h).
struct SetOutput {
    double gain = 1.0;     // volume and calibration
    double cap = 1.0;      // no sample exceeds this peak, 0 ... 1
    bool is_mono = false;  // the same for both ears
};

struct MixerCommand {
    FrameTime frame = 0;  // exact frame; a past one means now
    std::variant<PlayEarcon, SetContinuous, SetBusLevel, PauseSpeech, SetOutput> what;
};

/// Threads: send(), speech().write(), speech().cut() and the counters from others, render() from
/// one. render() does not allocate, lock, read a clock or log.
class Mixer {
  public:
    static constexpr int voice_count = 8;

    /// The delay of everything, in frames: the limiter's look-ahead.
    static constexpr int latency_frames = Limiter::look_ahead_frames;

    /// Counts frames from `first`.
    explicit Mixer(FrameTime first = 0) : frame_(first), rendered_(first) {}

    /// Any thread, never waits. Returns false if 256 wait already; then the command is lost.
    bool send(const MixerCommand& command) { return queue_.push(command); }

    [[nodiscard]] SpeechFeed& speech() { return speech_; }

    /// Renders the next frames, any number. O(frames).
    void render(std::span<StereoFrame> out);

    /// Any thread: the frame that the next render() begins with.
    [[nodiscard]] FrameTime now() const { return rendered_.load(std::memory_order_acquire); }

    /// Any thread: the number of commands that were lost and of earcons that found no voice, so
    /// far.
    [[nodiscard]] std::uint64_t lost() const {
        return queue_.dropped() + dropped_.load(std::memory_order_relaxed);
    }

  private:
    void take_commands();
    void apply_due();
    [[nodiscard]] std::size_t frames_to_next(std::size_t most) const;
    void render_part(std::span<StereoFrame> out);
    void render_speech(std::span<StereoFrame> bus);
    void render_voices(bool are_alerts, std::span<StereoFrame> bus);
    void add_bus(Bus bus, std::span<const StereoFrame> frames, double duck_from, double duck_to,
                 std::span<StereoFrame> out);
    void apply(const PlayEarcon& play);

    void apply(const SetContinuous& set) { continuous_.set(set.tone); }

    void apply(const SetBusLevel& set);

    void apply(const PauseSpeech& pause) { is_speech_paused_ = pause.is_paused; }

    void apply(const SetOutput& output);

    struct PlayingVoice {
        Voice voice;
        bool is_alert = false;
    };

    CommandQueue<MixerCommand, 256> queue_;
    std::array<MixerCommand, 256> pending_{};  // by frame
    std::size_t pending_count_ = 0;
    std::array<PlayingVoice, voice_count> voices_{};
    ContinuousVoice continuous_;
    SpeechFeed speech_;
    Ducker under_speech_;
    Ducker under_alert_;
    Limiter limiter_;
    std::array<Ramp, bus_count> levels_{Ramp(1.0), Ramp(1.0), Ramp(1.0), Ramp(1.0)};
    Ramp gain_{1.0};
    Ramp width_{1.0, 0.02};  // 1 stereo ... 0 mono
    double cap_ = 1.0;
    bool is_speech_paused_ = false;
    bool is_speech_sounding_ = false;
    bool is_alert_sounding_ = false;
    FrameTime frame_;
    std::atomic<FrameTime> rendered_;
    std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace touchline
