// Everything that happens to a visit. Time comes in by Tick alone.
// Threads: plain values.
#pragma once

#include "app/session/page_place.h"
#include "app/session/screen_model.h"
#include "app/session/visit_orders.h"
#include "app/sticks/listing.h"
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

/// 20 times a second or oftener. `now_s` never goes back; any clock.
struct Tick {
    double now_s = 0.0;
};

struct KeyPressed {
    KeyRole role = KeyRole::select;
};

/// Shortcuts of larger keypads; every one is also an item of a screen or another key.
enum class SpeechKey : std::uint8_t { repeat, pause, slower, faster };

struct SpeechKeyPressed {
    SpeechKey key = SpeechKey::repeat;
};

/// A key without a meaning.
struct DeadKeyPressed {};

/// A knob, since the last.
struct KnobTurned {
    double by_rad = 0.0;  // counter-clockwise
};

/// Where the handle is, as often as convenient (10 to 60 times a second).
struct HandleSeen {
    Position place_W;                 // of the map that is felt
    std::optional<std::size_t> part;  // of PictureFacts::parts that it is on
    bool has_moved = false;           // more than 2 mm since the last that said so
    double speed_m_per_s = 0.0;
    bool is_led = false;  // it moves by itself now; not while it waits for a hand
};

struct HeadphonesChanged {
    bool are_in = false;
};

struct StickArriving {};  // it came and is being read

/// `names`: of its files, as it has them and in its order.
struct StickCame {
    std::vector<std::string> names;
    StickRest rest;
};

/// Pulled out, or refused: then `sentence` says why. Known only now: what was read stays.
struct StickGone {
    std::string sentence;
};

/// A part of the picture that can be named and reached.
struct PartFacts {
    std::string name;            // in the language that was ordered; never empty
    Position place_W;            // on it, of the map that is felt
    Position middle_W;           // of the box around it
    int detail = 1;              // 1 ... 5
    std::optional<int> outline;  // index in the map; none: a place without a line
};

struct PictureFacts {
    std::string title;        // empty: nobody named it
    std::string description;  // the way it is drawn, and an overview; may be empty
    std::vector<PartFacts> parts;
    PagePlace place = {1, 1, 1, 1};
    int outline_count = 0;
    int outer_outline = 0;               // index in the map: what a first tour goes round
    std::string note;                    // one sentence worth telling; may be empty
    std::vector<NamedThing> names = {};  // what the things of a photograph are taken for
};

/// A second one for the same request is better than the first (labels found later).
struct PictureReady {
    std::uint64_t request = 0;
    PictureFacts facts;
};

/// A second look at what is felt by that request: where it stands among its views now.
struct ThingsLookedFor {
    std::uint64_t request = 0;
    PagePlace place;
    std::vector<NamedThing> names = {};
};

/// What was felt before stays. `sentence`: what, why and what to do.
struct PictureFailed {
    std::uint64_t request = 0;
    std::string sentence;
};

struct CameraChanged {
    bool is_there = false;
};

/// The picture is taken: the shutter's moment.
struct CameraCaptured {
    bool is_doubtful = false;  // blurred or too bright, even after a second attempt
};

struct CameraFailed {
    std::string sentence;
};

struct GuidanceEnded {
    bool has_arrived = false;  // false: it was stopped, or nobody held the handle
};

enum class TroubleKind : std::uint8_t { device, sound, camera, stick };

inline constexpr std::size_t trouble_count = 4;

/// `sentence`: what, why and what to do. Again while it lasts: other words of it.
struct TroubleBegan {
    TroubleKind kind = TroubleKind::device;
    std::string sentence;
};

struct TroubleEnded {
    TroubleKind kind = TroubleKind::device;
};

/// What the house wants of the kiosk.
enum class SiteOpening : std::uint8_t { open, closed, maintenance };

/// A visit that is under way ends, is wiped, and the visitor is told.
struct OpeningChanged {
    SiteOpening opening = SiteOpening::open;
};

/// The operator set something else; VisitWorld has what holds now.
struct SettingsChanged {
    Settings before;
};

/// Somebody came.
struct StaffCalledOff {};

using VisitEvent = std::variant<Tick, KeyPressed, SpeechKeyPressed, DeadKeyPressed, KnobTurned,
                                HandleSeen, HeadphonesChanged, StickArriving, StickCame, StickGone,
                                PictureReady, ThingsLookedFor, PictureFailed, CameraChanged,
                                CameraCaptured, CameraFailed, GuidanceEnded, TroubleBegan,
                                TroubleEnded, OpeningChanged, SettingsChanged, StaffCalledOff>;

}  // namespace touchline
