#include "app/documents/sticks/stick_port.h"

#include "app/documents/sticks/bus_generations.h"
#include "app/documents/sticks/mount_rules.h"
#include "app/isolation/process/descriptor.h"

#include <array>
#include <map>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <sdbus-c++/Types.h>
#include <sys/stat.h>

namespace touchline {
namespace {

constexpr std::int64_t look_every_ns = 500'000'000;

bool is_empty_folder(const Descriptor& folder) {
    alignas(dirent64) std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t got = ::getdents64(folder.number(), buffer.data(), buffer.size());
        if (got <= 0) return true;
        for (std::size_t at = 0; at < static_cast<std::size_t>(got);) {
            const auto& entry = *reinterpret_cast<const dirent64*>(buffer.data() + at);
            at += entry.d_reclen;
            const std::string_view name = entry.d_name;
            if (name != "." && name != "..") return false;
        }
    }
}

/// What is in the folder belongs to the operator and is offered to the next visitor too.
class FolderPort final : public StickPort {
  public:
    explicit FolderPort(std::string folder) : folder_(std::move(folder)) {}

    std::vector<StickEvent> poll(std::int64_t now_ns) override {
        if (now_ns < next_look_ns_) return {};
        next_look_ns_ = now_ns + look_every_ns;
        const auto now = look();
        if (now == last_) return {};
        std::vector<StickEvent> events;
        if (last_) events.push_back({StickNews::gone, folder_, ""});
        if (now) events.push_back({StickNews::ready, folder_, ""});
        last_ = now;
        return events;
    }

    void allow(FileSystems /*allowed*/) override {}

    void end_session() override {}

    /// True while the folder exists.
    [[nodiscard]] bool is_watching() const override { return is_watching_; }

  private:
    /// Changes with what is mounted there, and with each name that comes or goes.
    struct Look {
        std::uint64_t device = 0;
        std::uint64_t number = 0;
        std::int64_t changed_s = 0;
        std::int64_t changed_ns = 0;

        friend bool operator==(const Look&, const Look&) = default;
    };

    std::optional<Look> look() {
        const Descriptor folder(
            ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NONBLOCK));
        FileStatus status{};
        is_watching_ = folder.is_open() && ::fstat(folder.number(), &status) == 0;
        if (!is_watching_ || is_empty_folder(folder)) return std::nullopt;
        return Look{status.st_dev, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
    }

    std::string folder_;
    std::optional<Look> last_;  // none: empty or missing
    std::int64_t next_look_ns_ = 0;
    bool is_watching_ = false;
};

using BusProperties = std::map<std::string, sdbus::Variant>;
using BusInterfaces = std::map<std::string, BusProperties>;
/// The answer of org.freedesktop.DBus.ObjectManager.GetManagedObjects.
using BusObjects = std::map<sdbus::ObjectPath, BusInterfaces>;

const BusProperties* find(const BusInterfaces& interfaces, const std::string& name) {
    const auto found = interfaces.find("org.freedesktop.UDisks2." + name);
    return found == interfaces.end() ? nullptr : &found->second;
}

template <class T>
T get(const BusProperties& properties, const std::string& name) {
    const auto found = properties.find(name);
    if (found == properties.end() || !found->second.containsValueOfType<T>()) return {};
    return found->second.get<T>();
}

/// Paths come as bytes with a zero at the end.
std::vector<std::string> roots_of(const BusProperties& file_system) {
    std::vector<std::string> roots;
    for (const auto& bytes :
         get<std::vector<std::vector<std::uint8_t>>>(file_system, "MountPoints")) {
        std::string root(bytes.begin(), bytes.end());
        while (root.ends_with('\0')) root.pop_back();
        if (!root.empty()) roots.push_back(std::move(root));
    }
    return roots;
}

/// All block devices that are on a drive. O(n log n).
std::vector<Volume> volumes_of(const BusObjects& objects) {
    std::vector<Volume> volumes;
    for (const auto& [path, interfaces] : objects) {
        const BusProperties* const block = find(interfaces, "Block");
        if (block == nullptr) continue;
        const auto drive_path = get<sdbus::ObjectPath>(*block, "Drive");
        const auto drive_object = objects.find(drive_path);
        if (drive_object == objects.end()) continue;
        const BusProperties* const drive = find(drive_object->second, "Drive");
        if (drive == nullptr) continue;
        Volume volume;
        volume.object = path;
        volume.drive = drive_path;
        volume.bus = get<std::string>(*drive, "ConnectionBus");
        volume.usage = get<std::string>(*block, "IdUsage");
        volume.file_system = get<std::string>(*block, "IdType");
        volume.detected_us = get<std::uint64_t>(*drive, "TimeMediaDetected");
        volume.bytes = get<std::uint64_t>(*block, "Size");
        volume.is_of_system = get<bool>(*block, "HintSystem");
        volume.is_ignored = get<bool>(*block, "HintIgnore");
        volume.is_partitioned = find(interfaces, "PartitionTable") != nullptr;
        if (const BusProperties* const files = find(interfaces, "Filesystem"); files != nullptr)
            volume.roots = roots_of(*files);
        volumes.push_back(std::move(volume));
    }
    return volumes;
}

constexpr std::int64_t try_again_ns = 5'000'000'000;
constexpr std::uint64_t answer_us = 30'000'000;  // a slow stick takes time to mount
constexpr const char* service = "org.freedesktop.UDisks2";
constexpr const char* main_object = "/org/freedesktop/UDisks2";
constexpr const char* object_manager = "org.freedesktop.DBus.ObjectManager";
constexpr const char* file_system_interface = "org.freedesktop.UDisks2.Filesystem";
constexpr const char* changes =
    "type='signal',sender='org.freedesktop.UDisks2',interface='org.freedesktop.DBus.Properties',"
    "member='PropertiesChanged'";
constexpr const char* owners =
    "type='signal',sender='org.freedesktop.DBus',interface='org.freedesktop.DBus',"
    "member='NameOwnerChanged',arg0='org.freedesktop.UDisks2'";

constexpr const char* already_mounted = "org.freedesktop.UDisks2.Error.AlreadyMounted";

/// False if the message holds something else. Nothing may be thrown through the bus's library.
template <class... Values>
bool is_read(sdbus::Message& message, Values&... values) {
    try {
        (message >> ... >> values);
        return true;
    } catch (const sdbus::Error&) {
        return false;
    }
}

/// Waits for udisks2 if it is absent or restarts. Threads: one, which calls poll().
class UdisksPort final : public StickPort {
  public:
    /// Does not look at the bus yet.
    UdisksPort();
    ~UdisksPort() override;

    [[nodiscard]] std::vector<StickEvent> poll(std::int64_t now_ns) override;

    void allow(FileSystems allowed) override { rules_.allow(allowed); }

    /// The following polls unmount the stick.
    void end_session() override;

    [[nodiscard]] bool is_watching() const override { return is_watching_; }

  private:
    class Bus;

    void connect(std::int64_t now_ns);
    void carry_out(const StickStep& step);
    void lose_service();

    std::unique_ptr<Bus> bus_;  // null: no bus
    MountRules rules_;
    std::vector<StickEvent> events_;
    std::int64_t next_try_ns_ = 0;
    bool is_watching_ = false;
};

/// The connection, and its messages in their order.
class UdisksPort::Bus {
  public:
    /// Throws sdbus::Error if there is no bus.
    explicit Bus(UdisksPort& port) : port_(port), bus_(sdbus::createSystemBusConnection()) {
        main_ = proxy_of(*bus_, service, main_object);
        main_->registerSignalHandler(InterfaceName(object_manager), SignalName("InterfacesAdded"),
                                     [this](auto&&) { ask(); });
        main_->registerSignalHandler(InterfaceName(object_manager), SignalName("InterfacesRemoved"),
                                     [this](auto&& signal) { on_removed(signal); });
        finish_registration(*main_);
        changes_ = match(*bus_, changes, [this](auto&&) { ask(); });
        owners_ = match(*bus_, owners, [this](auto&& message) { on_owner(message); });
        ask();
    }

    /// Handles what has come. Throws sdbus::Error if the bus is gone.
    void process() {
        while (process_one(*bus_)) {
        }
        for (const std::uint64_t number : answered_) proxies_.erase(number);
        answered_.clear();
    }

    /// An order that cannot be given counts as failed.
    void give(const StickOrder& order) {
        try {
            send(order);
        } catch (const sdbus::Error&) {
            if (order.kind == OrderKind::mount) port_.rules_.on_mount_failed(order.number, false);
            if (order.kind == OrderKind::unmount) port_.rules_.on_unmounted(order.number, false);
        }
    }

  private:
    void send(const StickOrder& order) {
        auto proxy = proxy_of(*bus_, service, order.object);
        const bool is_mount = order.kind == OrderKind::mount;
        auto message = proxy->createMethodCall(InterfaceName(file_system_interface),
                                               MethodName(is_mount ? "Mount" : "Unmount"));
        BusProperties options{{"auth.no_user_interaction", sdbus::Variant(true)}};
        if (is_mount) {
            options.emplace("fstype", sdbus::Variant(order.file_system));
            options.emplace("options", sdbus::Variant(order.options));
        } else {
            options.emplace("force", sdbus::Variant(true));  // nothing was written
        }
        message << options;
        call(
            *proxy, message,
            [this, order](auto&& reply, const auto& error) {
                on_answer(order, reply, error ? &*error : nullptr);
            },
            answer_us);
        proxies_.emplace(order.number, std::move(proxy));
    }

    /// Asks for all volumes. A request meanwhile is repeated once after the answer.
    void ask() {
        is_stale_ = true;
        if (is_asking_) return;
        is_asking_ = true;
        is_stale_ = false;
        const auto message =
            main_->createMethodCall(InterfaceName(object_manager), MethodName("GetManagedObjects"));
        call(*main_, message, [this](auto&& reply, const auto& error) {
            is_asking_ = false;
            on_objects(reply, error ? &*error : nullptr);
            if (is_stale_) ask();
        });
    }

    void on_objects(sdbus::MethodReply& reply, const sdbus::Error* error) {
        BusObjects objects;
        port_.is_watching_ = error == nullptr && is_read(reply, objects);
        if (!port_.is_watching_) return;
        port_.carry_out(port_.rules_.on_volumes(volumes_of(objects)));
    }

    void on_removed(sdbus::Signal& signal) {
        sdbus::ObjectPath object;
        std::vector<std::string> interfaces;
        if (!is_read(signal, object, interfaces)) return;
        for (const std::string& one : interfaces)
            if (one == "org.freedesktop.UDisks2.Block")
                port_.carry_out(port_.rules_.on_vanished(object));
        ask();
    }

    void on_owner(sdbus::Message& message) {
        std::string name;
        std::string before;
        std::string now;
        if (!is_read(message, name, before, now)) return;
        if (!before.empty()) port_.lose_service();
        if (!now.empty()) ask();
    }

    void on_answer(const StickOrder& order, sdbus::MethodReply& reply, const sdbus::Error* error) {
        MountRules& rules = port_.rules_;
        if (order.kind == OrderKind::unmount) {
            rules.on_unmounted(order.number, error == nullptr);
        } else if (std::string root; error == nullptr && is_read(reply, root)) {
            rules.on_mounted(order.number, order.object, root);
        } else {
            const bool is_mounted = error != nullptr && error->getName() == already_mounted;
            rules.on_mount_failed(order.number, is_mounted);
        }
        answered_.push_back(order.number);
        ask();
    }

    UdisksPort& port_;
    std::unique_ptr<sdbus::IConnection> bus_;
    std::unique_ptr<sdbus::IProxy> main_;
    std::map<std::uint64_t, std::unique_ptr<sdbus::IProxy>> proxies_;  // for orders under way
    std::vector<std::uint64_t> answered_;  // their proxies are not needed any more
    sdbus::Slot changes_;
    sdbus::Slot owners_;
    bool is_asking_ = false;
    bool is_stale_ = false;
};

UdisksPort::UdisksPort() = default;
UdisksPort::~UdisksPort() = default;

std::vector<StickEvent> UdisksPort::poll(std::int64_t now_ns) {
    try {
        if (!bus_) connect(now_ns);
        if (bus_) bus_->process();
    } catch (const sdbus::Error&) {
        bus_.reset();
        lose_service();
    }
    return std::exchange(events_, {});
}

void UdisksPort::end_session() {
    events_.clear();
    try {
        carry_out(rules_.on_session_ended());
    } catch (const sdbus::Error&) {
        bus_.reset();
        lose_service();
    }
}

void UdisksPort::connect(std::int64_t now_ns) {
    if (now_ns < next_try_ns_) return;
    next_try_ns_ = now_ns + try_again_ns;
    bus_ = std::make_unique<Bus>(*this);
}

void UdisksPort::carry_out(const StickStep& step) {
    for (const StickOrder& order : step.orders)
        if (bus_) bus_->give(order);
    events_.insert(events_.end(), step.events.begin(), step.events.end());
}

void UdisksPort::lose_service() {
    is_watching_ = false;
    rules_.on_service_lost();
}

}  // namespace

std::optional<std::string> mount_options(std::string_view file_system, FileSystems allowed) {
    const std::string plain = "ro,nosuid,nodev,noexec,nosymfollow";
    if (file_system == "vfat" || file_system == "exfat") return plain;
    if (allowed == FileSystems::usual) return std::nullopt;
    // Read-only alone would still replay the journal, and so write.
    if (file_system == "ext4") return plain + ",noload";
    if (file_system == "ntfs") return plain + ",norecover";
    return std::nullopt;
}

std::unique_ptr<StickPort> open_stick_port(const std::string& watched_folder) {
    if (!watched_folder.empty()) return std::make_unique<FolderPort>(watched_folder);
    return std::make_unique<UdisksPort>();
}

}  // namespace touchline
