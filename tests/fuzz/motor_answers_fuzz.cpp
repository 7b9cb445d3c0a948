// Whatever comes over the line from motors' controllers, angles are finite and only given by a
// driver that is at work, and every line about trouble is one. The first byte chooses the make; a
// byte that no line has ends what one tick hears.
#include "haptics/device/drives/motor_pantograph.h"
#include "haptics/device/moteus/fdcanusb_link.h"
#include "haptics/device/moteus/moteus_pair.h"
#include "haptics/device/odrive/odrive_pair.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>

namespace touchline {
namespace {

constexpr std::uint8_t end_of_tick = 0xff;
constexpr int most_ticks = 400;

void demand(bool holds) {
    if (!holds) std::abort();
}

/// Gives the bytes tick by tick. A wait is a tick too.
class FuzzedLink final : public ByteLink {
  public:
    explicit FuzzedLink(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    bool write(std::span<const std::uint8_t> bytes) override {
        demand(bytes.size() <= 1024);
        return true;
    }

    std::size_t read(std::span<std::uint8_t> room) override {
        const auto end = std::find(bytes_.begin(), bytes_.end(), end_of_tick);
        const std::size_t size =
            std::min(room.size(), static_cast<std::size_t>(end - bytes_.begin()));
        std::copy_n(bytes_.begin(), size, room.begin());
        bytes_ = bytes_.subspan(size);
        if (size == 0 && !bytes_.empty()) bytes_ = bytes_.subspan(1);
        return size;
    }

    [[nodiscard]] bool is_gone() const override { return bytes_.empty(); }

    void rest(double) override {}

  private:
    std::span<const std::uint8_t> bytes_;
};

std::unique_ptr<MotorPair> pair_over(std::unique_ptr<ByteLink> line, bool is_odrive) {
    if (is_odrive) return std::make_unique<OdrivePair>(std::move(line), 0.1);
    return std::make_unique<MoteusPair>(std::make_unique<FdcanusbLink>(std::move(line)),
                                        MoteusIds{1, 2});
}

bool is_one_line(const std::string& text) {
    return text.size() < 500 && std::ranges::none_of(text, [](char c) {
               return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
           });
}

void feed_motors(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return;
    const bool is_odrive = bytes.front() % 2 == 1;
    MotorPantograph driver(pair_over(std::make_unique<FuzzedLink>(bytes.subspan(1)), is_odrive),
                           open_five_bar(), {});
    const auto opened = driver.open();
    if (!opened) demand(!opened.error().line.empty() && is_one_line(opened.error().line));
    for (int k = 0; k < most_ticks && driver.report().state != DriveState::lost; ++k) {
        const auto angles = driver.read_angles(k * 1e-3);
        demand(!angles || (is_finite(*angles) && driver.report().state == DriveState::ready));
        (void)driver.write_torques(angles ? JointTorques{0.02, -0.01} : JointTorques{});
    }
    demand(is_one_line(driver.words()));
}

}  // namespace
}  // namespace touchline

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    touchline::feed_motors({data, size});
    return 0;
}
