// The visit, from the attract screen to goodbye, as a pure state machine. Events come in, and
// orders (visit_orders.h) go out.
// Threads: values and pure functions.
#pragma once

#include "app/documents/drawing/drawing.h"
#include "app/documents/sticks/listing.h"
#include "app/documents/sticks/spoken_name.h"
#include "app/visit/screen_model.h"
#include "app/visit/visit_events.h"
#include "app/visit/visit_orders.h"
#include "config/settings/settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace touchline {

enum class VisitScreen : std::uint8_t {
    attract,   // nobody is here
    language,  // each named in itself
    choose,    // what to feel: practice, gallery, stick, camera; settings; finish
    practice,
    gallery,
    stick,
    camera,
    opening,  // work is under way and can be cancelled
    picture,
    parts,
    explore,
    zoom,
    pages,
    settings,
    values,   // of one setting; Standing::about is its item
    confirm,  // Standing::about is the item that asked; over any screen: the operator's key
    goodbye,
    closed,
    // over any of these
    help,      // each key says its name and use
    question,  // is anybody there?
    trouble,   // what, why, what to do
};

inline constexpr std::size_t visit_screen_count = 21;

/// What an item of a screen stands for (ScreenItem::id). Rows of a list: entry + their number.
enum class VisitItem : int {
    back,
    back_to_picture,
    practise,
    gallery,
    stick,
    camera,
    draw_for_me,
    settings,
    call_staff,
    finish,
    take_picture,
    cancel,
    lead_round,
    parts,
    explore,
    bring_back,
    tell_again,
    detail,
    zoom,
    thing_here,
    mode,
    undo,
    stiffness,
    held_shape,
    turn_left,
    turn_right,
    turn_back,
    undo_line,
    redo_line,
    erase_line,
    pages,
    print_sheet,
    another_picture,
    next_picture,
    picture_before,
    other_shape,
    where_am_i,
    whole_picture,
    twice_here,
    four_times_here,
    next_view,
    view_before,
    next_page,
    page_before,
    language,
    volume,
    rate,
    sounds,
    mono,
    speech,
    text_size,
    palette,
    screen,
    start_over,
    reset,
    quit,
    no,
    yes,
    go_on,
    entry = 1000,
};

/// An open screen, and its state while another screen covers it.
struct Standing {
    VisitScreen screen = VisitScreen::attract;
    std::size_t focus = 0;
    int about = 0;  // first row of a list's part, item of a setting, what is confirmed
    int end = 0;    // end of a list's part; 0: the whole list

    friend bool operator==(const Standing&, const Standing&) = default;
};

/// A row of the gallery in one language.
struct GalleryTitle {
    std::string title;
    std::string description;
    std::optional<int> difficulty;           // 1 (easy) ... 5
    VoiceRecordingPtr title_recording = {};  // null: nobody recorded it
};

/// The site's rules beside Settings. They may change between visits.
struct VisitRules {
    double inactivity_s = 90.0;  // 30 ... 1800; then the kiosk asks the question
    double answer_s = 30.0;      // 30 or more; then the visit ends
    /// What every visit begins with. The volume is a step of the current output.
    SoundWanted sound = {.language = 0, .volume = 3};
    LookWanted look;
    std::size_t volume_steps = 7;  // of the current output, >= 1
    bool has_camera = true;        // whether the site has a camera at all
    bool has_stick_port = true;
    bool has_printer = false;  // for sheets to take home
    bool offers_staff = true;
    bool is_operator_in = false;  // a visit under way is silent, and keeps its news
    bool invites = false;         // while nobody is here, says every so often how to begin
    std::string notice;  // while closed or under maintenance, in the site's language; may be empty
};

/// Constant during a step; everything may change between steps. `languages` is not empty. `gallery`
/// has one list for each language, all of the same length.
struct VisitWorld {
    const std::vector<Language>& languages;
    const Settings& settings;
    const std::vector<std::vector<GalleryTitle>>& gallery;
    const VisitRules& rules;
};

/// True if the kiosk has six or more keys. Otherwise one or two switches move through the items and
/// select them.
[[nodiscard]] inline bool has_keys(const VisitWorld& world) {
    return world.settings.two_switches == SwitchUse::none;
}

/// True with a single switch: the visitor can only wait for an item and select it.
[[nodiscard]] inline bool moves_by_itself(const VisitWorld& world) {
    return world.settings.two_switches == SwitchUse::by_itself;
}

/// The picture that is felt.
struct KnownPicture {
    LoadPicture order;  // the order that brought it
    PictureFacts facts;
};

/// What the last change replaced: the enlargement, the detail or the kind of line.
using FeltBefore = std::variant<ZoomWanted, int, Mode>;

/// Why a loading job is under way; decides what is said when it ends. unasked: nothing is said,
/// because the visitor did not order it; it is the same picture in another language or in the
/// operator's detail. main_thing: the main thing of a photograph that was not touched yet.
/// thing_here: the thing under the hand.
enum class LoadReason : std::uint8_t {
    other_picture,
    other_view,
    detail,
    zoom,
    main_thing,
    thing_here,
    unasked
};

struct Loading {
    LoadPicture order;
    LoadReason reason = LoadReason::other_picture;
    std::string name;  // what is being opened, for the waiting visitor; may be empty
    std::optional<VisitItem> focus = {};  // then, if the screen has it; nothing: the first
};

/// Work that the visitor waits for.
struct Waiting {
    double since_s = 0.0;
    double last_cue_s = 0.0;
    double last_said_s = 0.0;
};

/// The most sheets of one visit: swell paper is dear, and a tray is soon empty.
inline constexpr int most_sheets = 3;

/// What was said last, for captions and for repeating it. Never written to disk or to a log.
struct Caption {
    std::string text;
    std::string language;                     // its code
    std::optional<ScreenEvent> sign;          // the visual sign of the last sound
    std::vector<RecordedSpan> recorded = {};  // of the text
};

/// A guide that leads the hand: first announced, then under way.
struct Leading {
    Guide guide;
    double begin_s = 0.0;
    bool has_begun = false;
};

/// What a stick offers. The steps share it, for it may hold thousands of names.
struct StickList {
    std::vector<std::string> names;  // raw bytes: only spoken_name() may say them
    StickRest rest;
    std::vector<NameForm> forms;       // one for each name, so that no two sound alike
    std::vector<std::string> letters;  // one for each name: where people look for it
};

/// The state of the site and its hardware. It outlives a visit.
struct Site {
    double now_s = 0.0;
    SiteOpening opening = SiteOpening::open;
    bool has_camera = false;
    bool has_headphones = false;
    std::array<std::optional<std::string>, trouble_count> troubles;  // that last; as told, or empty
    bool is_staff_called = false;
    bool is_printing = false;                // a sheet, of this visitor or of one before
    std::shared_ptr<const StickList> given;  // offered in a stick's place while there is none
    std::uint64_t request = 0;               // of the last LoadPicture
    double invited_s = 0.0;                  // when somebody who may be near was last invited
    std::size_t invitations = 0;             // so far
};

/// A hint that this visitor has heard. After two times, or once they did what it says, it is known.
struct HintSaid {
    std::string text;
    int times = 0;
    double at_s = 0.0;  // the last time

    void said(double now_s) {
        ++times;
        at_s = now_s;
    }

    void learn() { times = 2; }

    [[nodiscard]] bool is_known() const { return times >= 2; }
};

/// Words that this visitor heard a moment ago.
struct SaidLately {
    std::string language;  // its code
    std::string text;
    double at_s = 0.0;
};

/// What the last screen tells of the visit.
struct Farewell {
    int felt_count = 0;                    // pictures
    bool has_stick = false;                // to take along
    bool has_picture = false;              // on the camera's tray
    bool has_sheet = false;                // in the printer
    bool awaits_sheet = false;             // it is on its way there
    std::optional<PrintEnd> failed_sheet;  // not told yet
    bool is_unanswered = false;            // nobody said that they were there
};

/// The state of one visitor; every visit begins with a new one.
struct Visitor {
    std::vector<Standing> path{Standing{}};  // never empty; the last one is open
    std::optional<Standing> over;            // help, a question or trouble, on top of the path
    std::string error;                       // what `trouble` says
    std::optional<TroubleKind> trouble;      // what it is about; none: a picture or a file
    SoundWanted sound;
    LookWanted look;
    Feel feel;
    int detail = 3;  // for the next picture too
    std::optional<KnownPicture> felt;
    std::shared_ptr<const Drawing> drawing;  // what is felt, if somebody draws it; else null
    bool is_erasing = false;                 // the next stroke erases
    std::optional<FeltBefore> before;        // one step back from what is felt; none: no change yet
    std::vector<std::pair<PictureSource, std::size_t>> pictures_felt;  // by a hand that moved
    bool is_told_shortly = false;  // the rest follows when the search for its things ends
    std::optional<Loading> loading;
    std::optional<Waiting> waiting;
    bool is_capturing = false;
    bool awaits_sheet = false;             // that is being printed
    int sheets = 0;                        // printed in this visit
    int sheet_news = 0;                    // how often the last one is still to be told
    std::optional<double> sheet_told_s;    // when it was told; none: not yet
    std::optional<PrintEnd> failed_sheet;  // still to be told
    bool has_stick = false;
    Farewell farewell;
    std::shared_ptr<const StickList> stick_list;  // none: not read yet
    std::optional<Leading> leading;
    HandleSeen handle;
    double part_since_s = 0.0;  // since the hand is on this part, or on none
    std::optional<std::size_t> part_said;
    bool has_moved = false;          // whether the handle moved since the open screen was entered
    bool has_touched = false;        // whether the hand touched a line of this picture
    bool has_felt = false;           // whether a hand moved on one, whatever was opened since
    double active_s = 0.0;           // last key or motion
    double key_s = 0.0;              // last key
    double listens_until_s = 0.0;    // the recordings that were begun last end
    double entered_s = 0.0;          // when the open screen was entered
    double question_s = 0.0;         // when it was asked
    double attention_s = 0.0;        // when the handle last asked for attention
    std::optional<double> pulled_s;  // when the headphones were pulled out
    bool is_hint_due = false;
    std::vector<HintSaid> hints;
    std::vector<SaidLately> said;
    int dead_keys = 0;                // in a row
    int repeats = 0;                  // presses of Repeat in a row
    std::optional<KeyRole> last_key;  // none: no key yet, or one without a meaning
    Caption caption;
};

struct Visit {
    Site site;
    Visitor visitor;
};

struct VisitStep {
    Visit visit;
    VisitOrders orders;
};

/// The state before anybody is here. The orders are those that every visit begins with.
[[nodiscard]] VisitStep start_visit(const VisitWorld& world);

/// O(items of a screen). Every key is answered by speech or a cue in the same step.
[[nodiscard]] VisitStep step(const Visit& visit, const VisitEvent& event, const VisitWorld& world);

/// What is drawn and spoken now, in the visitor's language. On the language screen each item is in
/// its own language.
[[nodiscard]] SpokenScreen screen_of(const Visit& visit, const VisitWorld& world);

/// The screen that has the keys: the one over the path, or else the last of the path.
[[nodiscard]] VisitScreen open_screen(const Visit& visit);

/// True while somebody is here: nothing of the visit may be lost, and time-outs run.
[[nodiscard]] bool is_visit_on(const Visit& visit);

/// True while a drawing is open, also under another screen such as the values of a setting, and the
/// pen may draw: Visitor::drawing has a value.
[[nodiscard]] bool takes_pen(const Visit& visit);

[[nodiscard]] const Language& language_of(const Visit& visit, const VisitWorld& world);

/// In which an item of the open screen is said: a language in itself, all else in the visitor's.
[[nodiscard]] const Language& language_of_item(const Visit& visit, const ScreenItem& item,
                                               const VisitWorld& world);

}  // namespace touchline
