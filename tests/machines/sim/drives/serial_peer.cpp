#include "tests/machines/sim/drives/serial_peer.h"

#include <algorithm>
#include <random>
#include <utility>

namespace touchline {
namespace {

constexpr double line_way_s = 1e-4;  // one way

std::vector<std::uint8_t> with_flipped_bits(std::vector<std::uint8_t> bytes, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3 && !bytes.empty(); ++i)
        bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    return bytes;
}

}  // namespace

void EmulatedSerial::spoil(LineFault fault, double span_s, std::uint64_t seed) {
    fault_ = fault;
    until_s_ = time_.now_s + span_s;
    seed_ = seed;
    if (fault == LineFault::unplugged) is_gone_ = true;
}

// Faults of one write or one piece happen once, whenever it comes.
bool EmulatedSerial::takes_fault(LineFault fault) {
    if (fault_ != fault) return false;
    fault_ = LineFault::none;
    return true;
}

bool EmulatedSerial::write(std::span<const std::uint8_t> bytes) {
    if (planned_ && writes_++ == planned_->at)
        spoil(planned_->fault, planned_->span_s, planned_->seed);
    if (is_gone_ || is_spoilt(LineFault::full)) return false;
    written_.insert(written_.end(), bytes.begin(), bytes.end());
    peer_.advance_to(time_.now_s);
    if (takes_fault(LineFault::lost_write)) return true;
    if (takes_fault(LineFault::cut_write)) {
        peer_.take(bytes.first(bytes.size() / 2));
    } else if (takes_fault(LineFault::garbled_write)) {
        peer_.take(with_flipped_bits({bytes.begin(), bytes.end()}, seed_));
    } else {
        peer_.take(bytes);
    }
    return true;
}

void EmulatedSerial::listen() {
    peer_.advance_to(time_.now_s);
    while (auto sent = peer_.leave()) {
        if (is_spoilt(LineFault::lost_reply)) continue;
        sent->at_s += line_way_s;
        if (time_.now_s <= slow_until_s_) sent->at_s += slow_s_;
        if (is_spoilt(LineFault::late_reply)) sent->at_s = std::max(sent->at_s, until_s_);
        if (takes_fault(LineFault::garbled_reply))
            sent->bytes = with_flipped_bits(std::move(sent->bytes), seed_);
        if (takes_fault(LineFault::cut_reply)) sent->bytes.resize(sent->bytes.size() / 2);
        if (!coming_.empty()) sent->at_s = std::max(sent->at_s, coming_.back().at_s);
        coming_.push_back(std::move(*sent));
    }
}

std::size_t EmulatedSerial::read(std::span<std::uint8_t> room) {
    if (is_gone_) return 0;
    listen();
    std::size_t got = 0;
    while (got < room.size() && !coming_.empty() && coming_.front().at_s <= time_.now_s) {
        auto& bytes = coming_.front().bytes;
        const std::size_t taken = std::min(room.size() - got, bytes.size());
        std::copy_n(bytes.begin(), taken, room.begin() + static_cast<std::ptrdiff_t>(got));
        got += taken;
        bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
        if (bytes.empty()) coming_.pop_front();
    }
    return got;
}

}  // namespace touchline
