#include "app/force/servo/messages.h"

#include "config/types/map_bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>

#include <sys/socket.h>
#include <sys/uio.h>

namespace touchline {
namespace {

/// Room for one descriptor beside a packet.
struct alignas(cmsghdr) ControlRoom {
    std::array<char, CMSG_SPACE(sizeof(int))> bytes{};
};

msghdr header_of(iovec& data, ControlRoom& room) {
    msghdr header{};
    header.msg_iov = &data;
    header.msg_iovlen = 1;
    header.msg_control = room.bytes.data();
    header.msg_controllen = room.bytes.size();
    return header;
}

bool is_known(const Message& message) {
    return message.kind <= MessageKind::done && message.line_bytes <= sizeof message.line;
}

constexpr std::size_t most_map_bytes = std::size_t{64} << 20U;

}  // namespace

Result<SharedRegion> SharedRegion::create() {
    auto memory = memory_of_size(sizeof(ServoRegion));
    if (!memory) return tl::unexpected(memory.error());
    auto mapping = map_shared(*memory);
    if (!mapping) return tl::unexpected(mapping.error());
    new (mapping->start()) ServoRegion;
    return SharedRegion(std::move(*memory), std::move(*mapping));
}

Result<SharedRegion> SharedRegion::open(const Descriptor& descriptor) {
    if (fixed_size(descriptor) != sizeof(ServoRegion)) {
        return failure("the memory shared with the kiosk is not what this servo knows");
    }
    auto mapping = map_shared(descriptor);
    if (!mapping) return tl::unexpected(mapping.error());
    const auto& region = *static_cast<const ServoRegion*>(mapping->start());
    if (region.mark != ServoRegion::known_mark || region.bytes != sizeof(ServoRegion)) {
        return failure("the memory shared with the kiosk is not what this servo knows");
    }
    return SharedRegion(Descriptor{}, std::move(*mapping));
}

ServoChannel& SharedRegion::channel() const {
    return static_cast<ServoRegion*>(mapping_.start())->channel;
}

Message message_of(MessageKind kind, std::string_view line) {
    Message message;
    message.kind = kind;
    message.line_bytes = static_cast<std::uint32_t>(std::min(line.size(), sizeof message.line));
    std::copy_n(line.begin(), message.line_bytes, std::begin(message.line));
    return message;
}

Message message_of(const Calibration& found) {
    Message message;
    message.kind = MessageKind::home;
    message.home = {found.scale,
                    found.stop_off.x,
                    found.stop_off.y,
                    static_cast<std::uint16_t>(number_of(found.encoders)),
                    static_cast<std::uint16_t>(number_of(found.motors)),
                    found.has_all_counts ? 1U : 0U};
    return message;
}

Message message_of(const UsbNode& node) {
    Message message = message_of(MessageKind::board, node.bus_path);
    message.pipes = node.pipes;
    return message;
}

std::optional<Calibration> calibration_of(const Message& message, const Calibration& before) {
    constexpr std::uint32_t most = number_of({true, true, true});
    const HomeFound& home = message.home;
    if (home.encoders > most || home.motors > most || home.has_all_counts > 1) return std::nullopt;
    Calibration found = before;
    found.offset = {};
    found.stop_off = {home.stop_off_1, home.stop_off_2};
    found.scale = home.scale;
    found.encoders = plugs_of(home.encoders);
    found.motors = plugs_of(home.motors);
    found.has_all_counts = home.has_all_counts == 1;
    found.is_measured = true;
    return is_sound(found) ? std::optional(found) : std::nullopt;
}

Message message_of(const HandlePlace& place) {
    Message message = message_of(MessageKind::place);
    message.place = place;
    return message;
}

// A machine that never slept may have slept for some -100 ns, for two clocks are read.
std::optional<HandlePlace> place_of(const Message& message) {
    const HandlePlace& place = message.place;
    if (message.kind != MessageKind::place || !is_finite(place.offset)) return std::nullopt;
    return place;
}

bool is_sound(const Handover& handover) {
    constexpr double most_heat = 4.0;  // no motor told within its limits gets there
    return is_finite(handover.place.offset) && is_finite(handover.last) &&
           handover.motor_heat >= 0.0 && handover.motor_heat <= most_heat &&
           !handover.bus_path.empty();
}

std::string line_of(const Message& message) {
    std::string line(std::begin(message.line), message.line_bytes);
    std::replace_if(
        line.begin(), line.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return line;
}

Result<std::pair<Descriptor, Descriptor>> socket_pair() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return failure(std::string("no socket for the servo: ") + std::strerror(errno));
    }
    return std::pair(Descriptor(ends[0]), Descriptor(ends[1]));
}

std::optional<HeldBoard> held_board_of(Arrival& arrival) {
    if (arrival.message.kind != MessageKind::board || !arrival.attached.is_open())
        return std::nullopt;
    return HeldBoard{std::move(arrival.attached), arrival.message.pipes, line_of(arrival.message)};
}

bool send(const Descriptor& socket, const Message& message, const Descriptor* attached) {
    Message copy = message;
    iovec data{&copy, sizeof copy};
    ControlRoom room;
    msghdr header = header_of(data, room);
    if (attached == nullptr) {
        header.msg_controllen = 0;
    } else {
        cmsghdr* const control = CMSG_FIRSTHDR(&header);
        control->cmsg_level = SOL_SOCKET;
        control->cmsg_type = SCM_RIGHTS;
        control->cmsg_len = CMSG_LEN(sizeof(int));
        const int number = attached->number();
        std::memcpy(CMSG_DATA(control), &number, sizeof number);
    }
    return ::sendmsg(socket.number(), &header, MSG_DONTWAIT | MSG_NOSIGNAL) ==
           static_cast<ssize_t>(sizeof copy);
}

ReceiveStatus receive(const Descriptor& socket, Arrival& arrival) {
    Message message;
    iovec data{&message, sizeof message};
    ControlRoom room;
    msghdr header = header_of(data, room);
    const ssize_t size = ::recvmsg(socket.number(), &header, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
    if (size < 0) {
        const bool is_later = errno == EAGAIN || errno == EINTR;
        return is_later ? ReceiveStatus::none : ReceiveStatus::gone;
    }
    arrival.attached = Descriptor{};
    const cmsghdr* const control = CMSG_FIRSTHDR(&header);
    if (control != nullptr && control->cmsg_type == SCM_RIGHTS &&
        control->cmsg_len == CMSG_LEN(sizeof(int))) {
        int number = -1;
        std::memcpy(&number, CMSG_DATA(control), sizeof number);
        arrival.attached = Descriptor(number);
    }
    const bool is_whole = size == static_cast<ssize_t>(sizeof message) &&
                          (header.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) == 0;
    if (!is_whole || !is_known(message)) return ReceiveStatus::gone;
    arrival.message = message;
    return ReceiveStatus::received;
}

Result<BuiltScene> scene_of(const Arrival& arrival) {
    try {
        const auto memory = map_sealed(arrival.attached, most_map_bytes);
        if (!memory) return tl::unexpected(memory.error());
        const auto map = map_of(memory->bytes());
        if (!map) return tl::unexpected(map.error());
        auto scene = build_scene(*map, arrival.message.scene);
        if (!scene) return tl::unexpected(scene.error());
        return BuiltScene{
            std::make_shared<const Scene>(std::move(*scene)),
            {map->version, line_of(arrival.message), arrival.message.scene.detail, hash_of(*map)}};
    } catch (const std::exception& problem) {
        return failure(std::string("the scene cannot be built: ") + problem.what());
    }
}

}  // namespace touchline
