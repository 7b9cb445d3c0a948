#include "app/force/backends/inverse3.h"

#include "app/force/servo/inverse3_arm.h"
#include "config/types/utf8.h"
#include "haptics/device/inverse3/inverse3_device.h"
#include "haptics/servo/real_time.h"

#include <cstdint>
#include <memory>
#include <ostream>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

using Conversation = std::unique_ptr<Inverse3Service>;

constexpr int asked = 1000;  // by probe
constexpr std::int64_t period_ns = 1'000'000;

Result<void> absence(std::uint16_t port) {
    return failure(
        fmt::format("no Inverse3: its service does not answer at port {} of this computer; start "
                    "it (systemctl start haply-inverse-service)",
                    port));
}

MotorDevice motor_device(const std::string& word, const ArmAddress& address,
                         const std::string& name, const DeviceProfile& profile) {
    MotorDevice made;
    made.servo.arguments = {"inverse3", word};
    made.servo.zero_torque = [address](const std::string& /*bus_path*/) {
        return zero_inverse3(address).map([] { return ZeroedBoard::unknown; });
    };
    made.profile = profile;
    made.name = "inverse3 " + name;
    return made;
}

/// A second of commands of zero.
Result<void> probe(Conversation conversation, std::ostream& out) {
    const std::string name = plain_line(conversation->name());
    Inverse3Device device(std::move(conversation), find_device_profile("inverse3").value());
    MonotonicClock clock;
    TickSchedule schedule(clock.now_ns(), period_ns);
    LatenessHistogram lateness;
    int placed = 0;
    for (int i = 0; i < asked; ++i) {
        clock.sleep_until(schedule.due_ns());
        lateness.add(clock.now_ns() - schedule.due_ns());
        placed += device.read(schedule.due_s()) ? 1 : 0;
        (void)device.write({});
        schedule.finish(clock.now_ns());
    }
    const ArmReport report = device.report();
    out << fmt::format(
        "Inverse3 {}: a place in {} of {} ticks, {} places in all, {} frames that told nothing; "
        "the "
        "handle is {:.0f} mm above the plane.\nThis computer began the ticks {} us late (half of "
        "them less), {} us (the worst); {} were left out.\n",
        name, placed, asked, report.places, report.no_news, 1e3 * device.off_plane_m(),
        lateness.quantile_us(0.5), lateness.quantile_us(1.0), schedule.missed());
    if (report.state == ArmState::hindered) return failure(std::string(words_of(report.hindrance)));
    if (report.state == ArmState::lost)
        return failure("the Inverse3's service closed the connection: start it again");
    return {};
}

Result<void> list(const Conversation& conversation, std::ostream& out) {
    const std::string_view words = words_of(conversation->news().hindrance);
    out << fmt::format("Inverse3 {}: {}\n", plain_line(conversation->name()),
                       words.empty() ? "ready" : words);
    return {};
}

Result<void> stop(const ArmAddress& address, std::ostream& out) {
    if (auto zeroed = zero_inverse3(address); !zeroed) return zeroed;
    out << "The Inverse3's service answered: it applies no force.\n";
    return {};
}

}  // namespace

Result<std::optional<MotorDevice>> find_inverse3(const std::string& port) {
    const auto profile = find_device_profile("inverse3");
    if (!profile) return tl::unexpected(profile.error());
    const auto address = arm_address_of(port);
    if (!address) return tl::unexpected(address.error());
    const auto conversation = Inverse3Service::connect(address->name, address->port);
    if (!conversation) return tl::unexpected(conversation.error());
    return motor_device(port, *address, (*conversation)->name(), *profile);
}

CommandEnd command_inverse3(const DeviceCommandOptions& options, std::ostream& out) {
    const bool needs_nothing =
        options.action == DeviceAction::home || options.action == DeviceAction::nudge;
    if (needs_nothing)
        return {true, failure("an Inverse3 knows where its handle is: there is nothing to do")};
    const auto address = arm_address_of(options.port.empty() ? options.serial : options.port);
    if (!address) return {!options.make.empty(), tl::unexpected(address.error())};
    if (!Inverse3Service::answers(address->port)) return {false, absence(address->port)};
    if (options.action == DeviceAction::stop) return {true, stop(*address, out)};
    auto conversation = Inverse3Service::connect(address->name, address->port);
    if (!conversation) return {true, tl::unexpected(conversation.error())};
    if (options.action == DeviceAction::list) return {true, list(*conversation, out)};
    return {true, probe(std::move(*conversation), out)};
}

}  // namespace touchline
