#include "tests/sim/usbredir/redirected_board.h"

#include "config/types/steady_clock.h"
#include "tests/sim/board/usb_function.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int poll_ms = 1;

RedirectedBoard& self(void* board) {
    return *static_cast<RedirectedBoard*>(board);
}

std::span<const std::uint8_t> span_of(const std::uint8_t* data, int size) {
    return {data, data == nullptr ? 0 : static_cast<std::size_t>(size)};
}

/// What the descriptors say, in the words of usbredir.
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

RedirectedBoard::RedirectedBoard(BoardEmulator& board, int socket, int unplug_after_writes)
    : board_(board),
      socket_(socket),
      writes_until_unplugged_(unplug_after_writes),
      parser_(usbredirparser_create()) {
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

RedirectedBoard::~RedirectedBoard() {
    usbredirparser_destroy(parser_);
    close(socket_);
}

void RedirectedBoard::serve() {
    const double start_s = 1e-9 * static_cast<double>(steady_now_ns()) - board_.now_s();
    while (board_.is_plugged()) {
        pollfd wanted{socket_, POLLIN, 0};
        const int ready = poll(&wanted, 1, poll_ms);
        board_.advance_to(1e-9 * static_cast<double>(steady_now_ns()) - start_s);
        if (ready > 0 && usbredirparser_do_read(parser_) == usbredirparser_read_io_error) return;
        deliver();
        flush();
    }
}

void RedirectedBoard::set_callbacks() {
    parser_->priv = this;
    parser_->log_func = [](void*, int level, const char* line) {
        if (level <= usbredirparser_warning) std::fprintf(stderr, "usbredir: %s\n", line);
    };
    parser_->read_func = [](void* board, std::uint8_t* bytes, int size) {
        const ssize_t got =
            recv(self(board).socket_, bytes, static_cast<std::size_t>(size), MSG_DONTWAIT);
        if (got > 0) return static_cast<int>(got);
        return got < 0 && errno == EAGAIN ? 0 : -1;
    };
    parser_->write_func = [](void* board, std::uint8_t* bytes, int size) {
        return static_cast<int>(
            send(self(board).socket_, bytes, static_cast<std::size_t>(size), MSG_NOSIGNAL));
    };
    parser_->hello_func = [](void* board, usb_redir_hello_header*) { self(board).connect(); };
    parser_->reset_func = [](void*) {};
    parser_->set_configuration_func = [](void* board, std::uint64_t id,
                                         usb_redir_set_configuration_header* header) {
        usb_redir_configuration_status_header status{usb_redir_success, header->configuration};
        usbredirparser_send_configuration_status(self(board).parser_, id, &status);
    };
    parser_->get_configuration_func = [](void* board, std::uint64_t id) {
        usb_redir_configuration_status_header status{usb_redir_success, 1};
        usbredirparser_send_configuration_status(self(board).parser_, id, &status);
    };
    parser_->set_alt_setting_func = [](void* board, std::uint64_t id,
                                       usb_redir_set_alt_setting_header* header) {
        usb_redir_alt_setting_status_header status{usb_redir_success, header->interface,
                                                   header->alt};
        usbredirparser_send_alt_setting_status(self(board).parser_, id, &status);
    };
    parser_->get_alt_setting_func = [](void* board, std::uint64_t id,
                                       usb_redir_get_alt_setting_header* header) {
        usb_redir_alt_setting_status_header status{usb_redir_success, header->interface, 0};
        usbredirparser_send_alt_setting_status(self(board).parser_, id, &status);
    };
    // The kernel listens for changes of the serial lines; the board never tells of one.
    parser_->start_interrupt_receiving_func =
        [](void* board, std::uint64_t id, usb_redir_start_interrupt_receiving_header* header) {
            usb_redir_interrupt_receiving_status_header status{usb_redir_success, header->endpoint};
            usbredirparser_send_interrupt_receiving_status(self(board).parser_, id, &status);
        };
    parser_->stop_interrupt_receiving_func = [](void* board, std::uint64_t id,
                                                usb_redir_stop_interrupt_receiving_header* header) {
        usb_redir_interrupt_receiving_status_header status{usb_redir_success, header->endpoint};
        usbredirparser_send_interrupt_receiving_status(self(board).parser_, id, &status);
    };
    parser_->control_packet_func = [](void* board, std::uint64_t id,
                                      usb_redir_control_packet_header* header, std::uint8_t* data,
                                      int size) {
        self(board).control(id, *header, span_of(data, size));
        usbredirparser_free_packet_data(self(board).parser_, data);
    };
    parser_->bulk_packet_func = [](void* board, std::uint64_t id,
                                   usb_redir_bulk_packet_header* header, std::uint8_t* data,
                                   int size) {
        self(board).bulk(id, *header, span_of(data, size));
        usbredirparser_free_packet_data(self(board).parser_, data);
    };
    parser_->cancel_data_packet_func = [](void* board, std::uint64_t id) {
        self(board).cancel(id);
    };
}

void RedirectedBoard::connect() {
    usb_redir_interface_info_header interfaces{};
    interfaces.interface_count = 2;
    interfaces.interface[1] = 1;
    interfaces.interface_class[0] = interfaces.interface_subclass[0] = 2;
    interfaces.interface_class[1] = 0x0a;
    usbredirparser_send_interface_info(parser_, &interfaces);
    usb_redir_ep_info_header endpoints = endpoints_of(configuration_descriptor(board_));
    usbredirparser_send_ep_info(parser_, &endpoints);
    const PacketBytes device = device_descriptor(board_);
    const auto word = [&](std::size_t at) {
        return static_cast<std::uint16_t>(device[at] | device[at + 1] << 8);
    };
    usb_redir_device_connect_header header{
        usb_redir_speed_full, device[4], device[5], device[6], word(8), word(10), word(12)};
    usbredirparser_send_device_connect(parser_, &header);
}

void RedirectedBoard::control(std::uint64_t id, const usb_redir_control_packet_header& header,
                              std::span<const std::uint8_t> data) {
    const UsbRequest request{header.requesttype, header.request, header.value, header.index,
                             header.length};
    auto said = answer(board_, request, data);
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

void RedirectedBoard::bulk(std::uint64_t id, const usb_redir_bulk_packet_header& header,
                           std::span<const std::uint8_t> data) {
    if (header.endpoint == board_in_endpoint) {
        listening_.push_back({id, header});
        board_.host_listens(true);
        return;
    }
    if (writes_until_unplugged_ > 0 && --writes_until_unplugged_ == 0) return board_.unplug();
    board_.host_sends(data);
    usb_redir_bulk_packet_header reply = header;
    reply.status = usb_redir_success;
    usbredirparser_send_bulk_packet(parser_, id, &reply, nullptr, 0);
}

void RedirectedBoard::cancel(std::uint64_t id) {
    const auto found = std::find_if(listening_.begin(), listening_.end(),
                                    [&](const Listening& one) { return one.id == id; });
    if (found == listening_.end()) return;
    usb_redir_bulk_packet_header reply = found->header;
    reply.status = usb_redir_cancelled;
    reply.length = reply.length_high = 0;
    listening_.erase(found);
    if (listening_.empty()) board_.host_listens(false);
    usbredirparser_send_bulk_packet(parser_, id, &reply, nullptr, 0);
}

void RedirectedBoard::deliver() {
    while (!listening_.empty()) {
        auto packet = board_.take_packet();
        if (!packet) return;
        usb_redir_bulk_packet_header reply = listening_.front().header;
        reply.status = usb_redir_success;
        reply.length = static_cast<std::uint16_t>(packet->bytes.size());
        reply.length_high = 0;
        usbredirparser_send_bulk_packet(parser_, listening_.front().id, &reply,
                                        packet->bytes.data(),
                                        static_cast<int>(packet->bytes.size()));
        listening_.pop_front();
    }
}

void RedirectedBoard::flush() {
    while (usbredirparser_has_data_to_write(parser_) && usbredirparser_do_write(parser_) == 0) {
    }
}

}  // namespace touchline
