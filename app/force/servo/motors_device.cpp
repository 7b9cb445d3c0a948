#include "app/force/servo/motors_device.h"

#include "app/force/device/procedures.h"
#include "config/types/utf8.h"
#include "haptics/device/moteus/can_socket.h"
#include "haptics/device/moteus/fdcanusb_link.h"
#include "haptics/device/moteus/moteus_pair.h"
#include "haptics/device/odrive/odrive_pair.h"
#include "haptics/device/serial/serial_port.h"
#include "haptics/servo/real_time.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::size_t word_count = 9;
constexpr std::uint8_t greatest_id = 126;
constexpr double a_day_s = 86400.0;

/// Knows whether the handle is where its angles say; when it is not, no angles come.
class WatchedMotors final : public JointDevice {
  public:
    explicit WatchedMotors(std::unique_ptr<MotorPantograph> motors)
        : JointDevice(motors->frame().profile().geometry), motors_(std::move(motors)) {}

    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override {
        const auto angles = motors_->read_angles(now_s);
        if (motors_->report().is_position_doubtful) has_lost_place_ = true;
        return has_lost_place_ ? std::nullopt : angles;
    }

    [[nodiscard]] Freshness freshness() const override { return motors_->freshness(); }

    [[nodiscard]] bool write_torques(JointTorques torques) override {
        return motors_->write_torques(torques);
    }

    [[nodiscard]] MotorPantograph& motors() { return *motors_; }

    [[nodiscard]] const std::atomic<bool>& has_lost_place() const { return has_lost_place_; }

  private:
    std::unique_ptr<MotorPantograph> motors_;
    std::atomic<bool> has_lost_place_{false};
};

void let_motors_go(void* device) noexcept {
    (void)static_cast<WatchedMotors*>(device)->motors().end_in_zero();
}

void put_drive(std::vector<std::string>& words, const JointDrive& drive) {
    words.emplace_back(drive.turn == Turn::clockwise ? "clockwise" : "counter-clockwise");
    words.push_back(fmt::format("{}", drive.ratio));
    words.push_back(fmt::format("{}", drive.zero_turns));
}

bool read_drive(std::span<const std::string> words, JointDrive& drive) {
    const auto ratio = number_in<double>(words[1]);
    const auto zero = number_in<double>(words[2]);
    const bool is_clockwise = words[0] == "clockwise";
    drive = {is_clockwise ? Turn::clockwise : Turn::counter_clockwise, ratio.value_or(0.0),
             zero.value_or(0.0)};
    return (is_clockwise || words[0] == "counter-clockwise") && ratio && zero;
}

Result<std::unique_ptr<MotorPair>> pair_of(const MotorsDevice& device) {
    const bool is_interface = !device.port.empty() && device.port.front() != '/';
    if (device.make == MotorsMake::moteus && is_interface) {
        return open_can_socket(device.port).map([&](std::unique_ptr<FrameLink> link) {
            return std::unique_ptr<MotorPair>(
                std::make_unique<MoteusPair>(std::move(link), device.ids));
        });
    }
    return open_serial_port(device.port).map([&](std::unique_ptr<ByteLink> port) {
        if (device.make == MotorsMake::moteus)
            return std::unique_ptr<MotorPair>(std::make_unique<MoteusPair>(
                std::make_unique<FdcanusbLink>(std::move(port)), device.ids));
        const double most_ratio =
            std::min(device.drives.joint_1.ratio, device.drives.joint_2.ratio);
        return std::unique_ptr<MotorPair>(std::make_unique<OdrivePair>(
            std::move(port), open_five_bar().torque_limit_Nm / most_ratio));
    });
}

/// The thread has the loop's priority, for a tick that is late costs the motors their watchdog.
Result<void> try_in_time(MotorPantograph& motors, const Opening& opening) {
    Result<void> tried;
    std::thread([&] {
        (void)become_real_time(MemoryLock::as_touched);
        tried = motors.open();
        if (!tried) return;
        if (motors.report().is_position_doubtful) {
            tried = failure(
                "the encoders do not tell where the handle is: use absolute ones, on shafts that "
                "turn no more than once for one turn of a joint");
            return;
        }
        MonotonicClock clock;
        MotorsProcedure procedure{motors, clock, opening.goes_on, opening.say, a_day_s};
        if (opening.mark_force) procedure.mark_force = opening.mark_force;
        tried = try_motors(procedure);
        if (!tried && !motors.words().empty()) tried = failure(motors.words());
        opening.say({});
    }).join();
    return tried;
}

}  // namespace

std::vector<std::string> arguments_of(const MotorsDevice& device) {
    std::vector<std::string> words{device.port, std::to_string(device.ids[0]),
                                   std::to_string(device.ids[1])};
    put_drive(words, device.drives.joint_1);
    put_drive(words, device.drives.joint_2);
    return words;
}

Result<MotorsDevice> motors_of(MotorsMake make, std::span<const std::string> words) {
    if (words.size() != word_count || words[0].empty())
        return failure("not what the kiosk starts it with");
    MotorsDevice device{make, words[0], {}, {}};
    const auto first = number_in<std::uint8_t>(words[1], std::uint8_t{1}, greatest_id);
    const auto second = number_in<std::uint8_t>(words[2], std::uint8_t{1}, greatest_id);
    const bool is_read = first && second && first != second &&
                         read_drive(words.subspan(3, 3), device.drives.joint_1) &&
                         read_drive(words.subspan(6, 3), device.drives.joint_2);
    if (!is_read || !check(device.drives)) return failure("the device's numbers are out of range");
    device.ids = {*first, *second};
    return device;
}

Result<std::unique_ptr<MotorPantograph>> take_motors(const MotorsDevice& device) {
    return pair_of(device).map([&](std::unique_ptr<MotorPair> pair) {
        return std::make_unique<MotorPantograph>(std::move(pair), open_five_bar(), device.drives);
    });
}

Result<OpenedDevice> open_motors(const MotorsDevice& device, const Opening& opening) {
    auto motors = take_motors(device);
    if (!motors) return tl::unexpected(motors.error());
    if (const auto tried = try_in_time(**motors, opening); !tried)
        return tl::unexpected(tried.error());
    auto watched = std::make_unique<WatchedMotors>(std::move(*motors));
    OpenedDevice result;
    result.profile = watched->motors().frame().profile();
    result.zero = {let_motors_go, watched.get()};
    result.has_lost_place = &watched->has_lost_place();
    result.release = [let_go = watched.get()] { return let_go->motors().stop(); };
    result.trouble = [let_go = watched.get()] { return let_go->motors().words(); };
    result.device = std::move(watched);
    return result;
}

Result<void> zero_motors(const MotorsDevice& device) {
    const auto motors = take_motors(device);
    if (!motors) return tl::unexpected(motors.error());
    // A busy machine holds up a serial port, and nobody should cut the power for that.
    constexpr int longest_ms = 1000;
    if ((*motors)->stop(longest_ms)) return {};
    return failure("the motors' controllers did not confirm that they let go: cut their power");
}

}  // namespace touchline
