// Everything that is heard, as a function of the commands: no device, no clock.
#pragma once

#include "audio-cues/synth/gain.h"
#include "audio-cues/synth/limiter.h"
#include "audio-cues/synth/voices.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace touchline {

/// Passes values from any number of threads to one, without a lock: Vyukov's bounded queue. A
/// writer never waits for the reader: if `capacity` values (a power of two) wait to be read, push()
/// gives up. The reader never waits for a writer. Order is kept per writer. Rejected: the servo's
/// ring, which has only one writer.
template <class T, std::size_t capacity>
class CommandQueue {
    static_assert(std::is_trivially_copyable_v<T>, "values are copied while nobody can wait");
    static_assert((capacity & (capacity - 1)) == 0, "indices run on past the end");
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

  public:
    CommandQueue() {
        for (std::size_t i = 0; i < capacity; ++i) slots_[i].turn.store(i);
    }

    /// Any thread. Returns false, and counts the loss, if the queue is full.
    bool push(const T& value) {
        std::uint64_t end = end_.load(std::memory_order_relaxed);
        while (true) {
            Slot& slot = slots_[end % capacity];
            const std::uint64_t turn = slot.turn.load(std::memory_order_acquire);
            if (turn < end) {
                dropped_.fetch_add(1, std::memory_order_relaxed);
                return false;
            }
            if (turn > end) {
                end = end_.load(std::memory_order_relaxed);  // another writer was here
            } else if (end_.compare_exchange_weak(end, end + 1, std::memory_order_relaxed)) {
                slot.value = value;
                slot.turn.store(end + 1, std::memory_order_release);
                return true;
            }
        }
    }

    /// The reader: returns the oldest complete value.
    std::optional<T> pop() {
        Slot& slot = slots_[begin_ % capacity];
        if (slot.turn.load(std::memory_order_acquire) != begin_ + 1) return std::nullopt;
        const T value = slot.value;
        slot.turn.store(begin_ + capacity, std::memory_order_release);
        ++begin_;
        return value;
    }

    /// Any thread: the number lost so far.
    [[nodiscard]] std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

  private:
    struct Slot {
        std::atomic<std::uint64_t> turn{0};  // the index that may write here; one more: read
        T value{};
    };

    std::array<Slot, capacity> slots_;
    std::atomic<std::uint64_t> end_{0};
    std::uint64_t begin_ = 0;  // the reader's
    std::atomic<std::uint64_t> dropped_{0};
};

/// Passes samples of speech to the mixer, from one thread to one, without a lock. Mono at
/// frame_rate_Hz. Writer: the thread that makes speech; reader: the rendering thread.
class SpeechFeed {
  public:
    /// Holds `capacity_frames`, one second by default.
    explicit SpeechFeed(std::size_t capacity_frames = frame_rate_Hz);

    /// Writer: appends as many samples as there is room for and returns how many. Never waits.
    std::size_t write(std::span<const float> samples);

    /// Writer: drops everything written so far. It fades within ramp_s.
    void cut() { cut_.store(end_.load(std::memory_order_relaxed), std::memory_order_release); }

    /// Any thread: the number of waiting frames, cut or not.
    [[nodiscard]] std::size_t waiting() const;

    /// Reader: gives the next frames, 0 after the last. While `is_paused`, nothing is used up,
    /// after a fade. Returns whether speech sounds, which means any frame was read. O(frames).
    bool read(std::span<float> out, bool is_paused);

  private:
    float next(bool is_paused);

    std::vector<float> samples_;
    std::atomic<std::uint64_t> end_{0};
    std::atomic<std::uint64_t> begin_{0};
    std::atomic<std::uint64_t> cut_{0};  // frames up to here are dropped
    Ramp level_{1.0};                    // the reader's, like everything below
    std::uint64_t cut_seen_ = 0;
    std::uint64_t read_ = 0;
    std::uint64_t written_ = 0;
};

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
