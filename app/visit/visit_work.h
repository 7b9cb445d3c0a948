// A step while it is being made, shared by the parts of visit.h. Not for other files.
// Threads: values; one step's.
#pragma once

#include "app/visit/visit.h"
#include "config/types/pinned.h"

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

struct VisitWork {
    Site site;
    Visitor visitor;
    const VisitWorld& world;
    VisitOrders orders;
    bool is_asked = false;    // by what the visitor does: what is said is an answer
    bool is_of_hand = false;  // what is said tells what the hand rests on
};

/// The visitor's language.
[[nodiscard]] const Language& language_of(const VisitWork& work);

[[nodiscard]] Visit visit_of(const VisitWork& work);
[[nodiscard]] VisitScreen open_screen(const VisitWork& work);

/// The screen that has the keys.
[[nodiscard]] const Standing& open_standing(const Visitor& visitor);
[[nodiscard]] Standing& open_standing(VisitWork& work);
[[nodiscard]] SpokenScreen screen_of(const VisitWork& work);

void order(VisitWork& work, VisitOrder order);
void cue(VisitWork& work, ScreenEvent event);
void shake(VisitWork& work, HandlePattern pattern);

/// Answers a key that can do nothing here.
void refuse(VisitWork& work);

/// Says `text` and makes it the caption. Does nothing if it is empty. What nobody asked for is not
/// said again within ten seconds and before the next key; safety messages are.
void say(VisitWork& work, const SpokenText& text, SpeechPriority priority = SpeechPriority::text);
/// Says once more what the caption has.
void say_again(VisitWork& work);

/// Says `text` once what is being said is over. Repeat says it again.
void say_next(VisitWork& work, const SpokenText& text);
void say_in(VisitWork& work, const Language& language, const SpokenText& text,
            SpeechPriority priority = SpeechPriority::text);

/// A text of the context "visit" in the visitor's language.
[[nodiscard]] std::string words(const VisitWork& work, const std::string& english,
                                std::initializer_list<std::string_view> values = {});

// Navigation. What is said begins with `first` unless that is empty.

/// The open screen: title, text, focused item.
void say_screen(VisitWork& work, const std::string& first = {});

/// Title and focused item: whoever comes back knows the rest, and a long recording
/// of the title.
void say_return(VisitWork& work, const std::string& first = {});

/// The item that has the focus, in its own language.
void say_item(VisitWork& work, const SpokenText& first = {});

/// Says, after what is being said, news that nobody asked for just now, and then the item that has
/// the focus.
void say_item_next(VisitWork& work, SpokenText text);

void enter(VisitWork& work, VisitScreen screen, int about = 0, std::size_t focus = 0);
void leave(VisitWork& work);

/// Leaves and says so.
void step_back(VisitWork& work);

/// Opens `screen` directly, one level below choose.
void go_to(VisitWork& work, VisitScreen screen);

/// Adds a new one if the visitor has not heard it yet.
[[nodiscard]] HintSaid& hint_of(Visitor& visitor, const std::string& text);

/// The hint of the item that has the focus; empty if the screen's text says it.
[[nodiscard]] std::string untold_hint(const SpokenScreen& screen);

/// Puts the focus on the item if the open screen has it.
void focus_on(VisitWork& work, VisitItem item);

/// Shows what went wrong, over everything else. `trouble`: what it is about.
void show_trouble(VisitWork& work, const std::string& sentence, std::optional<TroubleKind> trouble);

/// Goes back to what is under it.
void close_trouble(VisitWork& work, const std::string& first = {});

/// Ends help or the question: goes back to the trouble that it covered, or to the screen.
void uncover(VisitWork& work, const std::string& first = {});

/// `sentence`, or, if it is empty, a general one: what, why and what to do.
[[nodiscard]] std::string told_trouble(TroubleKind kind, const std::string& sentence,
                                       const Language& language);

// Beginning and end (visit.cpp).

/// Ends the screen of the visitor before: nothing of theirs stays, except a stick that is plugged
/// in.
void nobody_is_here(VisitWork& work);

void begin_visit(VisitWork& work);

/// Wipes everything of the visitor; then says `next`.
void end_visit(VisitWork& work, VisitScreen next);

/// The state that every visit begins with.
[[nodiscard]] Visitor new_visitor(const Site& site, const VisitWorld& world);

// The picture (visit_picture.cpp).

void open_picture(VisitWork& work, PictureSource source, std::size_t index,
                  const std::string& name);
void open_again(VisitWork& work, LoadPicture wanted, LoadReason reason);

// `value`: the index of its name on the screen.
void choose_detail(VisitWork& work, std::size_t value);
void choose_mode(VisitWork& work, std::size_t value);

/// Takes the last change back (Visitor::before), and says so. Once more, and the change holds
/// again.
void undo(VisitWork& work);

/// Opens again what is being opened, or else what is felt, in the current language and detail.
void open_unasked(VisitWork& work);
void cancel_loading(VisitWork& work);
void tell_things(VisitWork& work);

/// Cancels the main thing that is being opened unasked: it would replace the picture under the
/// hand, or under another screen. True if there was one.
bool keep_whole(VisitWork& work);

/// Title, how it is drawn, overview, parts.
[[nodiscard]] SpokenText told_picture(const VisitWork& work);

// A drawing (visit_drawing.cpp).

/// While it lives, items of the picture's screen come and go; then the item that had the focus has
/// it again, if it is still there: what somebody else does moves no focus.
class PictureFocus : private Pinned {
  public:
    explicit PictureFocus(VisitWork& work);
    ~PictureFocus();

  private:
    VisitWork& work_;
    std::optional<int> item_;
};

/// Begins a new one.
void draw_for_me(VisitWork& work);

/// Has the drawing felt as it is now, its lines named in the visitor's language.
void feel_drawing(VisitWork& work);

/// Calls the staff, and goes back to what help, the question or a trouble of the handle covers
/// (visit_screens.cpp).
void call_staff(VisitWork& work);

// The lists of pictures (visit_lists.cpp).

/// Opens the list, and each part in it, down to the picture of this LoadPicture::index, which has
/// the focus. `source`: gallery or stick.
void return_to_row(VisitWork& work, PictureSource source, std::size_t number);

/// Called when the list becomes another one: whoever is in a part of it is in all of it then.
void leave_parts_of_stick(Visitor& visitor);

/// How long the visit waits for an answer to its question (visit_time.cpp).
[[nodiscard]] double answer_s(const VisitRules& rules);

/// How nobody's visit begins (visit_time.cpp).
[[nodiscard]] const char* way_to_begin(const VisitWorld& world);

/// Counts the picture as felt: a hand moved on a line of it, or was led all the way round.
void note_felt(Visitor& visitor);

/// Shows why the sheet did not come (visit_time.cpp).
void show_failed_sheet(VisitWork& work);

// Leading (visit_time.cpp).

inline constexpr const char* no_force_words = "The handle has no force now. Move it yourself.";

/// False while a trouble of the handle lasts: then nothing can lead.
[[nodiscard]] bool has_force(const Site& site);

/// Announces the guide, and begins after the time to hear it (HA-1).
void lead(VisitWork& work, const Guide& guide, const std::string& announcement);

/// Called at any key. True if anything was under way.
bool stop_leading(VisitWork& work);

// Keys and events.

/// Does what the item that has the focus says (visit_menu.cpp).
void select(VisitWork& work);

// What happens, beside what visit.cpp takes itself.
void take(VisitWork& work, const Tick& tick);       // visit_time.cpp
void take(VisitWork& work, const KeyPressed& key);  // visit_keys.cpp
/// Up and Down go through a list in larger steps while they are held. A key that is held by a thing
/// is no visitor: it keeps no visit alive.
void take(VisitWork& work, const KeyHeld& held);
void take(VisitWork& work, const SpeechKeyPressed& key);
void take(VisitWork& work, const DeadKeyPressed& key);
void take(VisitWork& work, const HandleSeen& handle);
/// Whoever turns pages is there. It does not stop a handle that leads: whoever is led may read.
void take(VisitWork& work, const LineRead& read);
void take(VisitWork& work, const PenStroke& stroke);  // visit_drawing.cpp
void take(VisitWork& work, const StrokeLost& lost);
void take(VisitWork& work, const DrawerKeyPressed& key);
/// Turns a held shape. Says nothing: the hand feels a knob turn.
void take(VisitWork& work, const KnobTurned& knob);
void take(VisitWork& work, const PictureReady& ready);  // visit_picture.cpp
void take(VisitWork& work, const ThingsLookedFor& looked);
void take(VisitWork& work, const PictureFailed& failed);
/// Applies the operator's changes to the feel over the visitor's choices: the later change holds.
void take(VisitWork& work, const SettingsChanged& change);  // visit_settings.cpp

}  // namespace touchline
