// Whatever ends the servo process, the torque goes to zero first, because the board holds its last
// torque forever. Handles signals that ask for an end, signals of a crash, and the kiosk's death.
#pragma once

#include "haptics/servo/exchange.h"
#include "haptics/servo/servo.h"

namespace touchline {

/// Writes zero torque from a signal handler, to a device that nobody else uses at that moment. It
/// does not allocate and, as far as that is possible, takes no lock that the crashed code may hold.
struct EmergencyZero {
    void (*write)(void* device) noexcept = nullptr;  // null: nothing to write to
    void* device = nullptr;
};

/// While one lives (at most one may):
///   SIGTERM, SIGINT      force fades out, then the loop ends
///   SIGHUP               the kiosk died: zero with the next tick
///   SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU
///                        zero with the next tick; 3 ms later zero from the handler, for the loop
///                        itself may have crashed; then the process dies of the signal
/// Threads: made and destroyed by the main thread, with the servo running in between.
class ZeroOnSignal {
  public:
    ZeroOnSignal(Servo& servo, ServoChannel& channel, const EmergencyZero& zero);
    ~ZeroOnSignal();
    ZeroOnSignal(const ZeroOnSignal&) = delete;
    ZeroOnSignal(ZeroOnSignal&&) = delete;
    ZeroOnSignal& operator=(const ZeroOnSignal&) = delete;
    ZeroOnSignal& operator=(ZeroOnSignal&&) = delete;

    /// True if an end was asked for or the kiosk died.
    [[nodiscard]] bool is_end_asked() const;
};

}  // namespace touchline
