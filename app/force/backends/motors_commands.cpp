#include "app/force/backends/motors.h"
#include "app/force/backends/stop_wanted.h"
#include "app/force/device/procedures.h"
#include "config/types/utf8.h"
#include "haptics/device/homing.h"
#include "haptics/servo/real_time.h"

#include <array>
#include <cstdint>
#include <memory>
#include <ostream>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr int probed_ticks = 1000;
constexpr double held_s = 2.0;  // still at home
constexpr double longest_hold_s = 120.0;
constexpr double still_counts = 3.0;  // a hand that holds the handle at a jig moves it less

/// A unit and where it is plugged in.
struct TakenMotors {
    MotorUnit unit;
    std::unique_ptr<MotorPantograph> driver;
};

/// As it is where nobody measured: ids 1 and 2, straight on, zeros at 0.
MotorUnit usual_unit(MotorsMake make) {
    MotorUnit unit{std::string(name_of(make)), {}};
    unit.motors[1].id = 2;
    return unit;
}

Result<std::string> port_of(MotorsMake make, const DeviceCommandOptions& options) {
    const auto port = motor_port(make, options.port);
    if (!port) return tl::unexpected(port.error());
    if (*port) return **port;
    return failure(
        fmt::format("no adapter of the make {} is plugged in: plug it in, or name its "
                    "port with --port",
                    name_of(make)));
}

/// `measures`: the zeros are to be found, so what is kept of them does not count.
Result<TakenMotors> take_unit(MotorsMake make, const DeviceCommandOptions& options, bool measures) {
    const auto port = port_of(make, options);
    if (!port) return tl::unexpected(port.error());
    const auto stored = stored_motors(make);
    if (!stored) return tl::unexpected(stored.error());
    TakenMotors taken{stored->value_or(usual_unit(make)), nullptr};
    MotorUnit driven = taken.unit;
    for (MotorSettings& motor : driven.motors)
        if (measures) motor.zero_turns = 0.0;
    auto driver = take_motors(device_at(*port, make, driven));
    if (!driver) return tl::unexpected(driver.error());
    if (const auto opened = (*driver)->open(); !opened) return tl::unexpected(opened.error());
    taken.driver = std::move(*driver);
    return taken;
}

/// Ticks with zero torque until `step(angles, dt_s)` is false, or somebody wants it to end.
template <class Step>
void tick_at_rest(MotorPantograph& driver, Step step) {
    MonotonicClock clock;
    TickSchedule schedule(clock.now_ns(), 1'000'000);
    double last_s = 0.0;
    bool goes_on = true;
    while (goes_on && !is_stop_wanted()) {
        clock.sleep_until(schedule.due_ns());
        const double now_s = schedule.due_s();
        goes_on = step(driver.read_angles(now_s), now_s - last_s);
        (void)driver.write_torques({});
        last_s = now_s;
        schedule.finish(clock.now_ns());
    }
}

Result<void> probe_motors(MotorPantograph& driver, std::ostream& out) {
    int ticks = 0;
    tick_at_rest(driver, [&](const auto&, double) { return ++ticks < probed_ticks; });
    const DriveReport report = driver.report();
    out << fmt::format(
        "{} answers to {} questions, {} ticks went on without a new one, {} wrong, "
        "armed {} times.\n",
        report.replies, ticks, report.late, report.wrong, report.set_ups);
    const bool is_lost = report.state == DriveState::lost || report.state == DriveState::refused;
    if (!is_lost && report.replies > 0) return {};
    return failure("the motors' controllers gave up; " +
                   (driver.words().empty() ? std::string("plug them in again") : driver.words()));
}

Result<void> home_motors(TakenMotors& taken, std::ostream& out) {
    MotorPantograph& driver = *taken.driver;
    out << "Hold the handle at home: both inner arms 30 degrees in front of the motors, to both "
           "sides. It is measured when it has been still for two seconds.\n"
        << std::flush;
    Stillness stillness(still_counts * encoder_quantum(driver.frame().profile()));
    std::optional<JointAngles> there;
    double since_s = 0.0, unseen_s = 0.0;
    tick_at_rest(driver, [&](const auto& angles, double dt_s) {
        since_s += dt_s;
        unseen_s += dt_s;
        if (angles) stillness.step(*angles, std::exchange(unseen_s, 0.0));
        if (stillness.still_s() >= held_s) there = angles;
        return !there && since_s < longest_hold_s;
    });
    if (!there)
        return failure("the handle was not held still: hold it against a jig, and try again");
    const ShaftTurns zeros = driver.frame().shaft_turns(*there);
    taken.unit.motors[0].zero_turns = zeros.x;
    taken.unit.motors[1].zero_turns = zeros.y;
    if (auto kept = keep_motors(taken.unit); !kept) return kept;
    out << fmt::format("Zeros at {:.4f} and {:.4f} turns; kept in {}.\n", zeros.x, zeros.y,
                       plain_line(motors_file().string()));
    return {};
}

Result<void> nudge_motors(MotorPantograph& driver, std::ostream& out) {
    MonotonicClock clock;
    const MotorsProcedure procedure{driver, clock, [] { return !is_stop_wanted(); },
                                    [&out](const std::string& line) {
                                        if (!line.empty()) out << plain_line(line) << std::endl;
                                    }};
    const auto tried = try_motors(procedure);
    if (tried) out << "Both motors work.\n";
    return tried;
}

CommandEnd list_motors(MotorsMake make, std::ostream& out) {
    const auto ports = motor_ports(make);
    for (const std::string& port : ports)
        out << name_of(make) << ": an adapter at " << plain_line(port) << '\n';
    return {!ports.empty(), {}};
}

/// Sends nothing to an adapter of a make that nobody set up or named.
CommandEnd stop_motors(MotorsMake make, const DeviceCommandOptions& options, std::ostream& out) {
    const auto unit = stored_motors(make);
    if (!unit && options.make.empty()) return {false, tl::unexpected(unit.error())};
    const bool is_meant = !options.make.empty() || (unit && *unit);
    const auto port = port_of(make, options);
    if (!port || !is_meant) return {false, port ? Result<void>() : tl::unexpected(port.error())};
    const MotorUnit known = unit && *unit ? **unit : usual_unit(make);
    const auto zeroed = zero_motors(device_at(*port, make, known));
    if (zeroed) out << "The motors of the make " << name_of(make) << " are let go: confirmed.\n";
    return {true, zeroed};
}

Result<void> with_motors_taken(MotorsMake make, const DeviceCommandOptions& options,
                               std::ostream& out) {
    auto taken = take_unit(make, options, options.action == DeviceAction::home);
    if (!taken) return tl::unexpected(taken.error());
    switch (options.action) {
        case DeviceAction::probe:
            return probe_motors(*taken->driver, out);
        case DeviceAction::home:
            return home_motors(*taken, out);
        default:
            return nudge_motors(*taken->driver, out);
    }
}

CommandEnd command_motors(MotorsMake make, const DeviceCommandOptions& options, std::ostream& out) {
    if (options.action == DeviceAction::list) return list_motors(make, out);
    catch_stop_signals();
    if (options.action == DeviceAction::stop) return stop_motors(make, options, out);
    return {true, with_motors_taken(make, options, out)};
}

}  // namespace

CommandEnd command_moteus(const DeviceCommandOptions& options, std::ostream& out) {
    return command_motors(MotorsMake::moteus, options, out);
}

CommandEnd command_odrive(const DeviceCommandOptions& options, std::ostream& out) {
    return command_motors(MotorsMake::odrive, options, out);
}

}  // namespace touchline
