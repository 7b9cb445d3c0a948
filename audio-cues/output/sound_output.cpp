#include "audio-cues/output/sound_output.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchline {
namespace {

constexpr double ns_per_s = 1e9;

}  // namespace

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
    const auto opened = device_->open([this](std::span<StereoFrame> frames) {
        frame_clock_.told(mixer_.now(), clock_ns_());
        mixer_.render(frames);
    });
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
    }
}

}  // namespace touchline
