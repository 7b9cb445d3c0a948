#include "tests/machines/sim/board/firmware.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace touchline {
namespace {

constexpr double pass_span_s = 50e-6;      // at most one command each
constexpr double encoder_set_up_s = 2e-3;  // each
constexpr double longest_wait_s = 1.0;     // for the rest of a float block
constexpr std::uint8_t nothing_there = 0xff;
constexpr std::uint8_t forbidden_pin = 59;

float float_of(const std::uint8_t* bytes) {
    std::uint32_t bits = 0;
    for (int i = 4; i-- > 0;) bits = bits << 8 | bytes[i];
    return std::bit_cast<float>(bits);
}

void put(PacketBytes& packet, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8)
        packet.push_back(static_cast<std::uint8_t>(bits >> shift));
}

}  // namespace

// The M0's quadrature code sees half of the edges.
double Firmware::resolved(float counts_told) const {
    const bool counts_half = type_ == BoardType::m0 && !variant_.has_all_counts;
    return static_cast<double>(counts_told) / (counts_half ? 2.0 : 1.0);
}

void Firmware::take(std::span<const std::uint8_t> bytes, double at_s) {
    for (const std::uint8_t byte : bytes) arrived_.push_back({at_s, byte});
}

double Firmware::next_pass_s() const {
    if (block_) return std::max(busy_until_s_, std::min(block_complete_s(), block_deadline_s()));
    return arrived_.empty() ? never_s : std::max(busy_until_s_, arrived_.front().at_s);
}

double Firmware::block_complete_s() const {
    return arrived_.size() < block_->bytes ? never_s : arrived_[block_->bytes - 1].at_s;
}

double Firmware::block_deadline_s() const {
    if (type_ == BoardType::m0) return block_->from_s + longest_wait_s;
    const std::size_t there = std::min(arrived_.size(), block_->bytes);
    double last_s = block_->from_s;
    for (std::size_t i = 0; i < there && arrived_[i].at_s <= last_s + longest_wait_s; ++i)
        last_s = std::max(last_s, arrived_[i].at_s);
    return last_s + longest_wait_s;
}

std::optional<PacketBytes> Firmware::pass(double now_s, const PortCounts& counts) {
    busy_until_s_ = now_s + pass_span_s;
    if (block_) return finish(now_s, counts);
    switch (read(now_s)) {
        case 0:
            (void)read(now_s);  // an address, which it ignores
            address_ = 0;
            return std::nullopt;
        case 1:
            begin_set_up(now_s);
            return std::nullopt;
        case 2:
            return begin_write(now_s);
        default:
            return std::nullopt;
    }
}

std::uint8_t Firmware::read(double now_s) {
    if (arrived_.empty() || arrived_.front().at_s > now_s) return nothing_there;
    const std::uint8_t byte = arrived_.front().byte;
    arrived_.pop_front();
    return byte;
}

// Turns are stored by running index, not by port.
std::uint8_t Firmware::read_mask(double now_s, std::array<std::uint8_t, port_count>& turns) {
    const auto mask = static_cast<std::uint8_t>(read(now_s) & (type_ == BoardType::m0 ? 0x3 : 0xf));
    std::size_t index = 0;
    for (unsigned port = 0; port < 4; ++port) {
        if ((mask >> port & 1) == 0) continue;
        const std::uint8_t turn = read(now_s);
        if (index < turns.size()) turns[index++] = turn;
    }
    return mask;
}

void Firmware::begin_set_up(double now_s) {
    address_to_set_up_ = read(now_s);
    is_broken_ = is_broken_ || address_to_set_up_ == 0;
    motors_ = read_mask(now_s, motor_turns_);
    encoders_ = read_mask(now_s, encoder_turns_);
    analog_inputs_ = read(now_s);
    for (std::size_t i = 0; i < analog_inputs_; ++i)
        is_broken_ = is_broken_ || read(now_s) == forbidden_pin;
    analog_inputs_ = std::min<std::size_t>(analog_inputs_, 5);
    pwm_outputs_ = read(now_s);
    for (std::size_t i = 0; i < pwm_outputs_; ++i) (void)read(now_s);
    block_ = Block{1, 8 * static_cast<std::size_t>(std::popcount(encoders_)), now_s};
}

std::optional<PacketBytes> Firmware::begin_write(double now_s) {
    const std::uint8_t address = read(now_s);
    is_broken_ = is_broken_ || address == 0;
    if (address == 0) return std::nullopt;
    if (address != address_) return PacketBytes{address};
    for (std::size_t i = 0; i < pwm_outputs_; ++i) (void)read(now_s);
    block_ = Block{2, 4 * static_cast<std::size_t>(std::popcount(motors_)), now_s};
    if (next_pass_s() <= busy_until_s_)
        busy_until_s_ = now_s;  // if all bytes are there: in the
                                // same pass
    return std::nullopt;
}

std::optional<PacketBytes> Firmware::finish(double now_s, const PortCounts& counts) {
    const std::vector<float> values = floats_of_block(now_s);
    const std::uint8_t command = block_->command;
    block_.reset();
    if (command == 1) {
        set_up(values, counts);
        busy_until_s_ = now_s + encoder_set_up_s * std::popcount(encoders_);
        return std::nullopt;
    }
    set_duty(values);
    return reply(counts);
}

// Bytes that have not come are whatever the memory held.
std::vector<float> Firmware::floats_of_block(double now_s) {
    std::vector<std::uint8_t> bytes(block_->bytes);
    for (std::uint8_t& byte : bytes) {
        const bool is_there = !arrived_.empty() && arrived_.front().at_s <= now_s;
        byte = is_there ? read(now_s) : static_cast<std::uint8_t>(garbage_());
    }
    std::vector<float> values;
    for (std::size_t at = 0; at < bytes.size(); at += 4) values.push_back(float_of(&bytes[at]));
    return values;
}

void Firmware::set_up(const std::vector<float>& values, const PortCounts& counts) {
    address_ = address_to_set_up_;
    ++set_ups_;
    duty_ = {};
    for (std::size_t i = 0; i < encoder_.size() && 2 * i + 1 < values.size(); ++i) {
        Encoder& encoder = encoder_[i];
        encoder = {values[2 * i], values[2 * i + 1], encoder_turns_[i], counts[i], 0};
        const double wanted =
            static_cast<double>(encoder.offset_deg) * resolved(encoder.counts_told) / 360.0;
        if (std::abs(wanted) < 1e15) encoder.counter = static_cast<std::int64_t>(wanted);
    }
}

// NaN passes every comparison of the firmware's clamp and comes out as the limit.
void Firmware::set_duty(const std::vector<float>& torques) {
    const double steps = type_ == BoardType::m0 ? 1023.0 : 255.0;
    const double limit_Nm = variant_.torque_limit_Nm;
    double largest_Nm = limit_Nm;
    for (const float torque : torques)
        largest_Nm = std::max(largest_Nm, std::abs(static_cast<double>(torque)));
    const double share = variant_.scales_together ? limit_Nm / largest_Nm : 1.0;
    for (std::size_t i = 0; i < duty_.size() && i < torques.size(); ++i) {
        const double torque = share * static_cast<double>(torques[i]);
        const double size = std::isnan(torque) ? limit_Nm : std::min(std::abs(torque), limit_Nm);
        duty_[i] = std::copysign(std::trunc(steps * size / limit_Nm) / steps, torque);
    }
}

PacketBytes Firmware::reply(const PortCounts& counts) const {
    PacketBytes packet{address_};
    for (std::size_t i = 0; i < analog_inputs_; ++i) put(packet, 0.0F);
    const auto encoders =
        std::min<std::size_t>(encoder_.size(), static_cast<std::size_t>(std::popcount(encoders_)));
    for (std::size_t i = 0; i < encoders; ++i) {
        const Encoder& encoder = encoder_[i];
        const std::int64_t moved = counts[i] - encoder.start_count;
        const std::int64_t counter = encoder.counter + (encoder.turn == 0 ? moved : -moved);
        const double per_turn = resolved(encoder.counts_told);
        put(packet, static_cast<float>(360.0 * static_cast<double>(counter) / per_turn));
    }
    return packet;
}

}  // namespace touchline
