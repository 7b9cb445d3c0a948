// touchline-servo with the board of soak_board.h, a plant and a hand that goes round the drawing
// area.
//
//   soak_servo SOCKET BOARD
#include "app/force/servo/servo_program.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/app/force/servo/mapped_file.h"
#include "tests/machines/system/soak/soak_board.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include <unistd.h>

namespace touchline {
namespace {

/// Goes all over the drawing area at the speed of a hand that looks for something; where it rests,
/// it stays. Threads: the servo's.
class RoundTrip final : public IntendedPath {
  public:
    void go_on(double time_s) { time_s_ += time_s; }

    [[nodiscard]] Intention at(double /*t_s*/) const override {
        constexpr double width_m = 0.050, height_m = 0.035;
        constexpr double across_per_s = 2.0 * std::numbers::pi / 11.0;
        constexpr double up_per_s = 2.0 * std::numbers::pi / 7.3;
        return {
            {width_m * std::sin(across_per_s * time_s_), height_m * std::sin(up_per_s * time_s_)},
            {}};
    }

  private:
    double time_s_ = 0.0;
};

class SoakDevice final : public JointDevice {
  public:
    explicit SoakDevice(SoakBoard& soak)
        : JointDevice(default_profile().geometry),
          soak_(soak),
          pantograph_(default_profile(), {}, hand_) {}

    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override {
        constexpr double tick_s = 1e-3;
        if (soak_.is_unplugged != 0) return std::nullopt;
        ++soak_.board.reads;
        if (soak_.board.is_pressed != 0) hand_->go_on(tick_s);
        return pantograph_.read_angles(now_s);
    }

    /// A board without its plug has no power.
    [[nodiscard]] bool write_torques(JointTorques torques) override {
        const bool is_there = soak_.is_unplugged == 0;
        soak_.board.put(is_there ? torques : JointTorques{});
        return is_there && pantograph_.write_torques(torques);
    }

  private:
    SoakBoard& soak_;
    std::shared_ptr<RoundTrip> hand_ = std::make_shared<RoundTrip>();
    SimulatedPantograph pantograph_;
};

void write_zero(void* soak) noexcept {
    auto& board = static_cast<SoakBoard*>(soak)->board;
    board.put({});
    ++board.zeroed_by_handler;
}

Result<OpenedDevice> open_device(SoakBoard& soak) {
    if (soak.is_unplugged != 0) return failure("the board is not plugged in");
    if (!soak.board.is_free()) return failure("the board is busy");
    soak.board.owner = getpid();
    soak.board.reads = 0;
    soak.board.put({});
    ++soak.board.opened;
    OpenedDevice opened;
    opened.device = std::make_unique<SoakDevice>(soak);
    opened.profile = default_profile();
    opened.has_motors = false;  // the load of the machine decides nothing
    opened.zero = {write_zero, &soak};
    return opened;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    auto& soak = touchline::mapped<touchline::SoakBoard>(argv[2]);
    return touchline::run_servo_program(std::stoi(argv[1]), [&soak](const touchline::Opening&) {
        return touchline::open_device(soak);
    });
}
