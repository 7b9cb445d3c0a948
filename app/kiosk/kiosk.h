// The kiosk without its window: carries out a visit's orders and tells it what happens.
//
//   keys, hand, headphones, stick, camera, loader ──> Visit (app/session) ──> speech, cues, servo,
//                                                                             loader, camera, stick
//
// Threads: the screen's; the parts hide all other threads. No call waits.
#pragma once

#include "app/decode/reading_order.h"
#include "app/keys/key_filter.h"
#include "app/keys/two_switches.h"
#include "app/kiosk/file_source.h"
#include "app/kiosk/missing_parts.h"
#include "app/kiosk/operator_session.h"
#include "app/kiosk/photo_capture.h"
#include "app/kiosk/pictures.h"
#include "app/loading/loader.h"
#include "app/servo/servo_client.h"
#include "app/session/keys.h"
#include "app/session/status.h"
#include "app/session/visit.h"
#include "app/sound/visitor_sound.h"
#include "config/settings/keys.h"
#include "config/settings/settings.h"
#include "haptics/pantograph/profile.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// `sticks` and `photos` may be null: the site has none.
struct KioskParts {
    std::vector<Language> languages;  // not empty, English first
    Gallery gallery;                  // in these languages
    std::unique_ptr<ServoClient> servo;
    std::unique_ptr<VisitorSound> sound;
    std::unique_ptr<Loader> loader;
    std::unique_ptr<FileSource> sticks;
    std::unique_ptr<PhotoCapture> photos;
    Settings settings;
    KeyTable keys = default_keys();
    /// Null: nobody can enter. Its settings and keys are the ones above.
    std::unique_ptr<OperatorSession> operator_session;
    /// Anybody may use the operator's keys, as in a window on somebody's desktop.
    bool are_keys_free = false;
    std::function<int()> minute_of_day;  // 0 ... 1439, of the site's clock; none: always open
    DeviceProfile profile;
    std::string hand_words;  // as LiveFacts::hand_words
    std::string hand_name;   // as LiveFacts::hand_name
    /// Set to the spoken language, in which words in pictures are read. May be null.
    std::shared_ptr<std::atomic<WrittenLanguage>> reading_language;
};

class Kiosk {
  public:
    explicit Kiosk(KioskParts parts);

    /// A key of a keyboard, keypad or joystick changed, at a time of step()'s clock. The table of
    /// keys decides its meaning, then the staff's table (app/session/keys.h); else it is a dead
    /// key. Once there is a PIN, a spoken sentence refuses the operator's keys unless the operator
    /// is inside.
    void change_key(const KeyChange& change);

    /// Presses the first key that the table gives this role.
    void press(KeyRole role);

    /// A joystick's axis turned, counter-clockwise: turns a shape in the hand.
    void turn_knob(double by_rad) { apply(KnobTurned{by_rad}); }

    /// A key of the operator's own keyboard (Settings::operator_device). Only the operator uses it,
    /// so its operator's keys need no PIN.
    void strike_operator_key(const PhysicalKey& key);

    /// Offers pictures to choose from, as if a stick had brought them. `rest`: what else it holds.
    void offer(std::vector<FilePtr> files, const StickRest& rest = {});

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

    [[nodiscard]] const Language& language() const { return language_of(visit_, world()); }

    /// The visual sign of the last sound, for one second; then nothing.
    [[nodiscard]] std::string sound_sign() const;

    [[nodiscard]] const HandState& hand() const { return hand_; }

    [[nodiscard]] const ForceStatus& force() const { return force_; }

    [[nodiscard]] const ShownScene& shown() const { return shown_; }

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

    [[nodiscard]] VisitWorld world() const { return {languages_, settings_, titles(), rules_}; }

    [[nodiscard]] const std::vector<std::vector<GalleryTitle>>& titles() const {
        return pictures_.titles();
    }

    void apply(const VisitEvent& event);
    void act(Action action);
    void press_for_visit(KeyRole role);
    void tell_operator(const OperatorEvent& event);
    void strike_key(const KeyStruck& struck);
    [[nodiscard]] bool are_keys_free() const;
    [[nodiscard]] bool takes_operator_keys() const;
    void keep_recording();
    void tell_of_recording(const std::string& notice);
    void follow_operator();
    void follow_hours();
    void run_test(TestStep step);
    void follow_motor_test();

    [[nodiscard]] bool is_motor_test_on() const {
        constexpr double motor_test_lasts_s = 2.5;
        return motor_test_s_ > 0.0 && now_s_ - motor_test_s_ < motor_test_lasts_s;
    }

    void answer_test(TestStep step, bool has_passed, const std::string& line = {});
    void say_for_operator(const std::string& text);
    [[nodiscard]] std::vector<std::string> live_words() const;
    [[nodiscard]] FeltBounds felt_bounds() const;
    void press_switch(SwitchEvent event);

    void take(VisitStep step);
    void follow_rules();
    void follow_headphones();
    void follow_stick(std::int64_t now_ns);
    void follow_loader();
    void follow_camera(double now_s);
    void follow_servo();
    void follow_guidance();
    void follow_troubles();
    void follow_part(Part part, bool is_there);
    void trouble(TroubleKind kind, const std::string& sentence);
    void take(Delivery delivery);
    void refuse(std::uint64_t request, const std::string& line);
    void stay_with_felt();
    void load(const LoadPicture& order);
    [[nodiscard]] FilePtr file_of_order(const LoadPicture& order) const;
    void guide(const Guide& guide);
    void set_servo();
    void wipe();
    void report(const std::string& line);
    [[nodiscard]] std::string device_trouble() const;
    [[nodiscard]] std::string told_reason(const std::string& line) const;
    [[nodiscard]] std::optional<Position> target() const;

    std::vector<Language> languages_;
    Pictures pictures_;
    std::unique_ptr<ServoClient> servo_;
    std::unique_ptr<VisitorSound> sound_;
    std::unique_ptr<Loader> loader_;
    std::unique_ptr<FileSource> sticks_;
    std::unique_ptr<PhotoCapture> photos_;
    Settings settings_;
    DeviceProfile profile_;
    std::string hand_words_;
    std::string hand_name_;
    VisitRules rules_;
    std::shared_ptr<std::atomic<WrittenLanguage>> reading_language_;

    std::unique_ptr<OperatorSession> operator_;
    bool are_keys_always_free_ = false;
    std::function<int()> minute_of_day_;
    std::string operator_caption_;
    bool is_handle_locked_ = false;
    double motor_test_s_ = 0.0;  // when it began; 0: none
    bool is_motor_test_due_ = false;
    bool is_recording_due_ = false;  // the operator waits for the result
    SiteOpening opening_ = SiteOpening::open;
    double hours_looked_s_ = -1e9;
    double visit_began_s_ = 0.0;
    bool was_visit_on_ = false;
    KeyTable keys_;
    KeyFilter filter_;
    SwitchScan scan_;
    WindowWishes window_wishes_;

    Visit visit_;
    Feel feel_;  // as it was last ordered
    GuidanceCommand guidance_;
    bool is_guiding_ = false;
    PatternCommand pattern_;
    bool is_emergency_stop_ = false;  // until the staff clears it
    std::uint32_t faults_cleared_ = 0;
    HandState hand_;
    ForceStatus force_;
    ShownScene shown_;
    std::shared_ptr<const TactileMap> map_;  // that is felt
    std::vector<PartFacts> parts_;           // of map_
    LoadPicture order_;                      // the last one
    FilePtr wanted_;                         // its file
    FilePtr felt_file_;                      // the file that is felt
    LoadPicture felt_order_;                 // the order that brought it
    bool is_loading_ = false;
    Position last_seen_W_;  // the handle's place when it last counted as moved
    double now_s_ = 0.0;
    double ticked_s_ = 0.0;
    std::optional<bool> are_headphones_in_;
    bool has_camera_ = false;
    bool is_listing_ = false;
    MissingParts missing_;
    bool is_previewing_ = false;
    std::optional<ScreenEvent> sign_;
    double signed_s_ = 0.0;
    std::array<std::string, trouble_count> troubles_;  // as they were told
    std::string report_;
};

}  // namespace touchline
