// What libusb says, in the driver's words. Threads: pure function.
#pragma once

#include "haptics/device/board_link.h"

#include <libusb.h>

namespace touchline {

/// Of a libusb_error, or a number that is none.
[[nodiscard]] inline LinkStatus status_of(int error) {
    switch (error) {
        case LIBUSB_ERROR_NO_DEVICE:
            return LinkStatus::gone;
        case LIBUSB_ERROR_TIMEOUT:
            return LinkStatus::timed_out;
        case LIBUSB_ERROR_PIPE:
            return LinkStatus::stalled;
        default:
            return error < 0 ? LinkStatus::failed : LinkStatus::done;
    }
}

}  // namespace touchline
