// A private bus with python3-dbusmock's udisks2 on it, for as long as its owner lives.
// Threads: one.
#pragma once

#include "app/documents/sticks/bus_generations.h"
#include "app/isolation/process/child.h"
#include "config/types/pinned.h"
#include "tests/app/documents/sticks/stick_folder.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <poll.h>

namespace touchline {

/// Asks again and again until the condition holds, for about thirty seconds at most.
[[nodiscard]] inline bool becomes(const std::function<bool()>& is_so) {
    for (int i = 0; i < 15000; ++i) {
        if (is_so()) return true;
        (void)::poll(nullptr, 0, 2);
    }
    return false;
}

class MockedUdisks : private Pinned {
  public:
    /// `mock`: the path of udisks_mock.py.
    explicit MockedUdisks(std::string mock) : mock_(std::move(mock)) {
        ::setenv("DBUS_SYSTEM_BUS_ADDRESS", address().c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
        start_bus();
    }

    ~MockedUdisks() {
        stop_service();
        stop_bus();
    }

    void start_bus() {
        bus_.emplace(start("/usr/bin/dbus-daemon",
                           {"--session", "--nofork", "--nopidfile", "--address=" + address()}));
        is_up_ = becomes([this] {
            try {
                control_ = sdbus::createSystemBusConnection();
                return true;
            } catch (const sdbus::Error&) {
                return false;
            }
        });
    }

    void stop_bus() {
        control_.reset();
        end(bus_);
        std::filesystem::remove(folder_.path() / "bus");
    }

    /// `plugged`: the devices at the start, as JSON: lists of the arguments of the mock's Plug.
    void start_service(const std::string& plugged = "[]") {
        service_.emplace(
            start("/usr/bin/python3", {"-m", "dbusmock", "--system", "--parameters",
                                       R"({"plugged": )" + plugged + "}", "--template", mock_}));
        is_up_ = is_up_ && becomes([this] { return has_owner(); });
    }

    void stop_service() {
        end(service_);
        if (control_) is_up_ = is_up_ && becomes([this] { return !has_owner(); });
    }

    [[nodiscard]] bool is_up() const { return is_up_; }

    void plug(const std::string& name, const std::string& drive, const std::string& file_system,
              std::uint64_t detected_us, const std::string& behaviour = "good",
              const std::string& bus = "usb") {
        main()
            ->callMethod("Plug")
            .onInterface("org.freedesktop.DBus.Mock")
            .withArguments(name, drive, bus, file_system, detected_us, behaviour);
    }

    void pull(const std::string& name, const std::string& drive) {
        main()
            ->callMethod("Pull")
            .onInterface("org.freedesktop.DBus.Mock")
            .withArguments(name, drive);
    }

    [[nodiscard]] std::vector<std::string> asked(const std::string& name) {
        std::vector<std::string> asked;
        main()
            ->callMethod("Asked")
            .onInterface("org.freedesktop.DBus.Mock")
            .withArguments(name)
            .storeResultsTo(asked);
        return asked;
    }

  private:
    [[nodiscard]] std::string address() const {
        return "unix:path=" + (folder_.path() / "bus").string();
    }

    static Child start(const std::string& program, const std::vector<std::string>& words) {
        return Child::start(program, words, {}, StandardStreams::nothing).value();
    }

    static void end(std::optional<Child>& child) {
        if (!child) return;
        child->kill();
        (void)child->reap();
        child.reset();
    }

    bool has_owner() {
        bool has = false;
        proxy_of(*control_, "org.freedesktop.DBus", "/org/freedesktop/DBus")
            ->callMethod("NameHasOwner")
            .onInterface("org.freedesktop.DBus")
            .withArguments(std::string("org.freedesktop.UDisks2"))
            .storeResultsTo(has);
        return has;
    }

    std::unique_ptr<sdbus::IProxy> main() {
        return proxy_of(*control_, "org.freedesktop.UDisks2", "/org/freedesktop/UDisks2");
    }

    std::string mock_;
    StickFolder folder_;
    std::optional<Child> bus_;
    std::optional<Child> service_;
    std::unique_ptr<sdbus::IConnection> control_;
    bool is_up_ = false;
};

}  // namespace touchline
