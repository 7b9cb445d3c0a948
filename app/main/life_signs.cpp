#include "app/main/life_signs.h"

#include <utility>

#include <systemd/sd-daemon.h>

namespace touchline {
namespace {

std::int64_t watchdog_ns() {
    std::uint64_t time_us = 0;
    return sd_watchdog_enabled(0, &time_us) > 0 ? static_cast<std::int64_t>(time_us) * 1000 : 0;
}

/// A lost sign does no harm: the next one comes, or systemd restarts the kiosk.
void tell(const char* sign) {
    (void)sd_notify(0, sign);
}

}  // namespace

LifeSigns::LifeSigns() : pace_(watchdog_ns()) {}

void LifeSigns::beat(std::int64_t now_ns, std::uint64_t servo_beats) {
    if (!std::exchange(is_ready_, true)) tell("READY=1");
    if (pace_.step(now_ns, servo_beats)) tell("WATCHDOG=1");
}

void LifeSigns::end() {
    tell("STOPPING=1");
}

}  // namespace touchline
