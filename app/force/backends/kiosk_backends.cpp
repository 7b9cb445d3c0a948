#include "app/force/backends/kiosk_backends.h"

#include "app/force/backends/inverse3.h"
#include "app/force/backends/usb_board.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

constexpr std::array rows{
    KioskBackend{"usb-board", find_usb_board, command_usb_board},
    KioskBackend{"inverse3", find_inverse3, command_inverse3},
};

}  // namespace

std::span<const KioskBackend> kiosk_backends() {
    return rows;
}

Result<KioskBackend> find_backend(std::string_view name) {
    const auto* const found = std::ranges::find(rows, name, &KioskBackend::name);
    if (found != rows.end()) return *found;
    std::string names;
    for (const KioskBackend& row : rows)
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    return failure("this program drives no device of the make '" + std::string(name) +
                   "'; set device.make to one of " + names);
}

Result<void> command_device(const DeviceCommandOptions& options, std::ostream& out) {
    const bool takes_all =
        options.action == DeviceAction::list || options.action == DeviceAction::stop;
    if (!options.make.empty() || !takes_all) {
        const auto row = find_backend(options.make.empty() ? rows.front().name : options.make);
        if (!row) return tl::unexpected(row.error());
        return row->command(options, out).result;
    }
    std::optional<Result<void>> first_absent;
    std::optional<Result<void>> worst_there;
    for (const KioskBackend& row : rows) {
        CommandEnd end = row.command(options, out);
        if (!end.was_there && !first_absent) first_absent = std::move(end.result);
        if (end.was_there && (!worst_there || !end.result)) worst_there = std::move(end.result);
    }
    return worst_there ? *worst_there : first_absent.value_or(Result<void>());
}

}  // namespace touchline
