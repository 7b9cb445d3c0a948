// What comes and goes at a kiosk, and what the visit and the log were told of it.
// Threads: plain values; no clock.
#pragma once

#include "app/session/visit_events.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace touchline {

enum class Part : std::uint8_t { sticks, sound, camera };
inline constexpr std::size_t part_count = 3;

/// What a kiosk works without. Each absence gets one line in the log for as long as it lasts.
class MissingParts {
  public:
    /// How long a part may take to start.
    static constexpr double patience_s = 5.0;

    /// `now_s` never falls. Returns the line for the log; empty: nothing new.
    [[nodiscard]] std::string step(Part part, bool is_there, double now_s) {
        Absence& absence = absences_[static_cast<std::size_t>(part)];
        if (is_there) absence = {};
        if (is_there || absence.is_told) return {};
        if (!absence.since_s) absence.since_s = now_s;
        if (now_s - *absence.since_s < patience_s) return {};
        absence.is_told = true;
        return lines[static_cast<std::size_t>(part)];
    }

  private:
    struct Absence {
        std::optional<double> since_s;
        bool is_told = false;
    };

    static constexpr std::array<const char*, part_count> lines{
        "USB sticks are not offered: udisks2 does not answer",
        "there is no sound: no sound card can be used; check it with 'aplay -l'",
        "there is no camera: no photographs are offered; check its plug"};

    std::array<Absence, part_count> absences_;
};

/// Each call says what is so now, and returns what the visit must be told of it; nothing: it knows.
class Watched {
  public:
    /// Headphones that cannot be detected count as in.
    [[nodiscard]] std::optional<VisitEvent> headphones(std::optional<bool> are_in) {
        if (are_in == std::exchange(are_headphones_in_, are_in)) return std::nullopt;
        return HeadphonesChanged{are_in.value_or(true)};
    }

    [[nodiscard]] std::optional<VisitEvent> camera(bool is_there) {
        if (is_there == std::exchange(has_camera_, is_there)) return std::nullopt;
        return CameraChanged{is_there};
    }

    /// Whether a stick's files are being listed.
    [[nodiscard]] std::optional<VisitEvent> listing(bool is_under_way) {
        if (std::exchange(is_listing_, is_under_way) || !is_under_way) return std::nullopt;
        return StickArriving{};
    }

    /// `sentence`: as TroubleBegan has it; empty: there is no such trouble.
    [[nodiscard]] std::optional<VisitEvent> trouble(TroubleKind kind, const std::string& sentence) {
        std::string& told = troubles_[static_cast<std::size_t>(kind)];
        if (sentence == told) return std::nullopt;
        told = sentence;
        if (sentence.empty()) return TroubleEnded{kind};
        return TroubleBegan{kind, sentence};
    }

    [[nodiscard]] bool has_camera() const { return has_camera_; }

  private:
    std::optional<bool> are_headphones_in_;
    bool has_camera_ = false;
    bool is_listing_ = false;
    std::array<std::string, trouble_count> troubles_;  // as they were told
};

}  // namespace touchline
