#include "audio-cues/speech/resampler.h"

#include "audio-cues/synth/frames.h"

#include <array>
#include <new>

#include <samplerate.h>

namespace touchline {

void Resampler::Close::operator()(SRC_STATE_tag* state) const {
    src_delete(state);
}

Resampler::Resampler(int rate_Hz)
    : state_(src_new(rate_Hz > frame_rate_Hz ? SRC_SINC_FASTEST : SRC_SINC_MEDIUM_QUALITY, 1,
                     nullptr)),
      ratio_(static_cast<double>(frame_rate_Hz) / rate_Hz) {
    if (!state_) throw std::bad_alloc();
}

void Resampler::process(std::span<const float> samples, bool is_end, std::vector<float>& out) {
    std::array<float, 4096> made{};
    SRC_DATA step{};
    step.src_ratio = ratio_;
    step.end_of_input = is_end ? 1 : 0;
    step.data_out = made.data();
    step.output_frames = static_cast<long>(made.size());
    do {
        step.data_in = samples.data();
        step.input_frames = static_cast<long>(samples.size());
        if (src_process(state_.get(), &step) != 0) return;  // only for a wrong ratio or pointer
        samples = samples.subspan(static_cast<std::size_t>(step.input_frames_used));
        out.insert(out.end(), made.begin(), made.begin() + step.output_frames_gen);
    } while (step.input_frames_used > 0 || step.output_frames_gen > 0);
}

void Resampler::add(std::span<const float> samples, std::vector<float>& out) {
    process(samples, false, out);
}

void Resampler::finish(std::vector<float>& out) {
    constexpr std::array<float, 1> silence{};  // no samples, but a place: else the end is kept back
    process(std::span(silence).first(0), true, out);
}

std::vector<float> at_frame_rate(std::span<const float> samples, int rate_Hz) {
    if (rate_Hz == frame_rate_Hz) return {samples.begin(), samples.end()};
    std::vector<float> made;
    Resampler resampler(rate_Hz);
    resampler.add(samples, made);
    resampler.finish(made);
    return made;
}

}  // namespace touchline
