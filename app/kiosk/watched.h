// What a kiosk keeps an eye on: what comes and goes, as the visit and the log were told of it, and
// the clock: the site's hours, and how long its visits last. Threads: plain values.
#pragma once

#include "app/visit/visit_events.h"
#include "config/settings/setting_rows.h"
#include "config/settings/settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
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

    [[nodiscard]] bool is_in_trouble(TroubleKind kind) const {
        return !troubles_[static_cast<std::size_t>(kind)].empty();
    }

  private:
    std::optional<bool> are_headphones_in_;
    bool has_camera_ = false;
    bool is_listing_ = false;
    std::array<std::string, trouble_count> troubles_;  // as they were told
};

/// When the handle last became ready, with its starting point found.
class HandleReady {
  public:
    /// `is_waiting`: somebody has to do something for it first.
    void step(bool is_waiting, double now_s) {
        if (std::exchange(is_waiting_, is_waiting) && !is_waiting) since_s_ = now_s;
    }

    /// Nothing: not since the kiosk was started.
    [[nodiscard]] std::optional<double> since_s() const { return since_s_; }

  private:
    bool is_waiting_ = false;
    std::optional<double> since_s_;
};

/// Counts what stops working.
class FaultCount {
  public:
    /// `are_there`: whether the force, the sound, the camera is faulty now. Returns how many of
    /// these faults began since the last call.
    [[nodiscard]] std::uint64_t step(const std::array<bool, 3>& are_there) {
        std::uint64_t began = 0;
        for (std::size_t i = 0; i < are_there.size(); ++i)
            if (are_there[i] && !were_there_[i]) ++began;
        were_there_ = are_there;
        return began;
    }

  private:
    std::array<bool, 3> were_there_{};
};

/// What the site's hours say now.
struct HoursNow {
    std::optional<OpeningChanged> change;  // nothing: as it was
    bool is_quiet = false;
};

class SiteHours {
  public:
    /// `minute_of_day`: 0 ... 1439, of the site's clock; none: always open and never quiet.
    explicit SiteHours(std::function<int()> minute_of_day)
        : minute_of_day_(std::move(minute_of_day)) {}

    /// Looks at the clock once a second; nothing in between.
    [[nodiscard]] std::optional<HoursNow> look(double now_s, const Settings& settings) {
        constexpr double look_s = 1.0;
        if (now_s - looked_s_ < look_s) return std::nullopt;
        looked_s_ = now_s;
        const int minute = minute_of_day_ ? minute_of_day_() : no_clock;
        const SiteOpening opening = settings.is_maintained ? SiteOpening::maintenance
                                    : is_in(settings.opening_hours, minute).value_or(true)
                                        ? SiteOpening::open
                                        : SiteOpening::closed;
        HoursNow now{{}, is_in(settings.quiet_hours, minute).value_or(false)};
        if (opening != std::exchange(opening_, opening)) now.change = OpeningChanged{opening};
        return now;
    }

    /// The next look() looks, however soon it comes.
    void look_again() { looked_s_ = -1e9; }

  private:
    /// Nothing: there is no clock, or no such hours.
    static std::optional<bool> is_in(std::string_view hours, int minute) {
        const auto known = hours_in(hours);
        if (!known || minute == no_clock) return std::nullopt;
        return is_within(*known, minute);
    }

    static constexpr int no_clock = -1;

    std::function<int()> minute_of_day_;
    double looked_s_ = -1e9;
    SiteOpening opening_ = SiteOpening::open;
};

/// Times the visits, one after the other.
class VisitLength {
  public:
    /// The seconds that a visit took, when it ends; else nothing.
    [[nodiscard]] std::optional<double> step(bool is_on, double now_s) {
        const bool was_on = std::exchange(is_on_, is_on);
        if (is_on && !was_on) began_s_ = now_s;
        return was_on && !is_on ? std::optional(now_s - began_s_) : std::nullopt;
    }

  private:
    bool is_on_ = false;
    double began_s_ = 0.0;
};

}  // namespace touchline
