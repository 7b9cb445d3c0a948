// The kiosk without its window: carries out a visit's orders and tells it what happens.
//
//   keys, hand, headphones, stick, camera, loader ──> Visit (app/visit) ──> speech, cues, servo,
//                                                                             loader, camera, stick
//
// Threads: the screen's; the parts hide all other threads. No call waits.
#pragma once

#include "app/braille/visitor_braille.h"
#include "app/documents/decode/found_words.h"
#include "app/force/servo/servo_client.h"
#include "app/kiosk/kiosk_handle.h"
#include "app/kiosk/kiosk_keys.h"
#include "app/kiosk/loading/loader.h"
#include "app/kiosk/operator_session.h"
#include "app/kiosk/pen.h"
#include "app/kiosk/photo_capture.h"
#include "app/kiosk/pictures.h"
#include "app/kiosk/sheet_printer.h"
#include "app/kiosk/stick_source.h"
#include "app/kiosk/watched.h"
#include "app/sound/visitor_sound.h"
#include "app/visit/status.h"
#include "app/visit/visit.h"
#include "config/settings/keys.h"
#include "config/settings/settings.h"
#include "config/types/pinned.h"
#include "haptics/pantograph/profile.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// `sticks`, `photos`, `braille` and `printer` may be null: the site has none.
struct KioskParts {
    std::vector<Language> languages;  // not empty, English first
    Gallery gallery;                  // in these languages
    std::unique_ptr<ServoClient> servo;
    std::unique_ptr<VisitorSound> sound;
    std::unique_ptr<VisitorBraille> braille;
    std::unique_ptr<Loader> loader;
    std::unique_ptr<FileSource> sticks;
    std::unique_ptr<PhotoCapture> photos;
    std::unique_ptr<SitePrinter> printer;  // sheets are offered once the settings name a queue
    Settings settings;
    KeyTable keys = default_keys();
    /// Null: nobody can enter. Its settings and keys are the ones above.
    std::unique_ptr<OperatorSession> operator_session;
    /// Anybody may use the operator's keys, as in a window on somebody's desktop.
    bool are_keys_free = false;
    std::function<int()> minute_of_day;  // 0 ... 1439, of the site's clock; none: always open
    std::function<std::chrono::sys_days()> today;  // by that clock; none: all is of one day
    DeviceProfile profile;
    std::string hand_words;  // as LiveFacts::hand_words
    std::string hand_name;   // as LiveFacts::hand_name
    /// Set to the spoken language, in which words in pictures are read. May be null.
    std::shared_ptr<std::atomic<WrittenLanguage>> reading_language;
};

/// The picture on the screen and the hand on it.
struct DrawnPicture {
    ShownScene shown;
    HandState hand;
};

class Kiosk : private Pinned {
  public:
    explicit Kiosk(KioskParts parts);
    ~Kiosk() = default;

    /// A key of a keyboard, keypad or joystick changed, at a time of step()'s clock. The table of
    /// keys decides its meaning, then the staff's table (app/visit/keys.h); else it is a dead
    /// key. Once there is a PIN, a spoken sentence refuses the operator's keys unless the operator
    /// is inside.
    void change_key(const KeyChange& change);

    /// Presses the first key that the table gives this role; if it gives none, for the visit alone.
    void press(KeyRole role);

    /// A joystick's axis turned, counter-clockwise: turns a shape in the hand.
    void turn_knob(double by_rad) { apply(KnobTurned{by_rad}); }

    /// Somebody draws for the visitor, if takes_pen().
    void change_pen(const PenChange& change);

    /// True while a drawing is open and on the screen.
    [[nodiscard]] bool takes_pen() const;

    [[nodiscard]] const Pen& pen() const { return pen_; }

    /// A key of the operator's own keyboard (Settings::operator_device). Only the operator uses it,
    /// so its operator's keys need no PIN.
    void strike_operator_key(const PhysicalKey& key);

    /// Offers these pictures to every visitor, as if a stick had brought them.
    void give(std::vector<FilePtr> files);

    /// Called about sixty times a second; `now_ns` is of the monotonic clock.
    void step(std::int64_t now_ns);

    /// Changes what hands feel at once, in the visit under way. What else visits begin with changes
    /// at the next one.
    void set(const Settings& settings);

    [[nodiscard]] SpokenScreen screen() const;

    /// What was said last, on the screen.
    [[nodiscard]] const std::string& caption() const;

    /// The input device that only the operator uses; empty: none.
    [[nodiscard]] const std::string& operator_device() const { return settings_.operator_device; }

    [[nodiscard]] bool is_operator_in() const { return operator_ && operator_->is_open(); }

    [[nodiscard]] const Visit& visit() const { return visit_; }

    /// Nobody is here, neither a visitor nor the operator.
    [[nodiscard]] bool is_nobody_here() const {
        return open_screen(visit_) == VisitScreen::attract && !is_operator_in();
    }

    [[nodiscard]] const Language& language() const { return language_of(visit_, world()); }

    /// The visual sign of the last sound, for one second; then nothing.
    [[nodiscard]] std::string sound_sign() const;

    [[nodiscard]] const HandState& hand() const { return handle_.hand(); }

    [[nodiscard]] const ForceStatus& force() const { return handle_.force(); }

    [[nodiscard]] const ShownScene& shown() const { return picture_.shown(); }

    /// What is felt; while nobody is here, a picture of the gallery and a hand that feels it.
    [[nodiscard]] DrawnPicture drawn() const;

    /// The lines of each item that is a picture of the gallery, or one that this visitor has felt;
    /// else null. Empty if none is.
    [[nodiscard]] std::vector<LineDrawingPtr> pictures_of(const SpokenScreen& screen) const;

    /// How a visitor's two switches are used; none while the operator, who has all keys, is in.
    [[nodiscard]] SwitchUse switches() const {
        return is_operator_in() ? SwitchUse::none : settings_.two_switches;
    }

    /// The camera's view while it is to be shown; else null.
    [[nodiscard]] std::shared_ptr<const Canvas> preview() const;

    /// Lines for the log, each ended; empty: nothing new. They name no file and no text of a
    /// visitor.
    [[nodiscard]] std::string take_report();

    /// What the staff wants to see.
    struct WindowWishes {
        bool shows_live_view = false;
        bool shows_boxes = false;
        bool is_quitting = false;
    };

    [[nodiscard]] const WindowWishes& window_wishes() const { return window_wishes_; }

    [[nodiscard]] LiveFacts live_facts() const;

    /// Releases the stick and stops the servo.
    void stop();

  private:
    struct VisitOrderHandler;
    struct OperatorOrderHandler;

    /// The visual sign of a sound.
    struct Sign {
        ScreenEvent event;
        double since_s;
    };

    [[nodiscard]] VisitWorld world() const {
        return {languages_, settings_, pictures_.titles(), rules_};
    }

    void apply(const VisitEvent& event);
    void take(VisitStep step);
    void tell(const std::optional<VisitEvent>& event);
    void wipe();
    void follow_rules();

    // What a step follows.
    void follow_headphones();
    void follow_stick(std::int64_t now_ns);
    void offer(std::vector<FilePtr> files, const StickRest& rest);
    void follow_loader();
    void feel_drawing(const FeelDrawing& order);
    void follow_pen();
    void keep_lines_of_felt();
    void follow_camera();
    void follow_printer();
    [[nodiscard]] TactileMap map_to_print() const;
    void tick();
    void follow_handle();
    void follow_troubles();
    void follow_part(Part part, bool is_there);
    [[nodiscard]] std::string device_trouble() const;
    void report(const std::string& line);

    // Words for ears and fingers: kiosk_words.cpp.
    void say(const Utterance& utterance);
    void follow_braille();
    void take_line_event(const LineEvent& event);
    void forget_words_between_visits(VisitScreen before);

    // Keys: kiosk_keys.cpp.
    void hold_key(const KeyChange& change);
    void act(Action action);

    /// Says a text of the context "operator" to whoever pressed a key of the staff.
    void answer_staff(const std::string& english);

    /// Says what the visit knows nothing of.
    void say_of_key(const std::string& text);
    void press_for_visit(KeyRole role);
    void press_switch(SwitchEvent event);
    void scan_by_itself();
    void strike_key(const KeyStruck& struck);
    [[nodiscard]] bool are_keys_free() const;
    [[nodiscard]] bool takes_operator_keys() const;

    // The operator: kiosk_operator.cpp.
    void tell_operator(const OperatorEvent& event);
    void tell_of_recording(const std::string& notice);
    void keep_drawing();
    void count_visit();
    void follow_hours();
    void follow_operator();
    void run_test(TestStep step);
    [[nodiscard]] bool passes(TestStep step);
    [[nodiscard]] std::vector<std::string> live_words() const;
    [[nodiscard]] std::string staffs_words() const;
    [[nodiscard]] bool is_handle_live() const;
    [[nodiscard]] bool is_force_faulty() const;
    [[nodiscard]] std::chrono::sys_days today() const;
    [[nodiscard]] KioskHealth health() const;
    [[nodiscard]] FeltBounds felt_bounds() const;

    std::vector<Language> languages_;
    Settings settings_;
    VisitRules rules_;
    Pictures pictures_;
    DeviceProfile profile_;
    KioskHandle handle_;
    std::unique_ptr<VisitorSound> sound_;
    std::unique_ptr<VisitorBraille> braille_;
    OrderedPicture picture_;
    Pen pen_;
    std::unique_ptr<FileSource> sticks_;
    std::unique_ptr<PhotoCapture> photos_;
    std::unique_ptr<SitePrinter> printer_;
    std::unique_ptr<OperatorSession> operator_;
    std::string operator_caption_;
    std::string key_caption_;  // said of a key; empty once the visit has spoken again
    KioskKeys keys_;
    SiteHours hours_;
    std::function<std::chrono::sys_days()> today_;
    VisitLength length_;
    Watched watched_;
    MissingParts missing_;
    HandleReady ready_;
    FaultCount faults_;
    std::optional<double> started_s_;  // the time of the first step
    LiveFacts device_facts_;           // of them, what the hand is
    std::shared_ptr<std::atomic<WrittenLanguage>> reading_language_;
    Visit visit_;
    std::optional<Sign> sign_;
    WindowWishes window_wishes_;
    double now_s_ = 0.0;
    double ticked_s_ = 0.0;
    std::string report_;
};

}  // namespace touchline
