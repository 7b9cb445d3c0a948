// The shakes by which the handle speaks, in one table, and what plays them.
// Threads: plain values; no allocation.
#pragma once

#include "config/types/guidance.h"
#include "config/types/vec2.h"

#include <span>

namespace touchline {

/// Pulses of a force that swings to and fro along a line: a cosine under a bell, whole swings, so
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

/// A row for every pattern but none. Any two differ in at least two of: pulses, direction (by 45
/// degrees and more), frequency (by half and more).
[[nodiscard]] std::span<const PatternRow> pattern_rows();

/// Its force at t_s since it began; nothing before and after. O(1).
[[nodiscard]] Force force_at(const PatternRow& row, double t_s);

[[nodiscard]] double duration_s(const PatternRow& row);

/// A new pattern takes the place of one that plays, which ends in 20 ms. What is asked while
/// force is not live is left out: late it would say something else.
class PatternPlayer {
  public:
    /// One tick of dt_s > 0.
    [[nodiscard]] Force step(const PatternCommand& command, bool is_live, double dt_s);

    /// Of the last that was begun or left out.
    [[nodiscard]] std::uint32_t serial() const { return serial_; }

    /// Whether what plays is in the table. After a copy from elsewhere.
    [[nodiscard]] bool is_sound() const;

  private:
    bool is_first_ = true;
    std::uint32_t known_ = 0;  // the last that was told
    std::uint32_t serial_ = 0;
    HandlePattern wanted_ = HandlePattern::none;  // after the one that plays
    HandlePattern playing_ = HandlePattern::none;
    bool is_ending_ = false;
    double t_s_ = 0.0;
    double gain_ = 0.0;
};

}  // namespace touchline
