// For any packets of a board the driver gives finite angles or none, and never leaves torque on.
#include "haptics/device/board/pantograph_board.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <utility>

namespace touchline {
namespace {

constexpr JointTorques push{0.1, -0.1};
constexpr std::uint8_t end_of_tick = 0xff;

void demand(bool holds) {
    if (!holds) std::abort();
}

/// A board that answers with the test's bytes, and rightly to the first two commands.
class ScriptedLink final : public BoardLink {
  public:
    explicit ScriptedLink(std::span<const std::uint8_t> script) : script_(script) {}

    LinkStatus send(std::span<const std::uint8_t> command) override {
        demand(!command.empty() && command.size() <= 64);
        demand(command[0] <= 2);
        last_size_ = command.size();
        is_pulling_ = command[0] == 2 && std::any_of(command.begin() + 2, command.end(),
                                                     [](std::uint8_t byte) { return byte != 0; });
        if (!is_open_ && command.size() == write_bytes) owes_first_ = true;
        return LinkStatus::done;
    }

    Sent sent() override { return {LinkStatus::done, last_size_}; }

    Received receive() override {
        if (owes_first_) return first_reply();
        if (!is_open_ || script_.empty()) return {};
        const std::uint8_t size = script_.front();
        script_ = script_.subspan(1);
        if (size == end_of_tick) return {};
        Received received;
        received.status = size >= 0xf0 ? LinkStatus::failed : LinkStatus::done;
        received.size = std::min<std::size_t>({size & 0x3fU, script_.size(), 64});
        std::copy_n(script_.begin(), received.size, received.data.begin());
        script_ = script_.subspan(received.size);
        return received;
    }

    LinkStatus set_lines(bool) override { return LinkStatus::done; }

    LinkStatus clear_stall() override { return LinkStatus::done; }

    void cancel_send() override {}

    void rest(double) override {}

    void begin() { is_open_ = true; }

    [[nodiscard]] bool is_over() const { return script_.empty(); }

    /// Returns true unless the last command was a zero write or a set-up, which stops the motors
    /// too.
    [[nodiscard]] bool is_pulling() const { return is_pulling_; }

  private:
    Received first_reply() {
        owes_first_ = false;
        constexpr std::array<std::uint8_t, 9> home{0x05, 0x8f, 0x36, 0x3f, 0x41,
                                                   0xd2, 0xe6, 0x27, 0x43};
        Received received{LinkStatus::done, {}, home.size()};
        std::copy(home.begin(), home.end(), received.data.begin());
        return received;
    }

    std::span<const std::uint8_t> script_;
    bool is_pulling_ = false;
    std::size_t last_size_ = 0;
    bool is_open_ = false;
    bool owes_first_ = false;
};

/// The bytes are packets, each after its length; a tick takes what came since the last one.
void feed_packets(std::span<const std::uint8_t> bytes) {
    const Reply whole = decode_reply(bytes);
    demand(whole.kind != ReplyKind::angles || (bytes.size() == 9 && is_finite(whole.angles)));
    auto made = std::make_unique<ScriptedLink>(bytes);
    ScriptedLink& link = *made;
    PantographBoard driver(std::move(made), default_profile(), {});
    demand(driver.open().has_value());
    link.begin();
    double now_s = 0.0;
    for (int k = 0; k < 10000 && !link.is_over(); ++k) {
        now_s += tick_s;
        const auto angles = driver.read_angles(now_s);
        demand(!angles || is_finite(*angles));
        demand(!angles || driver.report().state == BoardState::ready);
        const bool is_taken = driver.write_torques(angles ? push : JointTorques{});
        // If the board is not known to be in step, the last command told it to stop.
        demand(!link.is_pulling() || (angles && is_taken));
    }
}

}  // namespace
}  // namespace touchline

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    touchline::feed_packets({data, size});
    return 0;
}
