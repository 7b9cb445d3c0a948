// The kiosk's handle: what the servo is told, and what it tells of the hand.
// Threads: one; no call waits but the servo's stop().
#pragma once

#include "app/force/servo/servo_client.h"
#include "app/visit/visit_events.h"
#include "app/visit/visit_orders.h"
#include "config/settings/settings.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace touchline {

class KioskHandle {
  public:
    /// `settings` are the kiosk's: each call uses them as they are then.
    KioskHandle(std::unique_ptr<ServoClient> servo, const DeviceProfile& profile,
                const Settings& settings);

    /// The time of all that follows.
    void set_time(double now_s) { now_s_ = now_s; }

    /// While nobody is here the servo may rest.
    void set_nobody_here(bool is_nobody_here);

    void carry_out(const Feel& feel);
    void carry_out(const Guide& guide);
    void carry_out(const GivePattern& given);

    /// Turns the force off until clear_fault().
    void stop_at_once();
    void clear_fault();

    /// A locked handle has no force.
    void lock(bool is_locked);

    /// Tests the force for two seconds, with a shake when it is on.
    void begin_motor_test();
    void follow_motor_test();

    /// Tells the servo everything that holds now. Call it after a change of the settings.
    void set_servo();

    /// The visit is over: feels an empty picture, and nothing of the old one stays.
    void wipe();

    /// Writes the last minute to a file, for an operator who waits for the result.
    void keep_recording();

    /// Whether the recording that is waited for was kept, by the servo's notice; nothing: the
    /// notice does not say it, or nobody waits.
    [[nodiscard]] std::optional<bool> is_recording_kept(const std::string& notice);

    /// Asks the servo for the hand and the force of its newest tick.
    void look();

    [[nodiscard]] const HandState& hand() const { return hand_; }

    [[nodiscard]] const ForceStatus& force() const { return force_; }

    /// What the visit is told of the hand, all but the part under it. Tells each motion once.
    [[nodiscard]] HandleSeen take_seen();

    /// Nothing: no guidance has ended since the last call.
    [[nodiscard]] std::optional<GuidanceEnded> take_guidance_end();

    /// Where the handle is led to, for cues that tell the way; nothing while it is not.
    [[nodiscard]] std::optional<Position> target() const;

    [[nodiscard]] ServoClient& servo() const { return *servo_; }

  private:
    [[nodiscard]] bool is_motor_test_on() const;

    std::unique_ptr<ServoClient> servo_;
    DeviceProfile profile_;
    const Settings& settings_;
    double now_s_ = 0.0;
    Feel feel_;  // as it was last ordered
    GuidanceCommand guidance_;
    bool is_guiding_ = false;
    PatternCommand pattern_;
    bool is_emergency_stop_ = false;
    std::uint32_t faults_cleared_ = 0;
    bool is_handle_locked_ = false;
    bool is_nobody_here_ = false;
    double motor_test_s_ = 0.0;  // when it began; 0: none
    bool is_motor_test_due_ = false;
    bool is_recording_due_ = false;
    HandState hand_;
    ForceStatus force_;
    std::uint32_t moves_seen_ = 0;  // of HandState::hand_moves
};

}  // namespace touchline
