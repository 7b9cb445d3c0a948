// Everything that a visit orders, to be carried out in the order given. All orders are idempotent
// values.
// Threads: plain values.
#pragma once

#include "app/documents/sticks/spoken_name.h"
#include "audio-cues/cues/cue_table.h"
#include "audio-cues/speech/speech_queue.h"
#include "config/types/guidance.h"
#include "config/types/hand_state.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

namespace touchline {

/// A named step of stiffness, relative to the operator's.
struct StiffnessStep {
    double share;  // times the operator's stiffness
    std::string_view name;
};

/// Softest first. Neighbouring steps can be told apart (the hand tells stiffness apart from 13 to
/// 17 % on).
inline constexpr std::array stiffness_steps{
    StiffnessStep{0.4, "very soft"}, StiffnessStep{0.7, "soft"}, StiffnessStep{1.0, "medium"},
    StiffnessStep{1.4, "firm"}};

inline constexpr std::size_t operators_stiffness = 2;  // index of stiffness_steps

static_assert(stiffness_steps[operators_stiffness].share == 1.0);

/// Stops speech, except safety messages. Sent at every key.
struct Hush {};

/// Pauses speech. The next one goes on speaking.
struct HoldSpeech {};

struct GiveCue {
    ScreenEvent event = ScreenEvent::key_taken;
};

struct GivePattern {
    HandlePattern pattern = HandlePattern::focus;
};

/// drawing: made here, line by line; it is never loaded.
enum class PictureSource : std::uint8_t { practice, gallery, stick, camera, drawing };

/// The part of the picture that fills the area, as in vision/simplify/zoom.h.
struct ZoomWanted {
    double factor = 1.0;  // 1, 2 or 4
    Position centre;      // in W of the whole picture

    friend bool operator==(const ZoomWanted&, const ZoomWanted&) = default;
};

/// Answered by PictureReady or PictureFailed with the same request, unless a newer request replaced
/// it.
struct LoadPicture {
    std::uint64_t request = 0;  // counts up
    PictureSource source = PictureSource::practice;
    std::size_t index = 0;     // practice: 0 circle, 1 square; gallery, stick: row; camera: 0
    std::size_t language = 0;  // index of VisitWorld::languages: title, description, parts
    int page = 1;
    int view = 1;
    int detail = 3;  // 1 ... 5
    ZoomWanted zoom;
    /// Feels the whole thing of a photograph at this place of the view; nothing: the view.
    std::optional<Position> thing_at = {};
    NameForm form = {};  // stick: as in its list, so that the picture is called the same

    friend bool operator==(const LoadPicture&, const LoadPicture&) = default;
};

/// The result is no longer wanted; what is felt stays.
struct CancelLoad {
    std::uint64_t request = 0;
};

/// A drawing as it is now, to be felt at once. Answered by PictureReady with the same request.
struct FeelDrawing {
    std::uint64_t request = 0;  // of the drawing
    TactileMap map;             // `drawing` is set; the kiosk numbers the version
};

/// Goes to the servo. The force is wanted while there is a picture to feel.
struct Feel {
    Mode mode = Mode::groove;
    std::size_t stiffness = operators_stiffness;  // index of stiffness_steps
    bool is_force_wanted = false;
    HeldShape shape = HeldShape::none;
    double turn_rad = 0.0;  // the shape's turn, counter-clockwise, if the handle does not turn

    friend bool operator==(const Feel&, const Feel&) = default;
};

/// outline: leads once around the outer line. to_place: takes the handle there. bring_back: leads
/// to the nearest line. stop: ends at once; sent at every key while anything leads.
enum class GuideKind : std::uint8_t { stop, outline, to_place, bring_back };

/// Sent only after the announcement had its time. GuidanceEnded reports its end.
struct Guide {
    GuideKind kind = GuideKind::stop;
    Position place_W;  // for to_place, in the map that is felt
    int outline = -1;  // for outline: index in the map

    friend bool operator==(const Guide&, const Guide&) = default;
};

struct CameraPreview {
    bool is_on = false;
};

struct Capture {};

/// What is felt goes to the site's printer. Answered by SheetEnded; no second one before that.
struct PrintSheet {};

struct GiveStickBack {};  // let go of the stick: no more reading

/// The visit is over: picture, texts, file list and transcript are overwritten.
struct Wipe {};

/// Everything that a visitor chose to hear.
struct SoundWanted {
    std::size_t language = 0;  // index of VisitWorld::languages
    std::size_t volume = 0;    // step of the current output
    std::size_t rate = 3;      // index of speech_rates_per_minute
    CueAmount amount = CueAmount::cues;
    bool is_mono = false;
    bool is_speech_on = true;

    friend bool operator==(const SoundWanted&, const SoundWanted&) = default;
};

/// Everything that a visitor chose for the screen.
struct LookWanted {
    std::size_t text_size = 0;  // 0 ... 3
    std::size_t palette = 0;    // 0 ... 3
    bool is_off = false;        // nothing is drawn: privacy

    friend bool operator==(const LookWanted&, const LookWanted&) = default;
};

/// Holds until the next one.
struct CallStaff {
    bool is_wanted = true;
};

/// The kiosk ends.
struct Quit {};

using VisitOrder =
    std::variant<Utterance, Hush, HoldSpeech, GiveCue, GivePattern, LoadPicture, CancelLoad,
                 FeelDrawing, Feel, Guide, CameraPreview, Capture, PrintSheet, GiveStickBack, Wipe,
                 SoundWanted, LookWanted, CallStaff, Quit>;

using VisitOrders = std::vector<VisitOrder>;

}  // namespace touchline
