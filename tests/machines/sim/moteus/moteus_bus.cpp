#include "tests/machines/sim/moteus/moteus_bus.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

namespace touchline {
namespace {

constexpr double control_s = 1e-4;
constexpr double bus_way_s = 1.5e-4;  // a command and its answer

int digit_of(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

MoteusBus::MoteusBus(const DriveTruth& truth, const std::array<MoteusTruth, 2>& units,
                     std::shared_ptr<const IntendedPath> path)
    : plant_(truth, std::move(path)),
      units_{MoteusController(units[0]), MoteusController(units[1])} {}

void MoteusBus::drive() {
    for (std::size_t motor = 0; motor < 2; ++motor) {
        const MoteusController& unit = units_[motor];
        plant_.drive(motor, has_power_ ? unit.bridge() : Bridge::off, unit.torque_Nm());
    }
}

void MoteusBus::advance_to(double t_s) {
    while (plant_.now_s() + 1e-9 < t_s) {
        const double span_s = std::min(control_s, t_s - plant_.now_s());
        plant_.advance(span_s);
        if (has_power_) {
            for (std::size_t motor = 0; motor < 2; ++motor)
                units_[motor].advance(span_s, plant_.shaft_turns(motor));
        }
        drive();
    }
}

void MoteusBus::switch_power(bool has_power) {
    if (has_power && !has_power_)
        for (auto& unit : units_) unit.reset();
    has_power_ = has_power;
    drive();
}

void MoteusBus::take(const CanFrame& frame) {
    if (!has_power_) return;
    for (MoteusController& unit : units_) {
        if ((frame.id & 0x7fU) != unit.id()) continue;
        const auto said = unit.take(frame.bytes());
        if ((frame.id & 0x8000U) == 0) continue;
        CanFrame answer;
        answer.id = static_cast<std::uint32_t>(unit.id()) << 8U | (frame.id >> 8U & 0x7fU);
        answer.size = std::min(said.size(), answer.data.size());
        std::copy_n(said.begin(), answer.size, answer.data.begin());
        while (answer.size > 8 && answer.size % 16 != 0) answer.data[answer.size++] = 0x50;
        leaving_.push_back({plant_.now_s() + bus_way_s, answer});
    }
    drive();
}

std::optional<SentFrame> MoteusBus::leave() {
    if (leaving_.empty()) return std::nullopt;
    const SentFrame sent = leaving_.front();
    leaving_.pop_front();
    return sent;
}

void FdcanusbEmulator::take(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
        if (byte != '\n' && byte != '\r') {
            line_ += static_cast<char>(byte);
            continue;
        }
        const std::string line = std::exchange(line_, {});
        if (line.empty()) continue;
        const std::string said = obey(line) + "\r\n";
        said_.push_back({bus_.plant().now_s(), {said.begin(), said.end()}});
    }
}

std::string FdcanusbEmulator::obey(const std::string& line) {
    std::istringstream words(line);
    std::string can, what, id, data;
    words >> can >> what >> id >> data;
    if (can != "can") return "ERR unknown command";
    if (what == "on") {
        if (std::exchange(is_bus_on_, true)) return "ERR already in BusOn";
        return "OK";
    }
    if (what != "send") return "ERR unknown subcommand";
    if (!is_bus_on_) return "ERR not in BusOn state";
    CanFrame frame;
    for (const char c : id) {
        if (digit_of(c) < 0) return "ERR bad id";
        frame.id = frame.id << 4U | static_cast<std::uint32_t>(digit_of(c));
    }
    if (data.empty() || data.size() % 2 != 0 || data.size() > 128) return "ERR data invalid length";
    for (std::size_t i = 0; i < data.size(); i += 2) {
        const int high = digit_of(data[i]), low = digit_of(data[i + 1]);
        if (high < 0 || low < 0) return "ERR invalid data";
        frame.data[frame.size++] = static_cast<std::uint8_t>(16 * high + low);
    }
    bus_.take(frame);
    return "OK";
}

std::optional<SentBytes> FdcanusbEmulator::leave() {
    while (const auto sent = bus_.leave()) {
        std::ostringstream line;
        line << "rcv " << std::hex << sent->frame.id << ' ' << std::setfill('0');
        for (const std::uint8_t byte : sent->frame.bytes())
            line << std::setw(2) << static_cast<int>(byte);
        line << (sent->frame.id > 0x7ff ? " E" : " e") << " B F t1234 f-1\r\n";
        const std::string text = line.str();
        said_.push_back({sent->at_s, {text.begin(), text.end()}});
    }
    if (said_.empty()) return std::nullopt;
    SentBytes first = std::move(said_.front());
    said_.pop_front();
    return first;
}

}  // namespace touchline
