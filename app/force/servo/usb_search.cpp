#include "app/force/servo/usb_search.h"

#include "haptics/device/board/usb_boards.h"

namespace touchline {
namespace {

UsbDevice usb_device(const FoundBoard& board, const BoardSettings& settings) {
    const UnitSettings* const unit = find_unit(settings, board.serial);
    UsbDevice device;
    device.id = board.id;
    device.serial = board.serial;
    if (unit == nullptr) return device;
    device.profile = unit->profile;
    device.calibration = unit->calibration;
    return device;
}

}  // namespace

Result<std::optional<UsbDevice>> find_usb_device(const BoardSettings& settings) {
    const auto boards = UsbBoards::create();
    if (!boards) return std::nullopt;  // a kiosk without any USB has no fault
    std::string why_not;
    for (const FoundBoard& board : boards->list(settings.boards)) {
        const bool is_known = board.id.may_probe || find_unit(settings, board.serial) != nullptr;
        if (board.access == BoardAccess::available && is_known) return usb_device(board, settings);
        if (is_known || board.id.condition != BoardCondition::running) why_not = describe(board);
    }
    if (!why_not.empty()) return failure(why_not);
    return std::nullopt;
}

}  // namespace touchline
