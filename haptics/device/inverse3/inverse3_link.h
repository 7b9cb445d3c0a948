// One open conversation about a device, whatever carries the frames. Neither call waits for the
// service, and neither allocates or locks: somebody else sends and hears (inverse3_service.h).
#pragma once

#include "config/types/pinned.h"
#include "haptics/device/inverse3/inverse3_session.h"

namespace touchline {

/// Threads: one at a time. The destructor ends the conversation.
class Inverse3Link : public Interface {
  public:
    /// The newest there is, the same until there is more.
    [[nodiscard]] virtual ArmNews news() = 0;

    /// Wants this force from now on. It goes as soon as the frame before is answered; one that is
    /// not renewed within longest_arm_silence_s becomes zero.
    virtual void tell(const WantedArmForce& wanted) = 0;

    /// Waits for span_s.
    virtual void rest(double span_s) = 0;
};

}  // namespace touchline
