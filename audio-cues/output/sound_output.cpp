#include "audio-cues/output/sound_output.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace touchline {
namespace {

constexpr std::int64_t second_ns = 1'000'000'000;
constexpr std::int64_t jump_ns = 50'000'000;  // more is not jitter: the device stood still

/// Does not overflow for thousands of years.
std::int64_t ns_of(FrameTime frame) {
    return frame / frame_rate_Hz * second_ns + frame % frame_rate_Hz * second_ns / frame_rate_Hz;
}

constexpr double ns_per_s = 1e9;
constexpr FrameTime quiet_frames = frame_rate_Hz;  // before the device may begin anew

bool is_heard(const StereoFrame& frame) {
    return frame != StereoFrame{};
}

}  // namespace

void FrameClock::told(FrameTime frame, std::int64_t now_ns) {
    const std::int64_t start_ns = now_ns - ns_of(frame);
    const std::int64_t last_ns = start_ns_.load(std::memory_order_relaxed);
    const bool is_new = last_ns == nothing || std::abs(start_ns - last_ns) > jump_ns;
    start_ns_.store(is_new ? start_ns : last_ns + (start_ns - last_ns) / 32,
                    std::memory_order_relaxed);
}

FrameTime FrameClock::frame_at(std::int64_t time_ns) const {
    const std::int64_t start_ns = start_ns_.load(std::memory_order_relaxed);
    if (start_ns == nothing) return 0;
    const std::int64_t since_ns = time_ns - start_ns;
    const FrameTime frame =
        since_ns / second_ns * frame_rate_Hz + since_ns % second_ns * frame_rate_Hz / second_ns;
    return frame + lead_frames;
}

SoundOutput::SoundOutput(std::unique_ptr<SoundDevice> device, Mixer& mixer,
                         std::function<std::int64_t()> clock_ns)
    : device_(std::move(device)),
      mixer_(mixer),
      clock_ns_(std::move(clock_ns)),
      nowhere_frame_(mixer.now()),
      nowhere_ns_(clock_ns_()) {}

void SoundOutput::open(std::int64_t now_ns) {
    tried_ns_ = now_ns;
    was_tried_ = true;
    seen_frame_ = mixer_.now();
    moved_ns_ = now_ns;
    frame_clock_.forget();
    opened_block_ = block_;
    const auto opened = device_->open(
        [this](std::span<StereoFrame> frames) {
            frame_clock_.told(mixer_.now(), clock_ns_());
            mixer_.render(frames);
            if (std::ranges::any_of(frames, is_heard))
                quiet_since_.store(mixer_.now(), std::memory_order_relaxed);
        },
        block_);
    is_open_ = opened.has_value();
    problem_ = opened ? std::string() : opened.error().line;
}

void SoundOutput::lose(std::int64_t now_ns, std::string problem) {
    device_->close();
    is_open_ = false;
    problem_ = std::move(problem);
    tried_ns_ = now_ns;
    nowhere_frame_ = mixer_.now();
    nowhere_ns_ = now_ns;
}

void SoundOutput::rest(bool is_nobody_here) {
    const int block = is_nobody_here ? resting_block_frames : block_frames;
    if (std::exchange(block_, block) == block) return;
    quiet_since_.store(mixer_.now(), std::memory_order_relaxed);
}

void SoundOutput::change_block(std::int64_t now_ns) {
    device_->close();
    open(now_ns);
    if (!is_open_) lose(now_ns, problem_);
}

/// Renders at most a second at once, in case the caller has been away.
void SoundOutput::render_to_nowhere(std::int64_t now_ns) {
    const double since_s = static_cast<double>(now_ns - nowhere_ns_) / ns_per_s;
    const auto due = nowhere_frame_ + static_cast<FrameTime>(since_s * frame_rate_Hz);
    std::array<StereoFrame, block_frames> frames;
    for (int i = 0; i < frame_rate_Hz / block_frames && mixer_.now() + block_frames <= due; ++i) {
        frame_clock_.told(mixer_.now(), now_ns);
        mixer_.render(frames);
    }
}

void SoundOutput::step() {
    const std::int64_t now_ns = clock_ns_();
    const auto since_s = [now_ns](std::int64_t then_ns) {
        return static_cast<double>(now_ns - then_ns) / ns_per_s;
    };
    if (!is_open_) {
        if (!was_tried_ || since_s(tried_ns_) >= retry_s) open(now_ns);
        if (!is_open_) render_to_nowhere(now_ns);
        return;
    }
    if (mixer_.now() != seen_frame_) {
        seen_frame_ = mixer_.now();
        moved_ns_ = now_ns;
    }
    if (device_->is_gone()) {
        lose(now_ns, "The sound device was unplugged.");
    } else if (since_s(moved_ns_) > stall_s) {
        lose(now_ns, "The sound device stands still.");
    } else if (block_ != opened_block_ && mixer_.now() - quiet_since_ >= quiet_frames) {
        change_block(now_ns);
    }
}

}  // namespace touchline
