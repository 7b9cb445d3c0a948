// A servo on a virtual clock with a simulated pantograph and a hand that a test leads.
// Threads: one.
#pragma once

#include "app/force/servo/servo_client.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/rendering.h"
#include "haptics/servo/servo_step.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

class SteppedServo final : public ServoClient {
  public:
    SteppedServo();

    /// Ticks at 1 kHz up to `now_s`.
    void run_until(double now_s);

    void set(const ServoCommands& commands) override { commands_ = commands; }

    void feel(const FeltPicture& picture) override {
        picture_ = picture;
        ++felt_count;
    }

    [[nodiscard]] const HandState& latest() override { return report_.hand; }

    [[nodiscard]] ForceStatus force_status() override { return report_.force; }

    [[nodiscard]] std::optional<ContactEvent> next_event() override { return std::nullopt; }

    [[nodiscard]] std::optional<RealTimeTier> tier() const override {
        return RealTimeTier::best_effort;
    }

    [[nodiscard]] LatenessBars lateness() const override { return {}; }

    [[nodiscard]] std::uint64_t beats() override { return report_.hand.ticks; }

    [[nodiscard]] std::string take_notice() override { return std::exchange(notice, {}); }

    [[nodiscard]] std::string device_words() override { return words; }

    void home_again() override { ++homings; }

    [[nodiscard]] std::optional<std::string> kind() const override { return own_kind; }

    void choose_kind(const std::string& profile) override { kinds_chosen.push_back(profile); }

    void hold_recording() override { ++recordings_held; }

    void keep_recording() override { ++recordings_kept; }

    void forget_recording() override { ++recordings_forgotten; }

    void stop() override {}

    [[nodiscard]] const FeltPicture& picture() const { return picture_; }

    [[nodiscard]] const ServoCommands& commands() const { return commands_; }

    MouseHand& hand() { return *hand_; }

    /// The true position of the tip.
    [[nodiscard]] Position handle_W() const { return device_.tip().position; }

    /// The force that the motors make at the tip now.
    [[nodiscard]] Force force_on_handle_W() const;

    /// Sets the limits that depend on a loop's real-time priority; before, nothing is limited.
    void set_tier(const TierLimits& tier);

    void break_device(bool is_broken) { is_broken_ = is_broken; }

    int felt_count = 0;
    int homings = 0;
    int recordings_held = 0;
    int recordings_kept = 0;
    int recordings_forgotten = 0;
    std::optional<std::string> own_kind;    // none: a simulated device
    std::vector<std::string> kinds_chosen;  // in order
    std::string words;
    std::string notice;  // told on the next request
    double most_force_N = 0.0;
    double delay_s = 0.0;                           // the loop's measured delay
    std::function<void(const HandState&)> on_tick;  // may be empty

  private:
    DeviceProfile profile_;
    std::shared_ptr<MouseHand> hand_;
    SimulatedPantograph device_;
    ShapeInHand shape_;
    std::optional<ServoStep> step_;
    ServoCommands commands_;
    FeltPicture picture_;
    std::deque<std::shared_ptr<const Scene>> alive_;  // the step may still feel the previous scene
    ServoReport report_;
    double now_s_ = 0.0;
    bool is_broken_ = false;
};

}  // namespace touchline
