// The servo as a simulated kiosk sees it: the real line to it, on site time. Threads: one.
#pragma once

#include "app/force/servo/servo_client.h"
#include "app/force/servo/servo_connection.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace touchline {

class LineServo final : public ServoClient {
  public:
    /// Both must outlive it. `now_s`: site time.
    LineServo(ServoConnection& line, const double& now_s) : line_(line), now_s_(now_s) {}

    void set(const ServoCommands& commands) override {
        told = commands;
        line_.set(commands);
    }

    void feel(const FeltPicture& picture) override {
        felt = picture.map;
        drawings[picture.map->version] = picture.map->drawing;
        ++pictures;
        line_.feel(picture);
    }

    [[nodiscard]] const HandState& latest() override {
        line_.update(report_, std::llround(1e9 * now_s_));
        return report_.hand;
    }

    [[nodiscard]] ForceStatus force_status() override { return report_.force; }

    [[nodiscard]] std::optional<ContactEvent> next_event() override { return line_.next_event(); }

    [[nodiscard]] std::optional<RealTimeTier> tier() const override { return line_.tier(); }

    [[nodiscard]] LatenessBars lateness() const override { return {}; }

    [[nodiscard]] std::uint64_t beats() override { return report_.hand.ticks; }

    [[nodiscard]] std::string take_notice() override { return line_.take_notice(); }

    [[nodiscard]] std::string device_words() override { return line_.device_words(); }

    void home_again() override { is_homing_wanted = true; }

    void hold_recording() override { line_.ask_recorder(MessageKind::hold); }

    void keep_recording() override { line_.ask_recorder(MessageKind::keep); }

    void forget_recording() override { line_.ask_recorder(MessageKind::forget); }

    void stop() override {}

    ServoCommands told;
    std::shared_ptr<const TactileMap> felt;
    std::map<std::uint64_t, std::uint64_t> drawings;  // of each map, by its version; 0: it is none
    std::uint64_t pictures = 0;
    bool is_homing_wanted = false;

  private:
    ServoConnection& line_;
    const double& now_s_;
    ServoReport report_;
};

}  // namespace touchline
