// Everything that happens to a visit. Only Tick brings the time.
// Threads: plain values.
#pragma once

#include "app/documents/sticks/listing.h"
#include "app/printing/print_end.h"
#include "app/visit/page_place.h"
#include "app/visit/screen_model.h"
#include "app/visit/visit_orders.h"
#include "audio-cues/speech/spoken_text.h"
#include "config/settings/settings.h"
#include "config/types/thing_name.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace touchline {

/// Comes 20 times a second or more often. `now_s` never goes back; any clock will do.
struct Tick {
    double now_s = 0.0;
};

struct KeyPressed {
    KeyRole role = KeyRole::select;
};

/// The key is still held: comes again and again, every second or so. A shortcut: nothing needs it.
struct KeyHeld {
    KeyRole role = KeyRole::down;
};

/// Shortcuts of larger keypads. Each is also an item of a screen or another key.
enum class SpeechKey : std::uint8_t { repeat, pause, slower, faster };

struct SpeechKeyPressed {
    SpeechKey key = SpeechKey::repeat;
};

/// A key without a meaning.
struct DeadKeyPressed {};

/// Somebody who draws for the visitor finished a stroke, or touched with the pen's eraser: where
/// the pen went, in the map that is felt.
struct PenStroke {
    std::vector<Position> points_W;
    bool is_eraser = false;
};

/// A stroke that was under way is lost: the drawing is no longer on the screen.
struct StrokeLost {};

/// Keys of whoever draws. Each is also an item of the drawing's screen, or the pen's eraser.
enum class DrawerKey : std::uint8_t { erase, undo, redo };

struct DrawerKeyPressed {
    DrawerKey key = DrawerKey::undo;
};

/// A knob was turned: the angle since the last event.
struct KnobTurned {
    double by_rad = 0.0;  // counter-clockwise
};

/// Where the handle is, as often as convenient (10 to 60 times a second).
struct HandleSeen {
    Position place_W;                 // of the map that is felt
    std::optional<std::size_t> part;  // under the handle: index of PictureFacts::parts
    bool has_moved = false;           // a hand has moved it since the last event
    double speed_m_per_s = 0.0;
    bool is_led = false;  // it moves by itself now; false while it waits for a hand
};

/// A page of the braille line was turned; at an end there was none to turn to.
struct LineRead {
    bool is_at_end = false;
};

struct HeadphonesChanged {
    bool are_in = false;
};

struct StickArriving {};  // a stick was plugged in and is being read

/// `names`: of its pictures, as the stick has them, in the order of sort_by_name().
struct StickCame {
    std::vector<std::string> names;
    StickRest rest;
};

/// Names as in StickCame, of pictures that the kiosk was started with: they stay for every visitor.
struct PicturesGiven {
    std::vector<std::string> names;
};

/// The stick was pulled out, or refused; `sentence` then says why. Known only now, so what was read
/// stays.
struct StickGone {
    std::string sentence;
};

/// A part of the picture that can be named and reached.
struct PartFacts {
    std::string name;                  // in the language that was ordered; never empty
    Position place_W;                  // on the part, in the map that is felt
    Position middle_W;                 // the middle of the box around it
    int detail = 1;                    // 1 ... 5
    std::optional<int> outline;        // index in the map; none: a place without a line
    VoiceRecordingPtr recording = {};  // of the name; null: nobody recorded it
};

struct PictureFacts {
    std::string title;        // empty: it has no title
    std::string description;  // how it is drawn, and an overview; may be empty
    std::vector<PartFacts> parts;
    PagePlace place = {1, 1, 1, 1};
    int outline_count = 0;
    int outer_outline = 0;                   // index in the map: the first tour follows it
    std::string note;                        // one sentence worth telling; may be empty
    std::vector<NamedThing> names = {};      // what the things of a photograph probably are
    VoiceRecordingPtr title_recording = {};  // null: nobody recorded it
    VoiceRecordingPtr description_recording = {};
};

/// A second event for the same request improves on the first (labels found later).
struct PictureReady {
    std::uint64_t request = 0;
    PictureFacts facts;
};

/// The search for things in the picture of that request has ended: where the picture stands among
/// its views now.
struct ThingsLookedFor {
    std::uint64_t request = 0;
    PagePlace place;
    std::vector<NamedThing> names = {};
};

/// The picture that was felt before stays. `sentence`: what, why and what to do.
struct PictureFailed {
    std::uint64_t request = 0;
    std::string sentence;
};

struct CameraChanged {
    bool is_there = false;
};

/// The picture is taken. Comes at the shutter's moment.
struct CameraCaptured {
    bool is_doubtful = false;  // blurred or too bright, even after a second attempt
};

struct CameraFailed {
    std::string sentence;
};

/// The sheet that was ordered is out of the printer, or will not come.
struct SheetEnded {
    PrintEnd end = PrintEnd::printed;
};

/// no_force: a fault, or the force is off. other: there was nothing to guide along.
enum class GuidanceEnd : std::uint8_t { arrived, let_go, no_force, other };

struct GuidanceEnded {
    GuidanceEnd why = GuidanceEnd::arrived;
};

enum class TroubleKind : std::uint8_t { device, sound, camera, stick };

inline constexpr std::size_t trouble_count = 4;

/// `sentence`: what, why and what to do. While it lasts, the event may come again with other words.
struct TroubleBegan {
    TroubleKind kind = TroubleKind::device;
    std::string sentence;
};

struct TroubleEnded {
    TroubleKind kind = TroubleKind::device;
};

/// Whether the site has the kiosk open.
enum class SiteOpening : std::uint8_t { open, closed, maintenance };

/// A visit under way ends, is wiped, and the visitor is told.
struct OpeningChanged {
    SiteOpening opening = SiteOpening::open;
};

/// The operator changed a setting; VisitWorld has the new settings.
struct SettingsChanged {
    Settings before;
};

/// A member of staff came.
struct StaffCalledOff {};

/// The operator's key was pressed: the kiosk ends once somebody confirms it.
struct QuitAsked {};

using VisitEvent =
    std::variant<Tick, KeyPressed, KeyHeld, SpeechKeyPressed, DeadKeyPressed, KnobTurned, PenStroke,
                 StrokeLost, DrawerKeyPressed, HandleSeen, LineRead, HeadphonesChanged,
                 StickArriving, StickCame, PicturesGiven, StickGone, PictureReady, ThingsLookedFor,
                 PictureFailed, CameraChanged, CameraCaptured, CameraFailed, SheetEnded,
                 GuidanceEnded, TroubleBegan, TroubleEnded, OpeningChanged, SettingsChanged,
                 StaffCalledOff, QuitAsked>;

}  // namespace touchline
