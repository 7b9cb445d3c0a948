// A whole kiosk on a virtual clock, with somebody at it: what is said and done becomes a
// transcript, the same on every machine. All of it is the product's but the window, the device
// (tests/app/kiosk/stepped_servo.h), the voice (timed_voice.h) and what is staged
// (staged_things.h). Threads: one.
#pragma once

#include "app/kiosk/kiosk.h"
#include "app/operator/operator_items.h"
#include "haptics/device/homing.h"
#include "tests/app/kiosk/stepped_servo.h"
#include "tests/app/kiosk/transcripts/timed_voice.h"
#include "tests/sim/kiosk/sim_file_source.h"

#include <filesystem>
#include <memory>
#include <string>

namespace touchline {

/// How its house is set.
struct Staging {
    std::string language = "en";  // that visits begin in
    int two_switches = 0;         // as Settings has it
};

class StagedKiosk {
  public:
    explicit StagedKiosk(const Staging& staging);
    ~StagedKiosk();
    StagedKiosk(const StagedKiosk&) = delete;
    StagedKiosk& operator=(const StagedKiosk&) = delete;

    // What the person does. Each is a stage direction.
    void press(KeyRole role);
    void do_nothing(double for_s);
    void press_quickly(KeyRole role);
    void put_stick();
    void pull_stick();

    /// The board loses its power.
    void break_device();

    /// It has power again, and the person does what homing says.
    void home_device();

    /// Along the first line of what is felt, for so long, at a slow pace.
    void follow_a_line(double for_s);

    // What the person hears meanwhile.

    /// To the end of all that is said, with what is said after a pause.
    void listen();

    /// To the end of the first thing that is said.
    void hear_one_thing();

    // What the person does by what was heard. Throws std::runtime_error where it is not there.

    /// Down, until the item with this id (ScreenItem::id) is said.
    void go_to(int id);

    /// go_to() and Select, then listen().
    void choose(int id);

    void choose(VisitItem item) { choose(static_cast<int>(item)); }

    void choose(OperatorItem item, std::size_t index);

    /// With two switches: on to the item of this key, which comes after those of the screen, and
    /// selects it.
    void choose_key(KeyRole role);

    /// Until a screen of the visit is open that is worth listening to.
    void wait_for(VisitScreen screen);

    [[nodiscard]] SpokenScreen screen() const { return kiosk_->screen(); }

    [[nodiscard]] const Transcript& transcript() const { return hearing_->transcript; }

  private:
    void run(double for_s);
    void move_to(Position to);
    void home_to(HomingStep step, const std::string& direction);
    void tell(const std::string& direction);

    double now_s_ = 0.0;
    bool has_two_switches_ = false;
    std::filesystem::path folder_;
    std::shared_ptr<Hearing> hearing_ = std::make_shared<Hearing>();
    SteppedServo* servo_ = nullptr;    // the kiosk's
    SimFileSource* sticks_ = nullptr;  // likewise
    std::unique_ptr<Kiosk> kiosk_;
};

}  // namespace touchline
