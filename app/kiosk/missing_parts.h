// What a kiosk works without. Each absence gets one line in the log for as long as it lasts.
// Threads: a plain value; no clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace touchline {

enum class Part : std::uint8_t { sticks, sound, camera };
inline constexpr std::size_t part_count = 3;

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

}  // namespace touchline
