#include "haptics/device/usb_pantograph.h"

#include <string>
#include <utility>

namespace touchline {

Result<UsbPantograph> take_pantograph(const UsbBoards& usb, const BoardSettings& settings,
                                      std::string_view serial, std::string_view profile_name,
                                      const UsbLinkOptions& options) {
    auto found = usb.find(settings.boards, serial);
    if (!found) return tl::unexpected(found.error());
    const UnitSettings* unit = find_unit(settings, found->serial);
    const auto profile = find_profile(unit != nullptr ? unit->profile : profile_name);
    if (!profile) return tl::unexpected(profile.error());
    auto opened = usb.open(*found, options);
    if (!opened) return tl::unexpected(opened.error());
    const Calibration calibration = unit != nullptr ? unit->calibration : Calibration{};
    return UsbPantograph{
        std::move(*found), calibrated(*profile, calibration),
        std::make_unique<PantographBoard>(std::move(opened->link), *profile, calibration)};
}

}  // namespace touchline
