#include "haptics/device/board/hapi.h"

#include <bit>
#include <cmath>

namespace touchline {
namespace {

constexpr std::uint8_t reset_code = 0, set_up_code = 1, write_code = 2;
constexpr std::uint8_t both_ports = 0b11, three_ports = 0b111;
constexpr std::size_t flush_bytes = 32;

float float_at(std::span<const std::uint8_t> bytes, std::size_t at) {
    std::uint32_t bits = 0;
    for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | bytes[at + i];
    return std::bit_cast<float>(bits);
}

void put_turns(Command& command, const BoardSetUp& set_up) {
    command.put(set_up.handle ? three_ports : both_ports);
    for (const Turn turn : set_up.turns) command.put(static_cast<std::uint8_t>(turn));
    if (set_up.handle) command.put(static_cast<std::uint8_t>(set_up.handle->turn));
}

void put_write(Command& command, PortTorques torques, std::optional<double> handle_Nm) {
    const bool is_safe = is_finite(torques) && std::isfinite(handle_Nm.value_or(0.0));
    const PortTorques safe = is_safe ? torques : PortTorques{};
    command.put(write_code);
    command.put(board_address);
    command.put(static_cast<float>(safe.x));
    command.put(static_cast<float>(safe.y));
    if (handle_Nm) command.put(static_cast<float>(is_safe ? *handle_Nm : 0.0));
}

}  // namespace

void Command::put(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8) put(static_cast<std::uint8_t>(bits >> shift));
}

Command reset_command() {
    Command command;
    command.put(reset_code);
    command.put(std::uint8_t{0});
    return command;
}

Command set_up_command(const BoardSetUp& set_up) {
    Command command;
    command.put(set_up_code);
    command.put(board_address);
    put_turns(command, set_up);  // motors
    put_turns(command, set_up);  // encoders
    command.put(std::uint8_t{set_up.analog_pin ? std::uint8_t{1} : std::uint8_t{0}});
    if (set_up.analog_pin) command.put(*set_up.analog_pin);
    command.put(std::uint8_t{0});  // no PWM outputs
    for (std::size_t port = 0; port < 2; ++port) {
        command.put(set_up.offsets_deg[port]);
        command.put(set_up.counts_told[port]);
    }
    if (set_up.handle) {
        command.put(set_up.handle->offset_deg);
        command.put(set_up.handle->counts_told);
    }
    return command;
}

Command write_command(PortTorques torques, std::optional<double> handle_Nm) {
    Command command;
    put_write(command, torques, handle_Nm);
    return command;
}

Command flush_command() {
    Command command;
    for (std::size_t i = 0; i < flush_bytes; ++i) command.put(std::uint8_t{0});
    return command;
}

Command completing_command(std::size_t sent, bool has_handle) {
    Command command;
    for (std::size_t i = sent; i > 1 && i < write_size(has_handle); ++i)
        command.put(std::uint8_t{0});
    put_write(command, {}, has_handle ? std::optional(0.0) : std::nullopt);
    return command;
}

Reply decode_reply(std::span<const std::uint8_t> packet, int analog_inputs, bool has_handle) {
    if (packet.empty()) return {ReplyKind::empty, {}};
    if (packet[0] != board_address) return {};
    if (packet.size() == 1) return {ReplyKind::unconfigured, {}};
    const std::size_t first_angle = 1 + 4 * static_cast<std::size_t>(analog_inputs);
    if (packet.size() != first_angle + (has_handle ? 12 : 8)) return {};
    const PortAngles angles{float_at(packet, first_angle), float_at(packet, first_angle + 4)};
    const double handle_deg = has_handle ? double{float_at(packet, first_angle + 8)} : 0.0;
    if (!is_finite(angles) || !std::isfinite(handle_deg)) return {};
    const float analog = analog_inputs > 0 ? float_at(packet, 1) : 0.0F;
    return {ReplyKind::angles, angles, analog, handle_deg};
}

}  // namespace touchline
