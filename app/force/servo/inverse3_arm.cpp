#include "app/force/servo/inverse3_arm.h"

#include "haptics/device/inverse3/inverse3_device.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/real_time.h"

#include <memory>
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
Connected connect_in_time(const std::string& name, std::uint16_t port, const Opening& opening) {
    Connected connected = failure("not tried");
    std::thread([&] {
        (void)become_real_time(MemoryLock::as_touched);
        connected = Inverse3Service::connect(name, port, opening.goes_on);
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

Result<OpenedDevice> open_inverse3(const std::string& name, const Opening& opening,
                                   std::uint16_t port) {
    const auto profile = find_device_profile("inverse3");
    if (!profile) return tl::unexpected(profile.error());
    auto service = connect_in_time(name, port, opening);
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

Result<void> zero_inverse3(const std::string& name, std::uint16_t port) {
    const auto profile = find_device_profile("inverse3");
    if (!profile) return tl::unexpected(profile.error());
    auto service = Inverse3Service::connect(name, port);
    if (!service) return tl::unexpected(service.error());
    if (!Inverse3Device(std::move(*service), *profile).stop())
        return failure("the Inverse3's service did not confirm that it applies no force");
    return {};
}

}  // namespace touchline
