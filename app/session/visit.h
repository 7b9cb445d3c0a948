// The visit: from the attract screen to goodbye, as a pure state machine. What happens comes in as
// an event, what is to be done goes out as orders (visit_orders.h).
// Threads: values and pure functions.
#pragma once

#include "app/session/screen_model.h"
#include "app/session/visit_events.h"
#include "app/session/visit_orders.h"
#include "app/sticks/first_letters.h"
#include "app/sticks/listing.h"
#include "app/sticks/spoken_name.h"
#include "config/settings/settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

enum class VisitScreen : std::uint8_t {
    attract,   // nobody is here
    language,  // each named in itself
    choose,    // what to feel: practice, gallery, stick, camera; settings; finish
    practice,
    gallery,
    stick,
    letters,  // by which the list of the stick is searched
    camera,
    opening,  // work is under way and can be cancelled
    picture,
    parts,
    explore,
    zoom,
    pages,
    settings,
    values,   // of one setting: Standing::about is its item
    confirm,  // Standing::about is the item that asked
    goodbye,
    closed,
    // over any of these
    help,      // each key says its name and use
    question,  // is anybody there?
    trouble,   // what, why, what to do
};

inline constexpr std::size_t visit_screen_count = 22;

/// What an item of a screen stands for (ScreenItem::id). Rows of a list: entry + their number.
enum class VisitItem : int {
    back,
    back_to_picture,
    practise,
    gallery,
    stick,
    camera,
    settings,
    call_staff,
    finish,
    next_ten,
    ten_before,
    letters,
    all_files,
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
    stiffness,
    held_shape,
    turn_left,
    turn_right,
    turn_back,
    pages,
    another_picture,
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
    no,
    yes,
    go_on,
    entry = 1000,
};

/// A screen that is open, with what was left of it when another went over it.
struct Standing {
    VisitScreen screen = VisitScreen::attract;
    std::size_t focus = 0;
    int about = 0;  // first entry of a list's page, item of a setting, what is confirmed

    friend bool operator==(const Standing&, const Standing&) = default;
};

/// A row of the gallery in one language.
struct GalleryTitle {
    std::string title;
    std::string description;
    std::optional<int> difficulty;  // 1 (easy) ... 5
};

/// What the house decides beside Settings; it may change between visits.
struct VisitRules {
    double quiet_s = 90.0;   // 30 ... 1800: then the question is asked
    double answer_s = 30.0;  // 30 or more: then the visit ends
    /// That every visit begins with; the volume is a step of the output that is heard.
    SoundWanted sound = {.language = 0, .volume = 3};
    LookWanted look;
    std::size_t volume_steps = 7;  // of that output, >= 1
    bool has_camera = true;        // the house has one at all
    bool has_stick_port = true;
    bool offers_staff = true;
    std::string notice;  // while closed or maintained, in the house's language; may be empty
};

/// Constant during a step; all may change between steps. `languages` is not empty; `gallery` has
/// a list for each language, all of one length.
struct VisitWorld {
    const std::vector<Language>& languages;
    const Settings& settings;
    const std::vector<std::vector<GalleryTitle>>& gallery;
    const VisitRules& rules;
};

/// Six or more; else one or two switches move through the items and take them.
[[nodiscard]] inline bool has_keys(const VisitWorld& world) {
    return world.settings.two_switches == 0;
}

/// The picture that is felt.
struct KnownPicture {
    LoadPicture order;  // that brought it
    PictureFacts facts;
};

/// Why a loading job is under way: what is said when it ends. unasked: nothing is, for the visitor
/// did not order it; it is the same picture in another language, or in the operator's detail.
/// main_thing: of a photograph that was not touched yet. thing_here: the one under the hand.
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
    std::string name;  // of what is being opened, for who waits; may be empty
};

/// Work that the visitor waits for.
struct Waiting {
    double since_s = 0.0;
    double last_cue_s = 0.0;
    double last_said_s = 0.0;
};

/// What was said last, for captions and for who asks again. Never written anywhere.
struct Caption {
    std::string text;
    std::string language;             // code
    std::optional<ScreenEvent> sign;  // of the last sound: its visual sign
};

/// Something that leads the hand: first announced, then under way.
struct Leading {
    Guide guide;
    double begin_s = 0.0;
    bool has_begun = false;
};

/// Of the house and its things: outlives a visit.
struct Site {
    double now_s = 0.0;
    SiteOpening opening = SiteOpening::open;
    bool has_camera = false;
    bool has_headphones = false;
    std::array<std::optional<std::string>, trouble_count> troubles;  // that last; as told, or empty
    bool is_staff_called = false;
    std::uint64_t request = 0;  // of the last LoadPicture
};

/// What a stick offers: thousands of names, perhaps, so that steps share them.
struct StickList {
    std::vector<std::string> names;  // raw bytes: said by spoken_name() alone
    StickRest rest;
    std::vector<NameForm> forms;  // of each name, so that no two sound alike
};

/// A hint that this visitor has heard.
struct HintSaid {
    std::string text;
    int times = 0;
    double at_s = 0.0;  // the last time

    void said(double now_s) {
        ++times;
        at_s = now_s;
    }
};

/// Of the visitor: a new one for every visit.
struct Visitor {
    std::vector<Standing> path{Standing{}};  // never empty; the last one is open
    std::optional<Standing> over;            // help, question or trouble on top of it
    std::string error;                       // what `trouble` says
    std::optional<TroubleKind> trouble;      // that it is about; none: a picture, a file
    SoundWanted sound;
    LookWanted look;
    Feel feel;
    int detail = 3;  // wanted of the next picture too
    std::optional<KnownPicture> felt;
    bool is_told_shortly = false;  // the rest of it comes with what the search for its things finds
    std::optional<Loading> loading;
    std::optional<Waiting> waiting;
    bool is_capturing = false;
    bool has_stick = false;
    bool has_stick_to_take = false;                           // said on the last screen
    std::shared_ptr<const StickList> stick_list;              // none: not read yet
    std::shared_ptr<const LetterGroup> found;                 // that the list shows; none: all
    std::shared_ptr<const std::vector<LetterGroup>> letters;  // of the screen of that name
    std::optional<Leading> leading;
    HandleSeen handle;
    double part_since_s = 0.0;  // on the part, or on none
    std::optional<std::size_t> part_said;
    bool has_touched = false;        // a line of what is felt
    double active_s = 0.0;           // last key or motion
    double key_s = 0.0;              // last key
    double entered_s = 0.0;          // the screen that is open
    double question_s = 0.0;         // asked
    double attention_s = 0.0;        // the handle last asked for it
    std::optional<double> pulled_s;  // headphones
    bool is_hint_due = false;
    std::vector<HintSaid> hints;
    int dead_keys = 0;  // in a row
    int repeats = 0;    // presses of Repeat in a row
    int helps = 0;      // presses of Help in a row, in help
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

/// Nobody is here yet; orders: what every visit begins with.
[[nodiscard]] VisitStep start_visit(const VisitWorld& world);

/// O(items of a screen). Every key is answered by speech or a cue in the same step.
[[nodiscard]] VisitStep step(const Visit& visit, const VisitEvent& event, const VisitWorld& world);

/// What is drawn and spoken now, in the visitor's language (of the language screen: each item in
/// its own).
[[nodiscard]] SpokenScreen screen_of(const Visit& visit, const VisitWorld& world);

/// The screen that has the keys: the one over the path, else its last.
[[nodiscard]] VisitScreen open_screen(const Visit& visit);

/// Somebody is here: nothing of the visit may be lost, and time-outs run.
[[nodiscard]] bool is_visit_on(const Visit& visit);

[[nodiscard]] const Language& language_of(const Visit& visit, const VisitWorld& world);

}  // namespace touchline
