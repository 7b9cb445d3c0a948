#include "app/cli/device.h"

#include "app/device/board_files.h"
#include "app/device/device_words.h"
#include "app/device/procedures.h"
#include "haptics/device/usb_boards.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

std::atomic<bool> is_stop_wanted{false};

void want_stop(int) {
    is_stop_wanted = true;
}

void catch_signals() {
    static_assert(std::atomic<bool>::is_always_lock_free);
    std::signal(SIGINT, want_stop);
    std::signal(SIGTERM, want_stop);
    std::signal(SIGHUP, want_stop);
}

/// One board, how its unit is set, and the USB that it hangs on.
struct OpenedUnit {
    UsbBoards usb;
    UnitSettings settings;
    DeviceProfile profile;
    std::unique_ptr<BoardLink> link;
};

Result<std::string> serial_of(const UsbBoards& usb, const BoardSettings& known,
                              const std::string& wanted) {
    if (!wanted.empty()) return wanted;
    for (const FoundBoard& board : usb.list(known.boards))
        if (board.id.condition == BoardCondition::running && board.id.may_probe)
            return board.serial;
    return wanted;
}

Result<OpenedUnit> open_unit(const DeviceCommandOptions& options) {
    const auto known = read_board_files(board_files());
    if (!known) return tl::unexpected(known.error());
    auto usb = UsbBoards::create();
    if (!usb) return tl::unexpected(usb.error());
    const auto serial = serial_of(*usb, *known, options.serial);
    auto link = usb->open(known->boards, *serial);
    if (!link) return tl::unexpected(link.error());
    const UnitSettings* kept = find_unit(*known, *serial);
    UnitSettings unit = kept != nullptr ? *kept : UnitSettings{*serial, "", {}};
    if (!options.profile.empty()) unit.profile = options.profile;
    if (unit.profile.empty()) unit.profile = default_profile().name;
    auto profile = find_profile(unit.profile);
    if (!profile) return tl::unexpected(profile.error());
    return OpenedUnit{std::move(*usb), std::move(unit), *profile, std::move(*link)};
}

Result<void> list(std::ostream& out) {
    const auto known = read_board_files(board_files());
    if (!known) return tl::unexpected(known.error());
    const auto usb = UsbBoards::create();
    if (!usb) return tl::unexpected(usb.error());
    const std::vector<FoundBoard> found = usb->list(known->boards);
    for (const FoundBoard& board : found) out << describe(board) << '\n';
    if (!found.empty()) return {};
    out << "No board of a pantograph is plugged in. Looked for:\n";
    for (const BoardId& id : known->boards)
        if (id.condition == BoardCondition::running)
            out << fmt::format("  {} ({:04x}:{:04x})\n", id.name, id.vendor, id.product);
    return {};
}

/// Asks a thousand times and tells how the answers came.
Result<void> probe(OpenedUnit& unit, std::ostream& out) {
    constexpr int asked = 1000;
    PantographBoard board(std::move(unit.link), unit.profile, unit.settings.calibration);
    if (auto opened = board.open(); !opened) return opened;
    MonotonicClock clock;
    TickSchedule schedule(clock.now_ns(), 1'000'000);
    for (int i = 0; i < asked && !is_stop_wanted; ++i) {
        clock.sleep_until(schedule.due_ns());
        (void)board.read_angles(schedule.due_s());
        (void)board.write_torques({});
        schedule.finish(clock.now_ns());
    }
    const BoardReport report = board.report();
    out << fmt::format(
        "Board {} answers: {} of {} asked in time, {} late, {} lost, {} wrong.\n"
        "Unit: profile {}, {}.\n",
        unit.settings.serial, report.replies, asked, report.late, report.lost_replies,
        report.wrong_packets + report.unconfigured, unit.settings.profile,
        unit.settings.calibration.are_motors_swapped ? "motor plugs swapped"
                                                     : "motor plugs as usual");
    if (report.state != BoardState::lost) return {};
    return failure("the board was unplugged or gave up; plug it in and try again");
}

Result<void> home_unit(OpenedUnit& unit, std::ostream& out) {
    const BoardFiles files = board_files();
    const auto known = read_board_files(files);
    const bool is_known = known && find_unit(*known, unit.settings.serial) != nullptr;
    PantographBoard board(std::move(unit.link), unit.profile, unit.settings.calibration);
    if (auto opened = board.open(); !opened) return opened;
    MonotonicClock clock;
    const Procedure procedure{board, clock, is_stop_wanted,
                              [&out](const std::string& line) { out << line << std::endl; }};
    const auto found = home(procedure, is_known ? std::optional(unit.settings.calibration)
                                                : std::optional<Calibration>());
    if (!found) return tl::unexpected(found.error());
    unit.settings.calibration = *found;
    unit.settings.calibration.offset = {};  // holds only until the board is set up again
    if (auto kept = keep_unit(files, unit.settings); !kept) return kept;
    out << fmt::format("Scale {:.3f} and {:.3f}, {}; kept in {}.\n", found->scale.x, found->scale.y,
                       found->are_motors_swapped ? "motor plugs swapped" : "motor plugs as usual",
                       files.units.string());
    return {};
}

Result<void> nudge_unit(OpenedUnit& unit, std::ostream& out) {
    PantographBoard board(std::move(unit.link), unit.profile, unit.settings.calibration);
    if (auto opened = board.open(); !opened) return opened;
    MonotonicClock clock;
    const auto verdict = nudge({board, clock, is_stop_wanted,
                                [&out](const std::string& line) { out << line << std::endl; }});
    if (!verdict) return tl::unexpected(verdict.error());
    if (*verdict != NudgeVerdict::works) return failure(words_of(*verdict));
    out << words_of(*verdict) << '\n';
    return {};
}

Result<void> stop(OpenedUnit& unit, std::ostream& out) {
    if (!zero_torque(std::move(unit.link))) {
        return failure(
            "the board did not confirm that its motors are off: cut the power of the motors");
    }
    out << "The motors are off: the board confirmed zero torque.\n";
    return {};
}

}  // namespace

Result<void> run_device(const DeviceCommandOptions& options, std::ostream& out) {
    if (options.action == DeviceAction::list) return list(out);
    catch_signals();
    auto unit = open_unit(options);
    if (!unit) return tl::unexpected(unit.error());
    switch (options.action) {
        case DeviceAction::probe:
            return probe(*unit, out);
        case DeviceAction::home:
            return home_unit(*unit, out);
        case DeviceAction::nudge:
            return nudge_unit(*unit, out);
        default:
            return stop(*unit, out);
    }
}

}  // namespace touchline
