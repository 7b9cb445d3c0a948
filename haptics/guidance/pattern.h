// The table of shakes by which the handle speaks, and the player for them.
// Threads: plain values; no allocation.
#pragma once

#include "config/types/guidance.h"
#include "config/types/vec2.h"

#include <span>

namespace touchline {

/// Pulses of a force that swings to and fro along a line: whole swings of a cosine under a bell, so
/// that neither its sum nor its moment in time pushes the hand anywhere.
struct PatternRow {
    HandlePattern pattern = HandlePattern::none;
    int pulses = 0;
    Direction direction;
    double frequency_Hz = 0.0;
    double peak_N = 0.0;  // <= 1
    int swings = 0;       // in a pulse, >= 2
    double gap_s = 0.0;   // after each pulse
};

/// One row for every pattern except none. Any two differ in at least two of: pulses, direction (by
/// 45 degrees and more), frequency (by half and more).
[[nodiscard]] std::span<const PatternRow> pattern_rows();

/// Returns its force at t_s since it began; zero before and after. O(1).
[[nodiscard]] Force force_at(const PatternRow& row, double t_s);

[[nodiscard]] double duration_s(const PatternRow& row);

/// Plays one pattern at a time. A new pattern replaces the playing one, which ends in 20 ms. A
/// pattern asked for while force is not live is left out: late, it would mean something else.
class PatternPlayer {
  public:
    /// Advances one tick of dt_s > 0.
    [[nodiscard]] Force step(const PatternCommand& command, bool is_live, double dt_s);

    /// The serial of the last command that was begun or left out.
    [[nodiscard]] std::uint32_t serial() const { return serial_; }

    /// Whether the playing pattern is in the table, for a copy from elsewhere.
    [[nodiscard]] bool is_sound() const;

  private:
    bool is_first_ = true;
    std::uint32_t known_ = 0;  // the last one received
    std::uint32_t serial_ = 0;
    HandlePattern wanted_ = HandlePattern::none;  // after the one that plays
    HandlePattern playing_ = HandlePattern::none;
    bool is_ending_ = false;
    double t_s_ = 0.0;
    double gain_ = 0.0;
};

}  // namespace touchline
