#include "tests/machines/sim/kiosk/servo_life.h"

#include "app/force/servo/messages.h"

#include <limits>
#include <utility>

namespace touchline {
namespace {

constexpr double period_s = 1e-3;
constexpr std::int64_t period_ns = 1'000'000;
constexpr double longest_absence_s = 2.0;  // of the device, as in the program

}  // namespace

/// The board, except for one angle that is NaN and for what a test breaks.
class ServoLife::Device final : public JointDevice {
  public:
    explicit Device(ServoLife& life) : JointDevice(life.board_->profile().geometry), life_(life) {}

    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override {
        auto angles = life_.board_->read_angles(now_s);
        if (angles && std::exchange(life_.is_next_angle_broken_, false))
            angles->y = std::numeric_limits<double>::quiet_NaN();
        return angles;
    }

    [[nodiscard]] Freshness freshness() const override { return life_.board_->freshness(); }

    [[nodiscard]] bool write_torques(JointTorques torques) override {
        if (life_.place_.sabotage == Sabotage::doubled_torque) torques = 2.0 * torques;
        if (life_.place_.sabotage == Sabotage::held_torque && torques == JointTorques{})
            torques = held_;
        held_ = torques;
        return life_.board_->write_torques(torques);
    }

  private:
    ServoLife& life_;
    JointTorques held_;
};

Opening ServoLife::opening() {
    return {[this](const std::string& words) {
                tell(MessageKind::say, words);
                place_.hand.hear(words, place_.time.now_s);
                place_.board.grip(normal_hand);
                is_held_ = true;
            },
            [this] {
                follow_hand();
                region_.channel().servo_beats.fetch_add(1);
                return region_.channel().is_stop_wanted == 0;
            },
            [this](const Calibration& found) { (void)send(socket_, message_of(found)); },
            [this](bool is_on) { region_.channel().is_force_on = is_on ? 1 : 0; },
            {},
            {}};
}

void ServoLife::follow_hand() {
    const bool is_held = place_.hand.holds(place_.time.now_s);
    if (std::exchange(is_held_, is_held) != is_held)
        place_.board.grip(is_held ? normal_hand : no_hand);
}

int ServoLife::run(const Calibration& stored) {
    const DeviceProfile& profile = place_.board.truth().profile;
    auto link = std::make_unique<EmulatedLink>(place_.board, place_.time);
    link_ = link.get();
    link_->keep_no_commands();
    board_ = std::make_unique<WatchedBoard>(std::move(link), profile, stored);
    const auto opened = board_->open(true, opening(), place_.clock);
    tell(MessageKind::say, {});
    end_homing();
    if (!opened) return fail(opened.error().line);
    Device device(*this);
    LoopRules rules;
    rules.granted = RealTimeTier::fifo;
    rules.has_motors = true;
    rules.watches_kiosk = true;
    ServoLoop loop(device, profile, period_s, exchange_, recorder_, rules);
    loop_start_s_ = answered_s_ = place_.time.now_s;
    loop.run(place_.clock, period_ns, end_);
    loop_start_s_.reset();
    link_ = nullptr;
    const bool is_zero = board_->release();
    if (!lost_.empty()) return fail(lost_);
    return is_zero ? 0 : fail("the board did not confirm zero torque: switch its motors off");
}

void ServoLife::serve() {
    if (!is_ticking()) return;
    const double now_s = place_.time.now_s;
    if (region_.channel().is_device_silent == 0) answered_s_ = now_s;
    if (board_->has_lost_place())
        lost_ = "the handle has lost its place; its home is found anew";
    else if (now_s - answered_s_ > longest_absence_s)
        lost_ = "the device does not answer any more: check its plug";
    if (!lost_.empty()) end_.is_wanted = true;
    Arrival arrival;
    while (receive(socket_, arrival) == ReceiveStatus::received)
        if (arrival.message.kind == MessageKind::scene) feel(arrival);
}

void ServoLife::feel(const Arrival& arrival) {
    auto scene = scene_of(arrival);
    if (scene)
        exchange_.feel(std::move(scene->scene));
    else
        tell(MessageKind::notice, scene.error().line);
}

/// The person who homed the device lets go.
void ServoLife::end_homing() {
    if (!place_.hand.is_homing()) return;
    place_.hand.hear({}, place_.time.now_s);
    place_.board.grip(no_hand);
}

void ServoLife::die() {
    end_homing();
    if (link_ != nullptr) link_->sever();
    loop_start_s_.reset();
}

}  // namespace touchline
