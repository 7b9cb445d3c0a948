// A step while it is being made: the parts of visit.h share it. Not for others.
// Threads: values; one step's.
#pragma once

#include "app/session/visit.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace touchline {

struct VisitWork {
    Site site;
    Visitor visitor;
    const VisitWorld& world;
    VisitOrders orders;
};

/// In the visitor's language.
[[nodiscard]] const Language& language_of(const VisitWork& work);

[[nodiscard]] Visit visit_of(const VisitWork& work);
[[nodiscard]] VisitScreen open_screen(const VisitWork& work);

/// The screen that has the keys.
[[nodiscard]] Standing& open_standing(VisitWork& work);
[[nodiscard]] SpokenScreen screen_of(const VisitWork& work);

void order(VisitWork& work, VisitOrder order);
void cue(VisitWork& work, ScreenEvent event);
void shake(VisitWork& work, HandlePattern pattern);

/// Becomes the caption. Nothing for an empty text.
void say(VisitWork& work, const std::string& text, SpeechPriority priority = SpeechPriority::text);
/// Waits until what is being said is over; asked for again, this is what is said.
void say_next(VisitWork& work, const std::string& text);
void say_in(VisitWork& work, const Language& language, const std::string& text,
            SpeechPriority priority = SpeechPriority::text);

/// A text of the context "visit" in the visitor's language.
[[nodiscard]] std::string words(const VisitWork& work, const std::string& english,
                                std::initializer_list<std::string_view> values = {});

// Going about (visit_path.cpp). What is said begins with `first` where that is not empty.

/// The open screen: title, text, focused item.
void say_screen(VisitWork& work, const std::string& first = {});

/// Title and focused item: who comes back knows the rest.
void say_return(VisitWork& work, const std::string& first = {});

/// The item that has the focus, in its own language.
void say_item(VisitWork& work, const std::string& first = {});

/// After what is being said: news that nobody asked for just now, and the item that has the focus.
void say_item_next(VisitWork& work, std::string text);

void enter(VisitWork& work, VisitScreen screen, int about = 0, std::size_t focus = 0);
void leave(VisitWork& work);

/// Leaves and says so. Who has practised goes on to the pictures.
void step_back(VisitWork& work);

/// Straight to `screen`, one below choose.
void go_to(VisitWork& work, VisitScreen screen);

/// A new one where the visitor has not heard it yet.
[[nodiscard]] HintSaid& hint_of(Visitor& visitor, const std::string& text);

/// The focus on the item, where the open screen has it.
void focus_on(VisitWork& work, VisitItem item);

/// What went wrong, over all else; `trouble`: what it is about.
void show_trouble(VisitWork& work, const std::string& sentence, std::optional<TroubleKind> trouble);

/// Back to what is under it.
void close_trouble(VisitWork& work, const std::string& first = {});

/// Help or the question is over: to the trouble that it covered, or to the screen.
void uncover(VisitWork& work, const std::string& first = {});

/// `sentence`, or where nobody said it better: what, why and what to do.
[[nodiscard]] std::string told_trouble(TroubleKind kind, const std::string& sentence,
                                       const Language& language);

// Beginning and end (visit_ends.cpp).

/// The screen of the one before is over: nothing of theirs stays, but a stick that is there.
void nobody_is_here(VisitWork& work);

void begin_visit(VisitWork& work);

/// Everything of the visitor is wiped; then `next` is said.
void end_visit(VisitWork& work, VisitScreen next);

/// What every visit begins with.
[[nodiscard]] Visitor new_visitor(const Site& site, const VisitWorld& world);

// The picture (visit_picture.cpp).

void open_picture(VisitWork& work, PictureSource source, std::size_t index,
                  const std::string& name);
void open_again(VisitWork& work, LoadPicture wanted, LoadReason reason);

/// What is being opened, or else what is felt, in the language and detail that hold now.
void open_unasked(VisitWork& work);
void cancel_loading(VisitWork& work);
void take_ready(VisitWork& work, const PictureReady& ready);
void tell_things(VisitWork& work);

/// The main thing that is being opened by itself would be drawn from under the hand, or under
/// another screen. True where there was one.
bool keep_whole(VisitWork& work);
void take_things(VisitWork& work, const ThingsLookedFor& looked);
void take_failed(VisitWork& work, const PictureFailed& failed);

/// Title, the way it is drawn, overview, parts.
[[nodiscard]] std::string told_picture(const VisitWork& work);

/// W of the whole picture, for a place of what is felt.
[[nodiscard]] Position in_whole_picture(const VisitWork& work, Position place_W);

/// Twice around it, or four times where it is in the middle already.
void zoom_around(VisitWork& work, Position place_W, double factor);
void zoom_in_on_part(VisitWork& work, std::size_t part);

/// "On the tail, upper right."
[[nodiscard]] std::string told_place(const VisitWork& work);

// The stick's list (visit_stick.cpp).

/// The letters are those of the rows that the list shows now.
void open_letters(VisitWork& work);

/// `row` of Visitor::letters: the list shows those from now on.
void take_letter(VisitWork& work, std::size_t row);
void show_all_files(VisitWork& work);
void forget_letters(Visitor& visitor);

/// The open list shows the page with this file, which has the focus.
void return_to_file(VisitWork& work, std::size_t row);

// Leading (visit_leading.cpp).

/// Announces; begins when that could be heard (HA-1).
void lead(VisitWork& work, const Guide& guide, const std::string& announcement);

/// Any key. True if anything was under way.
bool stop_leading(VisitWork& work);

void follow_handle(VisitWork& work, const HandleSeen& handle);

/// The name of the part that the hand rests on.
void name_part(VisitWork& work);

// A shape in the hand (visit_shape.cpp).

/// turn_left, turn_right or turn_back.
void turn_shape(VisitWork& work, VisitItem item);

/// Without a word: a knob is felt.
void follow_knob(VisitWork& work, double by_rad);

// Settings (visit_settings.cpp).

struct ValueList {
    std::vector<std::string> names;
    std::size_t chosen = 0;
};

/// Of a setting: its values in the order of the screen.
[[nodiscard]] ValueList values_of(const Visit& visit, const VisitWorld& world, VisitItem setting);
[[nodiscard]] std::string name_of(VisitItem setting, const Language& language);

/// `value` of values_of().
void choose_value(VisitWork& work, VisitItem setting, std::size_t value);
void change_volume(VisitWork& work, int change);
void change_rate(VisitWork& work, int change);
void reset_settings(VisitWork& work);

/// What the operator sets of the feel goes before what the visitor chose: the later word holds.
void follow_settings(VisitWork& work, const Settings& before);

// Keys (visit_keys.cpp, visit_select.cpp) and time (visit_time.cpp).

void press(VisitWork& work, KeyRole role);
void press(VisitWork& work, SpeechKey key);
void press_dead_key(VisitWork& work);
void select(VisitWork& work);
void pass_time(VisitWork& work, double now_s);

inline constexpr int list_page = 10;  // rows of a list on a screen
inline constexpr double hint_after_s = 1.5;
inline constexpr double hint_again_s = 30.0;  // the same one; ten, and as long as other words last
inline constexpr int hint_times = 2;          // in a visit: then it is known
inline constexpr double progress_after_s = 0.3;
inline constexpr double progress_said_after_s = 2.0;
inline constexpr double progress_said_every_s = 4.5;
inline constexpr double private_s = 10.0;  // headphones pulled: then the question is asked
inline constexpr double goodbye_s = 10.0;
inline constexpr double practice_s = 60.0;
inline constexpr double longest_lead_s = 300.0;  // counts as presence no longer
inline constexpr double dwell_s = 0.4;
inline constexpr double quick_m_per_s = 0.08;  // nothing is named while the hand is faster
inline constexpr double attention_every_s = 5.0;

}  // namespace touchline
