#include "audio-cues/synth/mixer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

using Block = std::array<StereoFrame, block_frames>;

constexpr float centre_gain = static_cast<float>(1.0 / std::numbers::sqrt2);

}  // namespace

SpeechFeed::SpeechFeed(std::size_t capacity_frames)
    : samples_(std::max<std::size_t>(capacity_frames, 1)) {}

std::size_t SpeechFeed::write(std::span<const float> samples) {
    const std::uint64_t end = end_.load(std::memory_order_relaxed);
    const std::uint64_t begin = begin_.load(std::memory_order_acquire);
    const std::size_t room = samples_.size() - static_cast<std::size_t>(end - begin);
    const std::size_t count = std::min(room, samples.size());
    for (std::size_t i = 0; i < count; ++i) samples_[(end + i) % samples_.size()] = samples[i];
    end_.store(end + count, std::memory_order_release);
    return count;
}

std::size_t SpeechFeed::waiting() const {
    const std::uint64_t begin = begin_.load(std::memory_order_acquire);
    return static_cast<std::size_t>(end_.load(std::memory_order_acquire) - begin);
}

float SpeechFeed::next(bool is_paused) {
    const bool is_cut = read_ < cut_seen_;
    if (is_cut || is_paused) {
        level_.go_to(0.0);
    } else if (read_ < written_) {
        level_.go_to(1.0);
    }
    if (is_cut && (level_.is_silent() || read_ == written_)) {
        read_ = cut_seen_;  // silent by now, or there is nothing left to fade
        return 0.0F;
    }
    const bool is_late = read_ == written_;
    if (is_paused ? level_.is_silent() : is_late) return 0.0F;
    // A pause also fades while the voice is late; otherwise late samples would sound in the pause.
    const float level = level_.next();
    return is_late ? 0.0F : level * samples_[read_++ % samples_.size()];
}

bool SpeechFeed::read(std::span<float> out, bool is_paused) {
    cut_seen_ = cut_.load(std::memory_order_acquire);
    written_ = end_.load(std::memory_order_acquire);
    const std::uint64_t before = read_;
    for (float& sample : out) sample = next(is_paused);
    begin_.store(read_, std::memory_order_release);
    return read_ != before;
}

double Ducker::step(bool is_other_sounding, double seconds) {
    hold_s_ = is_other_sounding ? duck_hold_s : std::max(0.0, hold_s_ - seconds);
    const double wanted_dB = hold_s_ > 0.0 ? duck_dB : 0.0;
    if (wanted_dB == level_dB_) return gain_;
    const double change_dB = -duck_dB * seconds / (wanted_dB < level_dB_ ? duck_down_s : duck_up_s);
    level_dB_ = std::clamp(wanted_dB, level_dB_ - change_dB, level_dB_ + change_dB);
    return gain_ = gain_of_dB(level_dB_);
}

void Mixer::render(std::span<StereoFrame> out) {
    take_commands();
    while (!out.empty()) {
        apply_due();
        const std::size_t count = frames_to_next(
            std::min<std::size_t>(out.size(), static_cast<std::size_t>(block_frames)));
        render_part(out.first(count));
        frame_ += static_cast<FrameTime>(count);
        out = out.subspan(count);
    }
    rendered_.store(frame_, std::memory_order_release);
}

/// Moves commands into `pending_`; those of one frame keep their order.
void Mixer::take_commands() {
    while (pending_count_ < pending_.size()) {
        const auto command = queue_.pop();
        if (!command) return;
        std::size_t place = pending_count_++;
        for (; place > 0 && pending_[place - 1].frame > command->frame; --place) {
            pending_[place] = pending_[place - 1];
        }
        pending_[place] = *command;
    }
}

void Mixer::apply_due() {
    std::size_t due = 0;
    while (due < pending_count_ && pending_[due].frame <= frame_) {
        std::visit([this](const auto& what) { apply(what); }, pending_[due++].what);
    }
    if (due == 0) return;
    std::copy(pending_.begin() + static_cast<std::ptrdiff_t>(due),
              pending_.begin() + static_cast<std::ptrdiff_t>(pending_count_), pending_.begin());
    pending_count_ -= due;
}

std::size_t Mixer::frames_to_next(std::size_t most) const {
    if (pending_count_ == 0) return most;
    return std::min(most, static_cast<std::size_t>(pending_.front().frame - frame_));
}

void Mixer::apply(const PlayEarcon& play) {
    for (PlayingVoice& playing : voices_) {
        if (!playing.voice.is_over()) continue;
        playing = {Voice(play.earcon, play.level, play.pan), play.is_alert};
        return;
    }
    dropped_.fetch_add(1, std::memory_order_relaxed);
}

void Mixer::apply(const SetBusLevel& set) {
    const double level = std::isfinite(set.level) ? std::clamp(set.level, 0.0, 1.0) : 0.0;
    levels_[static_cast<std::size_t>(set.bus)].go_to(level);
}

void Mixer::apply(const SetOutput& output) {
    gain_.go_to(std::max(output.gain, 0.0));
    cap_ = output.cap;
    width_.go_to(output.is_mono ? 0.0 : 1.0);
}

void Mixer::render_speech(std::span<StereoFrame> bus) {
    std::array<float, block_frames> mono;
    const auto samples = std::span(mono).first(bus.size());
    is_speech_sounding_ = speech_.read(samples, is_speech_paused_);
    for (std::size_t i = 0; i < bus.size(); ++i) {
        const float sample = centre_gain * samples[i];
        bus[i] = {sample, sample};
    }
}

void Mixer::render_voices(bool are_alerts, std::span<StereoFrame> bus) {
    bool sounds = false;
    for (PlayingVoice& playing : voices_) {
        if (playing.is_alert != are_alerts || playing.voice.is_over()) continue;
        playing.voice.add(bus, static_cast<double>(width_.value()));
        sounds = true;
    }
    if (are_alerts) is_alert_sounding_ = sounds;
}

void Mixer::add_bus(Bus bus, std::span<const StereoFrame> frames, double duck_from, double duck_to,
                    std::span<StereoFrame> out) {
    Ramp& level = levels_[static_cast<std::size_t>(bus)];
    const auto from = static_cast<float>(duck_from);
    const float step = static_cast<float>(duck_to - duck_from) / static_cast<float>(out.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float gain = level.next() * (from + step * static_cast<float>(i + 1));
        out[i].left += gain * frames[i].left;
        out[i].right += gain * frames[i].right;
    }
}

void Mixer::render_part(std::span<StereoFrame> out) {
    std::array<Block, bus_count> buses{};
    const auto bus = [&](Bus which) {
        return std::span(buses[static_cast<std::size_t>(which)]).first(out.size());
    };
    render_speech(bus(Bus::speech));
    render_voices(false, bus(Bus::earcon));
    render_voices(true, bus(Bus::alert));
    if (!continuous_.is_silent()) {
        continuous_.add(bus(Bus::continuous), static_cast<double>(width_.value()));
    }
    const double seconds = static_cast<double>(out.size()) / frame_rate_Hz;
    const double speech_from = under_speech_.gain();
    const double alert_from = under_alert_.gain();
    const double speech_to = under_speech_.step(is_speech_sounding_, seconds);
    const double alert_to = under_alert_.step(is_alert_sounding_, seconds);

    std::fill(out.begin(), out.end(), StereoFrame{});
    add_bus(Bus::alert, bus(Bus::alert), 1.0, 1.0, out);
    add_bus(Bus::speech, bus(Bus::speech), alert_from, alert_to, out);
    add_bus(Bus::earcon, bus(Bus::earcon), alert_from, alert_to, out);
    add_bus(Bus::continuous, bus(Bus::continuous), speech_from * alert_from, speech_to * alert_to,
            out);
    for (StereoFrame& frame : out) {
        const float gain = gain_.next();
        frame = {gain * frame.left, gain * frame.right};
        (void)width_.next();
    }
    limiter_.process(out, cap_);
}

}  // namespace touchline
