#include "haptics/guidance/pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchline {
namespace {

constexpr double half_root = 0.5 * std::numbers::sqrt2;
constexpr Direction sideways{1.0, 0.0};
constexpr Direction away{0.0, 1.0};
constexpr Direction slanting{half_root, half_root};

// A hand feels shaking of 10 to 60 Hz well and its direction fairly; below 10 Hz the shaking moves
// it.
constexpr std::array rows{
    PatternRow{HandlePattern::focus, 1, sideways, 25.0, 0.6, 3, 0.06},
    PatternRow{HandlePattern::chosen, 2, away, 25.0, 0.7, 3, 0.10},
    PatternRow{HandlePattern::error, 3, sideways, 50.0, 0.9, 6, 0.10},
    PatternRow{HandlePattern::edge, 1, away, 50.0, 0.8, 12, 0.06},
    PatternRow{HandlePattern::time_out, 4, slanting, 12.5, 0.8, 2, 0.20},
};

constexpr double ending_s = 0.02;

const PatternRow* row_of(HandlePattern pattern) {
    const auto* const found = std::ranges::find(rows, pattern, &PatternRow::pattern);
    return found == rows.end() ? nullptr : found;
}

double pulse_s(const PatternRow& row) {
    return row.swings / row.frequency_Hz;
}

}  // namespace

std::span<const PatternRow> pattern_rows() {
    return rows;
}

double duration_s(const PatternRow& row) {
    return row.pulses * (pulse_s(row) + row.gap_s);
}

Force force_at(const PatternRow& row, double t_s) {
    if (!(t_s >= 0.0 && t_s < duration_s(row))) return {};
    const double in_pulse_s = std::fmod(t_s, pulse_s(row) + row.gap_s);
    if (in_pulse_s >= pulse_s(row)) return {};
    const double turn = 2.0 * std::numbers::pi * row.frequency_Hz * in_pulse_s;
    const double bell = 0.5 * (1.0 - std::cos(turn / row.swings));
    return along<Force>(row.direction, row.peak_N * bell * std::cos(turn));
}

bool PatternPlayer::is_sound() const {
    return playing_ == HandlePattern::none || row_of(playing_) != nullptr;
}

Force PatternPlayer::step(const PatternCommand& command, bool is_live, double dt_s) {
    if (is_first_) known_ = serial_ = command.serial;
    is_first_ = false;
    if (command.serial != known_) {
        known_ = serial_ = command.serial;
        wanted_ = is_live ? command.pattern : HandlePattern::none;
        is_ending_ = true;
    }
    if (!is_live) {
        wanted_ = HandlePattern::none;
        is_ending_ = true;
    }
    const PatternRow* row = row_of(playing_);
    const bool is_over = row == nullptr || t_s_ >= duration_s(*row) || (is_ending_ && gain_ <= 0.0);
    if (is_over) {
        playing_ = std::exchange(wanted_, HandlePattern::none);
        is_ending_ = false;
        t_s_ = 0.0;
        gain_ = 1.0;
        row = row_of(playing_);
    }
    if (row == nullptr) return {};
    t_s_ += dt_s;
    if (is_ending_) gain_ = std::max(0.0, gain_ - dt_s / ending_s);
    return gain_ * force_at(*row, t_s_);
}

}  // namespace touchline
