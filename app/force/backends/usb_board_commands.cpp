#include "app/force/backends/stop_wanted.h"
#include "app/force/backends/usb_board.h"
#include "app/force/device/board_files.h"
#include "app/force/device/device_words.h"
#include "app/force/device/procedures.h"
#include "config/types/utf8.h"
#include "haptics/device/board/usb_boards.h"
#include "haptics/servo/real_time.h"

#include <ostream>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

/// A board before its first command, and its USB, which outlives it.
struct TakenUnit {
    UsbBoards usb;
    UsbPantograph board;
    std::string profile;  // name
};

void tell(const std::string& notice, std::ostream& out) {
    if (!notice.empty()) out << plain_line(notice) << '\n';
}

std::string kind_wanted() {
    std::string names;
    for (const DeviceProfile& profile : device_profiles())
        names += (names.empty() ? "" : ", ") + std::string(profile.name);
    return "which kind of pantograph is it? Nothing is stored for this unit. Name its kind with "
           "--profile: " +
           names;
}

/// What is stored for a unit counts only for the kind that it was taken for. Naming a kind to home
/// it measures it anew, whatever is stored.
Result<UnitSettings> unit_for(const DeviceCommandOptions& options, const BoardSettings& settings,
                              const std::string& serial) {
    const UnitSettings* const stored = find_unit(settings, serial);
    const UnitSettings unit = stored != nullptr ? *stored : UnitSettings{serial, "", {}};
    std::string name = options.profile.empty() ? unit.profile : options.profile;
    const bool is_kind_needed = options.action != DeviceAction::probe;
    if (name.empty() && is_kind_needed) return failure(kind_wanted());
    if (name.empty()) name = default_profile().name;
    const bool is_named_to_home = !options.profile.empty() && options.action == DeviceAction::home;
    if (name == unit.profile && !is_named_to_home) return unit;
    return find_profile(name).map([&](const DeviceProfile& kind) { return as_kind(unit, kind); });
}

Result<TakenUnit> take(const DeviceCommandOptions& options, std::ostream& out) {
    auto settings = read_board_files(board_files());
    if (!settings) return tl::unexpected(settings.error());
    tell(settings->notice, out);
    auto usb = UsbBoards::create();
    if (!usb) return tl::unexpected(usb.error());
    const auto found = usb->find(settings->boards, options.serial);
    if (!found) return tl::unexpected(found.error());
    const auto unit = unit_for(options, *settings, found->serial);
    if (!unit) return tl::unexpected(unit.error());
    settings->units = {*unit};
    auto board = take_pantograph(*usb, *settings, found->serial, unit->profile);
    if (!board) return tl::unexpected(board.error());
    return TakenUnit{std::move(*usb), std::move(*board), unit->profile};
}

std::string plugs(const Calibration& calibration) {
    const auto told = [](const Plugs& plugs) {
        return plugs == Plugs{} ? "as usual" : "not as usual";
    };
    return fmt::format("encoders {}, motors {}", told(calibration.encoders),
                       told(calibration.motors));
}

Result<void> list(std::ostream& out) {
    const auto known = read_board_files(board_files());
    if (!known) return tl::unexpected(known.error());
    tell(known->notice, out);
    const auto usb = UsbBoards::create();
    if (!usb) return tl::unexpected(usb.error());
    const std::vector<FoundBoard> found = usb->list(known->boards);
    for (const FoundBoard& board : found) out << plain_line(describe(board)) << '\n';
    if (!found.empty()) return {};
    out << "No board of a pantograph is plugged in. Looked for:\n";
    for (const BoardId& id : known->boards)
        if (id.condition == BoardCondition::running)
            out << fmt::format("  {} ({:04x}:{:04x})\n", id.name, id.vendor, id.product);
    return {};
}

/// Asks a thousand times and reports how the answers came.
Result<void> probe(TakenUnit& unit, std::ostream& out) {
    constexpr int asked = 1000;
    PantographBoard& board = *unit.board.driver;
    if (auto opened = board.open(); !opened) return opened;
    MonotonicClock clock;
    TickSchedule schedule(clock.now_ns(), 1'000'000);
    LatenessHistogram lateness;
    for (int i = 0; i < asked && !is_stop_wanted(); ++i) {
        clock.sleep_until(schedule.due_ns());
        lateness.add(clock.now_ns() - schedule.due_ns());
        (void)board.read_angles(schedule.due_s());
        (void)board.write_torques({});
        schedule.finish(clock.now_ns());
    }
    const BoardReport report = board.report();
    out << fmt::format(
        "Board {}: {} answers to {} questions, {} ticks went on without a new one, "
        "{} answers lost, {} wrong.\nUnit: profile {}, {}.\n",
        plain_line(unit.board.found.serial), report.replies, asked, report.late,
        report.lost_replies, report.wrong_packets + report.unconfigured, unit.profile,
        plugs(board.frame().calibration()));
    out << fmt::format(
        "This computer began the ticks {} us late (half of them less), {} us (all but 1 %), {} us "
        "(the worst); {} were left out.\n",
        lateness.quantile_us(0.5), lateness.quantile_us(0.99), lateness.quantile_us(1.0),
        schedule.missed());
    if (report.state != BoardState::lost) return {};
    return failure("the board was unplugged or gave up; plug it in and try again");
}

Procedure procedure(PantographBoard& board, Clock& clock, std::ostream& out) {
    return {board, clock, [] { return !is_stop_wanted(); },
            [&out](const std::string& line) { out << plain_line(line) << std::endl; }};
}

Result<void> home_unit(TakenUnit& unit, std::ostream& out) {
    PantographBoard& board = *unit.board.driver;
    if (auto opened = board.open(); !opened) return opened;
    MonotonicClock clock;
    const auto found = make_ready(procedure(board, clock, out), board.frame().calibration());
    if (!found) return tl::unexpected(found.error());
    UnitSettings settings{unit.board.found.serial, unit.profile, *found};
    settings.calibration.offset = {};  // valid only until the board is set up again
    const BoardFiles files = board_files();
    if (auto kept = keep_unit(files, settings); !kept) return kept;
    out << fmt::format("Scale {:.3f}, {}; kept in {}.\n", found->scale, plugs(*found),
                       plain_line(files.units.string()));
    return {};
}

Result<void> nudge_unit(TakenUnit& unit, std::ostream& out) {
    PantographBoard& board = *unit.board.driver;
    const Calibration stored = board.frame().calibration();
    if (!stored.is_measured) return failure("Home the handle first.");
    if (auto opened = board.open(); !opened) return opened;
    MonotonicClock clock;
    // Only homing shows where the middle is.
    const auto homed = home(procedure(board, clock, out), stored);
    if (!homed) return tl::unexpected(homed.error());
    const auto tried = nudge(procedure(board, clock, out), homed->words + " ");
    if (!tried) return tl::unexpected(tried.error());
    const std::string words = words_of(tried->verdict(), board.frame());
    if (tried->verdict() != NudgeVerdict::works) return failure(words);
    out << words << '\n';
    return {};
}

/// Does without the units if it must: a broken file must not keep a motor running.
Result<BoardSettings> settings_to_stop_by() {
    auto settings = read_board_files(board_files());
    return settings ? settings : read_boards(board_files().boards);
}

/// The profile as far as it is known: it tells whether a motor is at the handle.
DeviceProfile profile_of(const BoardSettings& settings, const FoundBoard& board) {
    const UnitSettings* const unit = find_unit(settings, board.serial);
    return profile_or_default(unit == nullptr ? std::string_view() : unit->profile);
}

Result<void> stop_board(const UsbBoards& usb, const FoundBoard& board, const DeviceProfile& profile,
                        std::ostream& out) {
    auto opened = usb.open(board);
    if (!opened) return tl::unexpected(opened.error());
    if (!zero_torque(std::move(opened->link), profile)) {
        return failure("board " + board.serial +
                       " did not confirm that its motors are off: cut the power of the motors");
    }
    out << fmt::format("The motors of board {} are off: it confirmed zero torque.\n",
                       plain_line(board.serial));
    return {};
}

/// Stops every board that the kiosk might have driven, or the named one.
CommandEnd stop(const DeviceCommandOptions& options, std::ostream& out) {
    const auto settings = settings_to_stop_by();
    if (!settings) return {false, tl::unexpected(settings.error())};
    const auto usb = UsbBoards::create();
    if (!usb) return {false, tl::unexpected(usb.error())};
    Result<void> worst;
    bool was_any = false;
    for (const FoundBoard& board : usb->list(settings->boards)) {
        const bool is_meant = options.serial.empty()
                                  ? board.id.may_probe || find_unit(*settings, board.serial)
                                  : board.serial == options.serial;
        if (board.id.condition != BoardCondition::running || !is_meant) continue;
        was_any = true;
        const DeviceProfile profile = profile_of(*settings, board);
        if (auto stopped = stop_board(*usb, board, profile, out); !stopped) worst = stopped;
    }
    if (was_any) return {true, worst};
    return {false, usb->find(settings->boards, options.serial).map([](const FoundBoard&) {})};
}

Result<void> with_unit(const DeviceCommandOptions& options, std::ostream& out) {
    auto unit = take(options, out);
    if (!unit) return tl::unexpected(unit.error());
    switch (options.action) {
        case DeviceAction::probe:
            return probe(*unit, out);
        case DeviceAction::home:
            return home_unit(*unit, out);
        default:
            return nudge_unit(*unit, out);
    }
}

}  // namespace

CommandEnd command_usb_board(const DeviceCommandOptions& options, std::ostream& out) {
    if (options.action == DeviceAction::list) return {true, list(out)};
    catch_stop_signals();
    if (options.action == DeviceAction::stop) return stop(options, out);
    return {true, with_unit(options, out)};
}

}  // namespace touchline
