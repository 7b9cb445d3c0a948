#include "app/force/servo/inverse3_arm.h"

#include "config/types/utf8.h"
#include "haptics/device/inverse3/inverse3_device.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/real_time.h"

#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace touchline {
namespace {

using Connected = Result<std::unique_ptr<Inverse3Service>>;

constexpr double look_s = 0.005;

void tell_zero(void* service) noexcept {
    (void)static_cast<Inverse3Service*>(service)->cut();
}

/// The service's thread has the priority of the thread that made it, which is to be the loop's.
Connected connect_in_time(const ArmAddress& address, const Opening& opening) {
    Connected connected = failure("not tried");
    std::thread([&] {
        (void)become_real_time(MemoryLock::as_touched);
        connected = Inverse3Service::connect(address.name, address.port, opening.goes_on);
    }).join();
    return connected;
}

/// False if nobody wants it any more, or the service closed the conversation.
bool wait_until_fit(Inverse3Service& service, const Opening& opening) {
    Hindrance said = Hindrance::none;
    for (;;) {
        const ArmNews news = service.news();
        if (!opening.goes_on() || news.is_gone) return false;
        if (news.hindrance != said) opening.say(std::string(words_of(news.hindrance)));
        said = news.hindrance;
        if (said == Hindrance::none) return true;
        service.rest(look_s);
    }
}

}  // namespace

Result<ArmAddress> arm_address_of(const std::string& text) {
    constexpr std::uint16_t least = 1, most = 65535;
    const std::size_t at = text.find('@');
    ArmAddress address{text.substr(0, at), inverse3_port};
    const auto port = at == std::string::npos ? std::optional(inverse3_port)
                                              : number_in(text.substr(at + 1), least, most);
    const bool is_name = address.name.empty() || ArmName::of(address.name);
    if (!is_name || !port)
        return failure(
            "the port of the Inverse3 must be the name that is printed on it, with @ and the "
            "service's port if that is another one, for example 04EA@10002: see device.port");
    address.port = *port;
    return address;
}

Result<OpenedDevice> open_inverse3(const ArmAddress& address, const Opening& opening) {
    const auto profile = find_device_profile("inverse3");
    if (!profile) return tl::unexpected(profile.error());
    auto service = connect_in_time(address, opening);
    if (!service) return tl::unexpected(service.error());
    if (!wait_until_fit(**service, opening))
        return failure("the Inverse3's service closed the connection: start it again");
    OpenedDevice opened;
    opened.zero = {tell_zero, service->get()};
    auto device = std::make_unique<Inverse3Device>(std::move(*service), *profile);
    opened.release = [arm = device.get()] { return arm->stop(); };
    opened.profile = *profile;
    opened.device = std::move(device);
    return opened;
}

Result<void> zero_inverse3(const ArmAddress& address) {
    const auto profile = find_device_profile("inverse3");
    if (!profile) return tl::unexpected(profile.error());
    auto service = Inverse3Service::connect(address.name, address.port);
    if (!service) return tl::unexpected(service.error());
    if (!Inverse3Device(std::move(*service), *profile).stop())
        return failure("the Inverse3's service did not confirm that it applies no force");
    return {};
}

}  // namespace touchline
