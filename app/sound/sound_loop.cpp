#include "app/sound/sound_loop.h"

#include "app/isolation/process/thread_signals.h"
#include "config/types/steady_clock.h"

#include <chrono>
#include <utility>

namespace touchline {
namespace {

constexpr int polls_between_looks = 16;  // nearly 60 looks a second

std::optional<bool> ask(HeadphonePresence* source, double now_s) {
    return source == nullptr ? std::nullopt : source->are_in(now_s);
}

}  // namespace

void HandCues::play(const ContactEvent& event, const CueSetting& setting) {
    state_.amount = setting.amount;
    state_.area = setting.area;
    const CueStep step = cue_step(state_, event);
    state_ = step.state;
    if (!step.cue) return;
    const auto happened_ns = setting.clock.ns_of(step.cue->time_s);
    mixer_.send(sound_of(*step.cue, happened_ns ? clock_.frame_at(*happened_ns) : 0));
}

SoundLoop::SoundLoop(Mixer& mixer, SoundWorld world, EventSource events)
    : mixer_(mixer),
      thread_([this, world = std::move(world), events = std::move(events)](
                  const std::stop_token& stop) mutable { run(stop, std::move(world), events); }) {}

SoundNews SoundLoop::news() const {
    const std::lock_guard lock(mutex_);
    return news_;
}

void SoundLoop::set(const CueSetting& setting) {
    const std::lock_guard lock(mutex_);
    setting_ = setting;
}

void SoundLoop::run(const std::stop_token& stop, SoundWorld world, const EventSource& events) {
    leave_signals_to_main_thread();
    SoundOutput output(std::move(world.device), mixer_, steady_now_ns);
    HandCues cues(mixer_, output.clock());
    PollPace pace;
    for (unsigned poll = 0; !stop.stop_requested(); ++poll) {
        const bool had_event = take_events(events, cues);
        const std::int64_t now_ns = steady_now_ns();
        const int wait_us = pace.wait_us(had_event, now_ns);
        const bool is_hand_away = pace.is_resting(now_ns);
        if (is_hand_away || poll % polls_between_looks == 0)
            look_after(output, world, is_hand_away);
        std::this_thread::sleep_for(std::chrono::microseconds(wait_us));
    }
}

bool SoundLoop::take_events(const EventSource& events, HandCues& cues) {
    bool is_any = false;
    while (const auto event = events()) {
        CueSetting setting;
        {
            const std::lock_guard lock(mutex_);
            setting = setting_;
            news_.last_event = event;
        }
        cues.play(*event, setting);
        is_any = true;
    }
    return is_any;
}

bool SoundLoop::is_nobody_here() const {
    const std::lock_guard lock(mutex_);
    return setting_.is_nobody_here;
}

void SoundLoop::look_after(SoundOutput& output, const SoundWorld& world, bool is_hand_away) {
    output.rest(is_hand_away && is_nobody_here());
    output.step();
    const double now_s = 1e-9 * static_cast<double>(steady_now_ns());
    const auto input = ask(world.input_switch.get(), now_s);
    const auto jack = ask(world.jack_control.get(), now_s);
    const std::lock_guard lock(mutex_);
    news_.is_working = output.is_working();
    news_.problem = output.problem();
    news_.headphones = {std::nullopt, input, jack};
}

}  // namespace touchline
