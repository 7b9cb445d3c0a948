// The operator's screens as a pure state machine. A key, a moment or an answer comes in; the new
// state and the orders for the kiosk come out. Threads: values and pure functions.
#pragma once

#include "app/operator/counters.h"
#include "app/operator/health.h"
#include "app/operator/pin.h"
#include "app/operator/self_test.h"
#include "app/operator/setting_words.h"
#include "app/visit/keys/key_wizard.h"
#include "app/visit/screen_model.h"
#include "config/settings/keys.h"
#include "config/settings/settings.h"
#include "config/settings/sound.h"

#include <chrono>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace touchline {

/// Every screen. operator_menu.h holds their titles and contents.
enum class OperatorPlace : std::uint8_t {
    closed,  // the kiosk belongs to the visitors
    pin,
    new_pin,
    new_pin_again,
    home,
    status,
    touch,
    feel,
    levels,
    picture,
    profiles,
    ears,
    sounds,
    volume,
    languages,
    visits,
    times,
    hours,
    care,
    senses,
    camera,
    keys,
    key_wizard,
    screen,
    sticks,
    printing,
    device,
    homing,
    kind,
    self_test,
    test_step,
    live,
    cleaning,
    cleaning_lock,
    upkeep,
    library,
    several,
    bundle,
    way_back,
    house_key,
    own_key,
    key_pin,
    counters,
    days,
    log,
    backup,
    paths,
    close,
    question,
};

inline constexpr std::size_t operator_place_count = 49;

/// The screens that need the PIN.
[[nodiscard]] constexpr bool is_inside(OperatorPlace place) {
    return place > OperatorPlace::new_pin_again;
}

/// The screens on which a PIN is entered.
[[nodiscard]] constexpr bool is_of_pin(OperatorPlace place) {
    return place == OperatorPlace::key_pin || (place != OperatorPlace::closed && !is_inside(place));
}

/// Those on which the kiosk's PIN is asked for.
[[nodiscard]] constexpr bool asks_for_pin(OperatorPlace place) {
    return place == OperatorPlace::pin || place == OperatorPlace::key_pin;
}

/// The questions asked before something is done.
enum class Question : std::uint8_t {
    ceiling,
    restore,
    close,
    zero_counters,
    first_settings,
    file_systems,
    kind,
    apply_bundle,
    go_back
};

inline constexpr std::size_t question_count = 9;

struct Operator {
    OperatorPlace place = OperatorPlace::closed;
    std::size_t focus = 0;
    bool is_held = false;     // Up and Down change the setting that has the focus
    std::size_t entered = 0;  // keys of the entry sequence so far
    double entry_began_s = 0.0;
    double last_key_s = 0.0;
    PinEntry pin;
    std::string chosen_pin;  // the first of two entries that must be the same
    PinTries tries;
    bool is_checking = false;  // a PIN was handed over and not yet judged
    Settings settings;         // the site's settings while they are edited
    SoundSettings sound;
    KeyWizard wizard;
    SelfTest test;
    OperatorPlace tested_from = OperatorPlace::self_test;  // where the test leads back to
    Question question = Question::ceiling;
    std::size_t kind = 0;       // index of kind_rows(), for the question
    double lock_until_s = 0.0;  // the end of the cleaning lock
    std::string device_words;   // as they were last told
    std::string note;           // the result of the last order; said and shown
};

struct OfferedLanguage {
    std::string code;
    std::string name;  // in the language itself
};

struct OfferedProfile {
    std::string name;
    std::vector<std::size_t> rows;  // the indices of setting_rows() that it sets
};

/// What the kiosk tells of its parts; all texts are in the spoken language.
struct KioskFacts {
    bool is_private = true;         // headphones are known to be in; else no digit is said
    std::vector<std::string> live;  // facts in words: force, level, loop
    /// The profile that the handle is taken for; empty: nobody has said. Nothing: the handle is
    /// simulated.
    std::optional<std::string> kind;
    FeltBounds bounds;
    std::string device_words;     // for the person at the handle; empty: nothing to do
    std::chrono::sys_days today;  // by the site's clock
    KioskHealth health;
};

/// What the screens know; all texts are in the spoken language.
struct OperatorWorld {
    const Language& language;
    double now_s = 0.0;  // never goes back
    bool has_pin = false;
    Settings settings{};  // those of the site's file
    SoundSettings sound{};
    KeyTable keys{};
    std::vector<OfferedLanguage> languages{};
    std::vector<OfferedProfile> profiles{};
    CountedDays days{};
    std::vector<std::string> on_stick{};     // names of picture packs and networks
    std::vector<std::string> house_files{};  // names of bundles and house keys on the stick
    std::vector<std::string> house_lines{};  // of what was looked at last: changes, or digits
    KioskFacts kiosk{};
};

/// A press that counts. `role`: its role in the table of keys. `is_allowed`: it came from the
/// operator's keyboard, or none is set.
struct KeyStruck {
    PhysicalKey key;
    std::optional<KeyRole> role;
    bool is_allowed = true;
};

/// Comes at least once a second.
struct MomentPassed {};

struct PinChecked {
    bool is_right = false;
    bool is_noted = true;  // the try was recorded on the disk before it was judged
};

struct TestAnswered {
    TestStep step = TestStep::device;
    bool has_passed = false;
    std::string line;
};

/// The result of an order, or its progress, in one sentence.
struct OrderAnswered {
    std::string line;
};

/// A bundle, the way back or a key was looked at: its lines are there, for this screen.
struct HouseLooked {
    OperatorPlace place = OperatorPlace::bundle;
};

using OperatorEvent =
    std::variant<KeyStruck, MomentPassed, PinChecked, TestAnswered, OrderAnswered, HouseLooked>;

struct Say {  // shown as well
    std::string text;
};

struct Click {};  // a digit was turned to or accepted, and must not be said

struct Show {  // not said: replaces the shown words of what was said last
    std::string text;
};

struct CheckPin {
    std::string pin;
};

struct KeepPin {
    std::string pin;
};

struct SetSettings {  // they apply from now on, but are not on the disk
    Settings settings;
};

/// They apply, and are written to the disk: those that were changed here, so that what somebody
/// else wrote meanwhile stays.
struct WriteSettings {
    Settings settings;
    bool is_whole = false;  // all of them, whatever somebody else wrote
};

struct WriteSound {
    SoundSettings sound;
};

struct WriteKeys {
    KeyTable keys;
};

struct FindHome {};

struct ChooseKind {  // measures the handle as one of that kind
    std::string profile;
};

struct ClearFault {};  // ends what stopped the force, an emergency stop too

struct RunTest {
    TestStep step = TestStep::device;
};

struct StopTest {};

struct ShowLive {
    bool is_on = false;
};

struct LockHandle {  // turns the force off and ignores all keys but the operator's
    bool is_on = false;
};

struct ImportFromStick {
    std::size_t file = 0;  // index of OperatorWorld::on_stick
};

struct LookAtHouseFile {   // tells what a bundle would change, or the digits of a key
    std::size_t file = 0;  // index of OperatorWorld::house_files
};

struct LookAtWayBack {};

struct ApplyBundle {};  // the one that was looked at

struct GoBackToBefore {};  // as looked at: before the last bundle

struct MakeBundle {};

struct ShowHouseKey {};  // makes it the first time

struct TrustHouseKey {};  // the one that was looked at

struct ZeroCounters {};

struct ExportCounters {};

struct ExportLog {};

struct SaveRecording {};  // writes the last minute to a file

struct KeepDrawing {};  // keeps what somebody draws for the visitor now

struct BackUp {};

struct Restore {};

struct CloseKiosk {};

struct Leave {};  // gives the kiosk back to the visitors

using OperatorOrder =
    std::variant<Say, Click, Show, CheckPin, KeepPin, SetSettings, WriteSettings, WriteSound,
                 WriteKeys, FindHome, ChooseKind, ClearFault, RunTest, StopTest, ShowLive,
                 LockHandle, ImportFromStick, LookAtHouseFile, LookAtWayBack, ApplyBundle,
                 GoBackToBefore, MakeBundle, ShowHouseKey, TrustHouseKey, ZeroCounters,
                 ExportCounters, ExportLog, SaveRecording, KeepDrawing, BackUp, Restore, CloseKiosk,
                 Leave>;

/// True while a value is turned, or a question about one waits: it is neither kept nor given up
/// yet.
[[nodiscard]] inline bool is_editing(const Operator& state) {
    return state.is_held || state.place == OperatorPlace::question;
}

struct OperatorStep {
    Operator state;
    std::vector<OperatorOrder> orders;  // to be carried out in this order
};

/// O(items of a screen). While closed, waits only for the entry sequence: Help, Up, Up, Down, Down,
/// Select, each one key, within 5 s.
[[nodiscard]] OperatorStep step_operator(const Operator& state, const OperatorEvent& event,
                                         const OperatorWorld& world);

/// What is drawn and said now. Not for `closed`.
[[nodiscard]] SpokenScreen operator_screen(const Operator& state, const OperatorWorld& world);

}  // namespace touchline
