// Opens the plugged-in pantograph with what is known of the unit; programs start here.
#pragma once

#include "config/settings/boards.h"
#include "config/types/result.h"
#include "haptics/device/pantograph_board.h"
#include "haptics/device/usb_boards.h"
#include "haptics/pantograph/profile.h"

#include <memory>
#include <string_view>

namespace touchline {

struct UsbPantograph {
    FoundBoard found;
    DeviceProfile profile;  // with the unit's own torque limit
    std::unique_ptr<PantographBoard> driver;
};

/// Takes the board with that serial number, or the only one if none is given. Profile and
/// calibration are the unit's in `settings`, else `profile_name` and none. Nothing has been sent to
/// the board yet: driver->open() does that, with the handle at home. Allocates and waits.
[[nodiscard]] Result<UsbPantograph> take_pantograph(const UsbBoards& usb,
                                                    const BoardSettings& settings,
                                                    std::string_view serial,
                                                    std::string_view profile_name,
                                                    const UsbLinkOptions& options = {});

}  // namespace touchline
