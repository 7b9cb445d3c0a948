// A whole kiosk on a virtual clock with a person at it: what is said and done becomes a transcript,
// the same on every machine. All parts are the product's except the window, the device
// (tests/app/kiosk/stepped_servo.h), the voice (timed_voice.h) and what is staged
// (staged_things.h). Threads: one.
#pragma once

#include "app/kiosk/kiosk.h"
#include "app/operator/operator_menu.h"
#include "config/types/pinned.h"
#include "haptics/device/homing.h"
#include "tests/app/kiosk/stepped_servo.h"
#include "tests/app/kiosk/transcripts/transcript.h"
#include "tests/machines/sim/kiosk/sim_sources.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace touchline {

/// The kiosk's settings.
struct Staging {
    std::string language = "en";  // in which visits begin
    SwitchUse two_switches = SwitchUse::none;
    bool offers_drawing = false;
    bool has_printer = false;
};

class StagedPrinter;

class StagedKiosk : private Pinned {
  public:
    explicit StagedKiosk(const Staging& staging);
    ~StagedKiosk();

    // What the person does. Each call writes a stage direction.
    void press(KeyRole role);
    void do_nothing(double for_s);
    void press_quickly(KeyRole role);
    /// A stick with a document of twelve pages and a file that is no document.
    void put_stick();

    /// A stick with 205 pictures, as people and a camera name them.
    void put_full_stick();
    void pull_stick();

    /// The board loses power.
    void break_device();

    /// The board has power again, and the person does what homing says.
    void home_device();

    /// The next sheet finds no paper.
    void empty_printer();

    /// Follows the first line of what is felt for so long, at a slow pace.
    void follow_a_line(double for_s);

    // What somebody beside the person does.

    /// Draws a straight line (W) in a second.
    void draw_line(Position from, Position to);

    /// Touches the place with the pen's other button.
    void erase_at(Position place);

    // What the person hears meanwhile.

    /// Listens to the end of all that is said, including what is said after a pause.
    void listen();

    /// Listens to the end of the first thing that is said.
    void hear_one_thing();

    // What the person does after hearing it. Throws std::runtime_error if it is not there.

    /// Presses Down until the item with this id (ScreenItem::id) is said.
    void go_to(int id);

    /// Calls go_to(), presses Select, then calls listen().
    void choose(int id);

    void choose(VisitItem item) { choose(static_cast<int>(item)); }

    void choose(OperatorItem item, std::size_t index);

    /// With one switch: waits until the item with this id has come and was said, then presses the
    /// switch and listens to one thing.
    void choose_when_it_comes(int id);

    /// Moves on by two switches until this key is said, which comes after the items of the
    /// screen, and selects it. Not for Back where the last item is called so.
    void choose_key(KeyRole role);

    /// Waits until this screen of the visit is open, then calls listen().
    void wait_for(VisitScreen screen);

    [[nodiscard]] SpokenScreen screen() const { return kiosk_->screen(); }

    [[nodiscard]] const Transcript& transcript() const { return hearing_->transcript; }

  private:
    void run(double for_s);
    void move_to(Position to);
    void home_to(HomingStep step, const std::string& direction);
    void tell(const std::string& direction);
    void put(std::vector<FilePtr> files);

    double now_s_ = 0.0;
    SwitchUse switches_ = SwitchUse::none;
    std::filesystem::path folder_;
    std::shared_ptr<Hearing> hearing_ = std::make_shared<Hearing>();
    SteppedServo* servo_ = nullptr;     // owned by the kiosk
    SimFileSource* sticks_ = nullptr;   // likewise
    StagedPrinter* printer_ = nullptr;  // likewise
    std::unique_ptr<Kiosk> kiosk_;
};

}  // namespace touchline
