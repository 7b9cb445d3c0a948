#include "audio-cues/synth/speech_feed.h"

#include <algorithm>

namespace touchline {

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

}  // namespace touchline
