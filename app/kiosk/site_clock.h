// What a kiosk does by the clock: its site's hours, and how long its visits last.
// Threads: plain values.
#pragma once

#include "app/session/visit_events.h"
#include "config/settings/setting_texts.h"
#include "config/settings/settings.h"

#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace touchline {

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
        const std::optional<int> minute =
            minute_of_day_ ? std::optional(minute_of_day_()) : std::nullopt;
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
    static std::optional<bool> is_in(std::string_view hours, std::optional<int> minute) {
        const auto known = hours_in(hours);
        if (!known || !minute) return std::nullopt;
        return is_within(*known, *minute);
    }

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
