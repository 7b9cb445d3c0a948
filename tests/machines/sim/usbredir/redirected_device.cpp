#include "tests/machines/sim/usbredir/redirected_device.h"

#include "config/types/steady_clock.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int poll_ms = 1;

RedirectedDevice& self(void* device) {
    return *static_cast<RedirectedDevice*>(device);
}

std::span<const std::uint8_t> span_of(const std::uint8_t* data, int size) {
    return {data, data == nullptr ? 0 : static_cast<std::size_t>(size)};
}

/// Translates the descriptors for usbredir.
usb_redir_interface_info_header interfaces_of(const PacketBytes& configuration) {
    usb_redir_interface_info_header info{};
    for (std::size_t at = 0; at < configuration.size(); at += configuration[at]) {
        if (configuration[at + 1] != 4) continue;
        const std::size_t index = info.interface_count++;
        info.interface[index] = configuration[at + 2];
        info.interface_class[index] = configuration[at + 5];
        info.interface_subclass[index] = configuration[at + 6];
        info.interface_protocol[index] = configuration[at + 7];
    }
    return info;
}

usb_redir_ep_info_header endpoints_of(const PacketBytes& configuration) {
    usb_redir_ep_info_header info{};
    std::memset(info.type, usb_redir_type_invalid, sizeof info.type);
    info.type[0] = info.type[16] = usb_redir_type_control;
    std::uint8_t interface = 0;
    for (std::size_t at = 0; at < configuration.size(); at += configuration[at]) {
        if (configuration[at + 1] == 4) interface = configuration[at + 2];
        if (configuration[at + 1] != 5) continue;
        const std::uint8_t address = configuration[at + 2];
        const std::size_t index = (address & 0x80) / 8U + (address & 0x0fU);
        info.type[index] = configuration[at + 3];
        info.interface[index] = interface;
        info.interval[index] = configuration[at + 6];
        info.max_packet_size[index] = configuration[at + 4];
    }
    return info;
}

}  // namespace

int listen_at(const char* path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path, sizeof address.sun_path - 1);
    const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
    unlink(path);
    const bool is_listening =
        bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
        listen(listener, 1) == 0;
    return is_listening ? listener : -1;
}

RedirectedDevice::RedirectedDevice(RedirectedFunction& function, int socket)
    : function_(function), socket_(socket), parser_(usbredirparser_create()) {
    set_callbacks();
    std::uint32_t capabilities[USB_REDIR_CAPS_SIZE] = {};
    for (const int capability :
         {usb_redir_cap_connect_device_version, usb_redir_cap_ep_info_max_packet_size,
          usb_redir_cap_64bits_ids, usb_redir_cap_32bits_bulk_length})
        usbredirparser_caps_set_cap(capabilities, capability);
    char name[] = "touchline";
    usbredirparser_init(parser_, name, capabilities, USB_REDIR_CAPS_SIZE,
                        usbredirparser_fl_usb_host);
    flush();
}

RedirectedDevice::~RedirectedDevice() {
    usbredirparser_destroy(parser_);
    close(socket_);
}

void RedirectedDevice::serve() {
    while (function_.is_plugged()) {
        pollfd wanted{socket_, POLLIN, 0};
        const int ready = poll(&wanted, 1, poll_ms);
        function_.advance_to(1e-9 * static_cast<double>(steady_now_ns()));
        if (ready > 0 && usbredirparser_do_read(parser_) == usbredirparser_read_io_error) return;
        deliver();
        flush();
    }
}

void RedirectedDevice::set_callbacks() {
    parser_->priv = this;
    parser_->log_func = [](void*, int level, const char* line) {
        if (level <= usbredirparser_warning) std::fprintf(stderr, "usbredir: %s\n", line);
    };
    parser_->read_func = [](void* device, std::uint8_t* bytes, int size) {
        const ssize_t got =
            recv(self(device).socket_, bytes, static_cast<std::size_t>(size), MSG_DONTWAIT);
        if (got > 0) return static_cast<int>(got);
        return got < 0 && errno == EAGAIN ? 0 : -1;
    };
    parser_->write_func = [](void* device, std::uint8_t* bytes, int size) {
        return static_cast<int>(
            send(self(device).socket_, bytes, static_cast<std::size_t>(size), MSG_NOSIGNAL));
    };
    parser_->hello_func = [](void* device, usb_redir_hello_header*) { self(device).connect(); };
    parser_->reset_func = [](void*) {};
    parser_->set_configuration_func = [](void* device, std::uint64_t id,
                                         usb_redir_set_configuration_header* header) {
        usb_redir_configuration_status_header status{usb_redir_success, header->configuration};
        usbredirparser_send_configuration_status(self(device).parser_, id, &status);
    };
    parser_->get_configuration_func = [](void* device, std::uint64_t id) {
        usb_redir_configuration_status_header status{usb_redir_success, 1};
        usbredirparser_send_configuration_status(self(device).parser_, id, &status);
    };
    parser_->set_alt_setting_func = [](void* device, std::uint64_t id,
                                       usb_redir_set_alt_setting_header* header) {
        usb_redir_alt_setting_status_header status{usb_redir_success, header->interface,
                                                   header->alt};
        usbredirparser_send_alt_setting_status(self(device).parser_, id, &status);
    };
    parser_->get_alt_setting_func = [](void* device, std::uint64_t id,
                                       usb_redir_get_alt_setting_header* header) {
        usb_redir_alt_setting_status_header status{usb_redir_success, header->interface, 0};
        usbredirparser_send_alt_setting_status(self(device).parser_, id, &status);
    };
    // The kernel listens for changes of the serial lines; the board never reports any.
    parser_->start_interrupt_receiving_func =
        [](void* device, std::uint64_t id, usb_redir_start_interrupt_receiving_header* header) {
            usb_redir_interrupt_receiving_status_header status{usb_redir_success, header->endpoint};
            usbredirparser_send_interrupt_receiving_status(self(device).parser_, id, &status);
        };
    parser_->stop_interrupt_receiving_func = [](void* device, std::uint64_t id,
                                                usb_redir_stop_interrupt_receiving_header* header) {
        usb_redir_interrupt_receiving_status_header status{usb_redir_success, header->endpoint};
        usbredirparser_send_interrupt_receiving_status(self(device).parser_, id, &status);
    };
    parser_->control_packet_func = [](void* device, std::uint64_t id,
                                      usb_redir_control_packet_header* header, std::uint8_t* data,
                                      int size) {
        self(device).control(id, *header, span_of(data, size));
        usbredirparser_free_packet_data(self(device).parser_, data);
    };
    parser_->bulk_packet_func = [](void* device, std::uint64_t id,
                                   usb_redir_bulk_packet_header* header, std::uint8_t* data,
                                   int size) {
        self(device).bulk(id, *header, span_of(data, size));
        usbredirparser_free_packet_data(self(device).parser_, data);
    };
    parser_->cancel_data_packet_func = [](void* device, std::uint64_t id) {
        self(device).cancel(id);
    };
}

void RedirectedDevice::connect() {
    usb_redir_interface_info_header interfaces = interfaces_of(function_.configuration());
    usbredirparser_send_interface_info(parser_, &interfaces);
    usb_redir_ep_info_header endpoints = endpoints_of(function_.configuration());
    usbredirparser_send_ep_info(parser_, &endpoints);
    const PacketBytes device = function_.device();
    const auto word = [&](std::size_t at) {
        return static_cast<std::uint16_t>(device[at] | device[at + 1] << 8);
    };
    usb_redir_device_connect_header header{function_.speed(), device[4], device[5], device[6],
                                           word(8),           word(10),  word(12)};
    usbredirparser_send_device_connect(parser_, &header);
}

void RedirectedDevice::control(std::uint64_t id, const usb_redir_control_packet_header& header,
                               std::span<const std::uint8_t> data) {
    const UsbRequest request{header.requesttype, header.request, header.value, header.index,
                             header.length};
    auto said = function_.control(request, data);
    usb_redir_control_packet_header reply = header;
    reply.status = said ? usb_redir_success : usb_redir_stall;
    const bool is_in = (header.requesttype & 0x80) != 0;
    if (said && is_in) {
        reply.length = static_cast<std::uint16_t>(said->size());
        usbredirparser_send_control_packet(parser_, id, &reply, said->data(),
                                           static_cast<int>(said->size()));
        return;
    }
    if (!said) reply.length = 0;
    usbredirparser_send_control_packet(parser_, id, &reply, nullptr, 0);
}

void RedirectedDevice::bulk(std::uint64_t id, const usb_redir_bulk_packet_header& header,
                            std::span<const std::uint8_t> data) {
    if ((header.endpoint & 0x80) != 0) {
        listening_.push_back({id, header});
        function_.listens(true);
        return;
    }
    function_.sends(data);
    if (!function_.is_plugged()) return;
    usb_redir_bulk_packet_header reply = header;
    reply.status = usb_redir_success;
    usbredirparser_send_bulk_packet(parser_, id, &reply, nullptr, 0);
}

void RedirectedDevice::cancel(std::uint64_t id) {
    const auto found = std::find_if(listening_.begin(), listening_.end(),
                                    [&](const Listening& one) { return one.id == id; });
    if (found == listening_.end()) return;
    usb_redir_bulk_packet_header reply = found->header;
    reply.status = usb_redir_cancelled;
    reply.length = reply.length_high = 0;
    listening_.erase(found);
    if (listening_.empty()) function_.listens(false);
    usbredirparser_send_bulk_packet(parser_, id, &reply, nullptr, 0);
}

void RedirectedDevice::deliver() {
    while (!listening_.empty()) {
        usb_redir_bulk_packet_header reply = listening_.front().header;
        const std::size_t most_bytes = reply.length | std::size_t{reply.length_high} << 16U;
        auto packet = function_.take(most_bytes);
        if (!packet) return;
        reply.status = usb_redir_success;
        reply.length = static_cast<std::uint16_t>(packet->size());
        reply.length_high = static_cast<std::uint16_t>(packet->size() >> 16U);
        usbredirparser_send_bulk_packet(parser_, listening_.front().id, &reply, packet->data(),
                                        static_cast<int>(packet->size()));
        listening_.pop_front();
    }
}

void RedirectedDevice::flush() {
    while (usbredirparser_has_data_to_write(parser_) && usbredirparser_do_write(parser_) == 0) {
    }
}

}  // namespace touchline
