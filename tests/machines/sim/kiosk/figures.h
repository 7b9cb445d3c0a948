// The outcome of a simulated site: counts, worst values, the hash of each second, and the first
// failure. Threads: plain values.
#pragma once

#include "tests/machines/sim/kiosk/plan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct SimFailure {
    double at_s = 0.0;    // site time
    std::string checker;  // which found it
    std::string words;
};

struct SimFigures {
    std::uint64_t seeds = 0;
    std::uint64_t ticks = 0;  // ticks of the servo's loop
    double servo_s = 0.0;     // time with a servo that ticks
    double session_s = 0.0;   // site time, including skipped spans
    std::uint64_t visits = 0;
    std::uint64_t pictures = 0;
    std::uint64_t keys = 0;
    std::uint64_t cues = 0;
    std::uint64_t utterances = 0;
    std::uint64_t strokes = 0;       // drawn for visitors
    std::uint64_t grown = 0;         // a drawing grew or shrank while its force was on
    std::uint64_t sheets = 0;        // given to the printer
    std::uint64_t turned_pages = 0;  // of the braille display
    std::array<std::uint64_t, sim_fault_count> fired{};
    std::array<std::uint64_t, sim_fault_count> pressed{};  // of these, while torque was on
    std::array<double, sim_fault_count> zero_s{};          // the longest time to zero torque
    double most_N = 0.0, most_N_share = 0.0;               // share of the device's limit
    double most_torque_Nm = 0.0;
    double most_rise_N_per_s = 0.0, most_change_N_per_s = 0.0;
    double most_grown_N = 0.0;  // change of the force by a line that came, beyond the hand's motion
    double most_given_J = 0.0;  // in one second, beyond what the hand gave before
    double longest_answer_s = 0.0, longest_cue_s = 0.0;
    double longest_ready_s = 0.0, longest_silence_s = 0.0;
    std::vector<std::uint64_t> hashes;  // one per second
    std::optional<SimFailure> failure;  // the first failure
    std::uint64_t failed_seeds = 0;

    /// Adds the figures of another site. Hashes and failure stay those of this one.
    void add(const SimFigures& other);
};

inline void SimFigures::add(const SimFigures& other) {
    seeds += other.seeds;
    ticks += other.ticks;
    servo_s += other.servo_s;
    session_s += other.session_s;
    visits += other.visits;
    pictures += other.pictures;
    keys += other.keys;
    cues += other.cues;
    utterances += other.utterances;
    strokes += other.strokes;
    grown += other.grown;
    sheets += other.sheets;
    turned_pages += other.turned_pages;
    failed_seeds += other.failed_seeds;
    for (std::size_t i = 0; i < sim_fault_count; ++i) {
        fired[i] += other.fired[i];
        pressed[i] += other.pressed[i];
        zero_s[i] = std::max(zero_s[i], other.zero_s[i]);
    }
    for (const auto member :
         {&SimFigures::most_N, &SimFigures::most_N_share, &SimFigures::most_torque_Nm,
          &SimFigures::most_rise_N_per_s, &SimFigures::most_change_N_per_s,
          &SimFigures::most_grown_N, &SimFigures::most_given_J, &SimFigures::longest_answer_s,
          &SimFigures::longest_cue_s, &SimFigures::longest_ready_s, &SimFigures::longest_silence_s})
        this->*member = std::max(this->*member, other.*member);
}

/// A state as one number, the same wherever the same numbers were computed.
class StateHash {
  public:
    void mix(std::uint64_t bits) {
        state_ = (state_ ^ bits) * 0x9fb21c651e98df25ULL;
        state_ ^= state_ >> 35U;
    }

    void mix(double value) { mix(std::bit_cast<std::uint64_t>(value)); }

    void mix(std::string_view text) {
        for (const char letter : text) mix(static_cast<std::uint64_t>(letter));
    }

    [[nodiscard]] std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace touchline
