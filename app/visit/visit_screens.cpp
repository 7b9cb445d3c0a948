// The screens of every visit but those of a picture, of settings and of a stick: how it begins,
// what can be chosen, how it ends, and what lies over another screen.
#include "app/visit/visit_menu.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

// Beginning.

void write_attract(VisitSheet& sheet) {
    sheet.sentence(way_to_begin(sheet.world));
}

void write_language(VisitSheet& sheet) {
    if (!has_keys(sheet.world)) {
        sheet.sentence(moves_by_itself(sheet.world)
                           ? "Choices are read out in turn; your switch is Select."
                           : "One switch moves on, the other is Select.");
        sheet.sentence("After the last come Repeat, Back and Help.");
    } else {
        sheet.sentence("Choose your language with Up, Down and Select.");
        sheet.sentence("Press Help to try the keys.");
        sheet.sentence("Press any key to interrupt.");
    }
}

void write_languages(VisitSheet& sheet) {
    for (std::size_t row = 0; row < sheet.world.languages.size(); ++row)
        sheet.row(row, sheet.world.languages[row].name());
}

void begin_in_language(VisitWork& work, std::size_t language, const std::string& /*name*/) {
    work.visitor.sound.language = language;
    go_to(work, VisitScreen::choose);
    say_screen(work);
}

// What to feel.

/// Tells the troubles of force and sound, which concern everything; the others are told in their
/// place.
void write_lasting_troubles(VisitSheet& sheet) {
    for (const TroubleKind kind : {TroubleKind::device, TroubleKind::sound}) {
        const auto& trouble = sheet.visit.site.troubles[static_cast<std::size_t>(kind)];
        if (trouble) sheet.told(told_trouble(kind, *trouble, sheet.language));
    }
}

bool has_own_picture(const VisitSheet& sheet) {
    const auto& felt = sheet.visitor().felt;
    return felt && felt->order.source != PictureSource::practice;
}

void write_choose(VisitSheet& sheet) {
    write_lasting_troubles(sheet);
    if (has_own_picture(sheet)) {
        sheet.sentence("Your picture stays until you choose another.");
    } else {
        sheet.sentence("Hold the handle lightly.");
        sheet.sentence("Begin with a practice shape, or choose a picture.");
    }
}

std::string stick_value(const VisitSheet& sheet) {
    const Visitor& visitor = sheet.visitor();
    if (!visitor.has_stick) return sheet.words("not plugged in");
    if (!visitor.stick_list) return sheet.words("being read");
    return sheet.language.counted("count", "{0} picture", "{0} pictures",
                                  static_cast<int>(visitor.stick_list->names.size()));
}

std::string camera_value(const VisitSheet& sheet) {
    return sheet.visit.site.has_camera ? std::string() : sheet.words("not ready");
}

std::string staff_value(const VisitSheet& sheet) {
    return sheet.visit.site.is_staff_called ? sheet.words("called") : std::string();
}

void return_to_picture(VisitWork& work) {
    go_to(work, VisitScreen::picture);
    say_return(work);
}

void practise(VisitWork& work) {
    open_picture(work, PictureSource::practice, 0, {});
}

void call_staff_or_not(VisitWork& work) {
    if (!work.site.is_staff_called) return call_staff(work);
    work.site.is_staff_called = false;
    order(work, CallStaff{false});
    say(work, words(work, "The staff are no longer called."));
}

// The camera, and work under way.

void write_camera(VisitSheet& sheet) {
    if (sheet.visit.site.has_camera) {
        sheet.sentence("Lay your picture on the tray under the camera.");
        sheet.sentence("No photo is taken until you press Select.");
    } else {
        sheet.sentence("The camera does not answer.");
        sheet.sentence("Choose other pictures, or tell the staff.");
    }
}

void capture(VisitWork& work) {
    work.visitor.is_capturing = true;
    work.visitor.farewell.has_picture = true;
    order(work, Capture{});
    enter(work, VisitScreen::opening);
}

void write_opening(VisitSheet& sheet) {
    sheet.title(sheet.visitor().is_capturing ? "The photo is being taken."
                                             : "The picture is being opened.");
    if (sheet.visitor().loading) sheet.told(sheet.visitor().loading->name);
}

// Questions before something is lost.

void reset_settings(VisitWork& work) {
    const Visitor first = new_visitor(work.site, work.world);
    const std::size_t language = work.visitor.sound.language;
    work.visitor.sound = first.sound;
    work.visitor.sound.language = language;  // or the visitor would understand nothing more
    work.visitor.look = first.look;
    work.visitor.feel = first.feel;
    leave(work);
    say_return(work, words(work, "Sound, speech, letters and lines are as at the start."));
}

struct VisitQuestion {
    VisitItem asked;
    const char* title;
    const char* text;
    VisitAct yes;
};

constexpr const char* lost_text = "Your picture and your settings will not be kept here.";

constexpr auto questions = std::to_array<VisitQuestion>(
    {{VisitItem::finish, "Finish?", lost_text,
      [](VisitWork& work) { end_visit(work, VisitScreen::goodbye); }},
     {VisitItem::start_over, "Start over?", lost_text,
      [](VisitWork& work) {
          end_visit(work, VisitScreen::attract);
          begin_visit(work);
      }},
     {VisitItem::reset, "Reset the settings?",
      "Sound, speech, letters and lines will be as at the start.", reset_settings},
     {VisitItem::quit, "Shut the kiosk down?", "Nobody can use it until somebody starts it again.",
      [](VisitWork& work) { order(work, Quit{}); }}});

const VisitQuestion& asked_question(const Visitor& visitor) {
    const auto asked = static_cast<VisitItem>(open_standing(visitor).about);
    const auto* const found = std::ranges::find(questions, asked, &VisitQuestion::asked);
    return found != questions.end() ? *found : questions.back();
}

void write_confirm(VisitSheet& sheet) {
    const VisitQuestion& question = asked_question(sheet.visitor());
    sheet.title(question.title);
    sheet.sentence(question.text);
}

void refuse_question(VisitWork& work) {
    work.visitor.over ? uncover(work) : step_back(work);
}

void ask_to_finish(VisitWork& work) {
    show(work, VisitScreen::confirm, static_cast<int>(VisitItem::finish));
}

// The end.

void write_goodbye(VisitSheet& sheet) {
    const Farewell& farewell = sheet.visitor().farewell;
    if (farewell.is_unanswered) sheet.sentence("Nobody answered, so the visit has ended.");
    if (farewell.felt_count > 0)
        sheet.told(sheet.language.counted("visit", "You felt {0} picture.",
                                          "You felt {0} pictures.", farewell.felt_count));
    if (farewell.has_picture) sheet.sentence("Take your picture from the tray.");
    if (farewell.has_sheet) sheet.sentence("Take your sheet from the printer.");
    if (farewell.awaits_sheet)
        sheet.sentence("Your sheet is still being printed. Wait for it at the printer.");
    if (farewell.failed_sheet) sheet.told(told_of_print(*farewell.failed_sheet, sheet.language));
    if (farewell.has_stick) sheet.sentence("Take your USB stick with you.");
    sheet.sentence("If you brought headphones, take them with you.");
    sheet.sentence("Nothing about you is kept here.");
}

void write_closed(VisitSheet& sheet) {
    const bool is_maintained = sheet.visit.site.opening == SiteOpening::maintenance;
    sheet.title(is_maintained ? "This kiosk is being serviced." : "This kiosk is closed.");
    if (sheet.world.rules.notice.empty()) {
        sheet.sentence("Please come back later.");
    } else {
        sheet.told(sheet.world.rules.notice);
    }
}

// What lies over another screen.

void write_help(VisitSheet& sheet) {
    const bool offers_staff = sheet.world.rules.offers_staff;
    sheet.title(has_keys(sheet.world) ? "Try the keys" : "Help");
    if (!has_keys(sheet.world)) {
        sheet.sentence(moves_by_itself(sheet.world) ? "Repeat, Back and Help come by themselves."
                                                    : "Move on to Repeat, Back or Help.");
        sheet.sentence("Press Select to hear its use.");
        sheet.sentence("Choose Back twice to leave.");
        if (offers_staff) sheet.sentence("Choose Help again to call the staff.");
    } else {
        sheet.sentence("Six keys do everything: Up, Down, Back, Repeat, Select and Help.");
        sheet.sentence("Two more, if there are any, change the volume.");
        sheet.sentence("Each key says its name and its use.");
        sheet.sentence("Press Back twice to leave.");
        if (offers_staff) sheet.sentence("Press Help again to call the staff.");
        write_keys(sheet);
    }
}

/// Counts down.
int seconds_to_answer(const VisitSheet& sheet) {
    const double asked_s = sheet.visit.site.now_s - sheet.visitor().question_s;
    return static_cast<int>(std::ceil(std::max(answer_s(sheet.world.rules) - asked_s, 0.0)));
}

void write_question(VisitSheet& sheet) {
    sheet.sentence(has_keys(sheet.world) ? "Press any key or move the handle to go on."
                                         : "Press a switch or move the handle to go on.");
    sheet.told(sheet.language.counted("visit", "Otherwise your visit ends in {0} second.",
                                      "Otherwise your visit ends in {0} seconds.",
                                      seconds_to_answer(sheet)));
}

void go_on_from_help(VisitWork& work) {
    uncover(work);
}

void give_more_time(VisitWork& work) {
    uncover(work, words(work, "You have more time."));
}

bool is_of_handle(const VisitSheet& sheet) {
    return sheet.visitor().trouble == TroubleKind::device;
}

/// Without the handle's force the visit goes on.
bool can_call_staff(const VisitSheet& sheet) {
    return is_of_handle(sheet) && sheet.world.rules.offers_staff &&
           !sheet.visit.site.is_staff_called;
}

/// The staff are named once: the hint of the first item says how to call them.
void write_trouble(VisitSheet& sheet) {
    sheet.title(is_of_handle(sheet) ? "The handle" : "Something is wrong");
    std::string told = sheet.visitor().error;
    const std::string call = ' ' + sheet.language.text("fault", "Please call the staff.");
    if (can_call_staff(sheet) && told.ends_with(call)) told.resize(told.size() - call.size());
    sheet.told(told);
}

void go_on(VisitWork& work) {
    close_trouble(work);
}

using S = VisitScreen;
using I = VisitItem;

constexpr auto main_screens = std::to_array<VisitScreenRow>({
    {.screen = S::attract,
     .title = "Pictures to feel",
     .write = write_attract,
     .any_key = begin_visit,
     .view = ScreenView::picture},
    {.screen = S::language,
     .title = "Pictures to feel",
     .write = write_language,
     .back = [](VisitWork& work) { end_visit(work, S::goodbye); }},
    {.screen = S::choose, .title = "What to feel", .write = write_choose, .back = ask_to_finish},
    {.screen = S::camera,
     .title = "Camera",
     .write = write_camera,
     .back_item = "Back",
     .view = ScreenView::camera},
    {.screen = S::opening, .write = write_opening, .back = cancel_loading},
    {.screen = S::confirm, .write = write_confirm, .back = refuse_question},
    {.screen = S::goodbye, .title = "Goodbye", .write = write_goodbye, .any_key = begin_visit},
    {.screen = S::closed,
     .write = write_closed,
     .any_key = [](VisitWork& work) { say_screen(work); }},
    {.screen = S::help, .write = write_help, .back = go_on_from_help},
    {.screen = S::question,
     .title = "Are you still there?",
     .write = write_question,
     .any_key = give_more_time},
    {.screen = S::trouble, .write = write_trouble, .back = go_on},
});

constexpr auto main_items = std::to_array<VisitItemRow>({
    {S::language, I::entry, "", VisitList{write_languages, begin_in_language}},
    {S::choose, I::back_to_picture, "Back to the picture", return_to_picture, nullptr,
     has_own_picture, picture_title},
    {S::choose, I::practise, "Practice shape", practise, "A circle shows how a line feels."},
    {S::choose, I::gallery, "Gallery", S::gallery, "The easiest come first.",
     [](const VisitSheet& sheet) { return has_gallery(sheet.world); }},
    {S::choose, I::stick, "Your USB stick", S::stick,
     "Nothing is written to a USB stick. It can be pulled out at any time.",
     [](const VisitSheet& sheet) { return sheet.world.rules.has_stick_port; }, stick_value},
    {S::choose, I::camera, "Camera", S::camera, "Takes a photo of what lies under it.",
     [](const VisitSheet& sheet) { return sheet.world.rules.has_camera; }, camera_value},
    {S::choose, I::draw_for_me, "Draw for me", draw_for_me, "Somebody draws, and you feel it.",
     [](const VisitSheet& sheet) { return sheet.world.settings.offers_drawing; }},
    {S::choose, I::settings, "Settings", S::settings, "Volume, speech, language and letters."},
    {S::choose, I::call_staff, "Call staff", call_staff_or_not, nullptr,
     [](const VisitSheet& sheet) { return sheet.world.rules.offers_staff; }, staff_value},
    {S::choose, I::finish, "Finish", S::confirm, "Ends your visit."},
    {S::camera, I::take_picture, "Take the photo", capture, nullptr,
     [](const VisitSheet& sheet) { return sheet.visit.site.has_camera; }},
    {S::opening, I::cancel, "Cancel", cancel_loading},
    {S::confirm, I::no, "No", refuse_question},
    {S::confirm, I::yes, "Yes", [](VisitWork& work) { asked_question(work.visitor).yes(work); }},
    {S::trouble, I::go_on, "Go on", go_on, "Press Select to go on.",
     [](const VisitSheet& sheet) { return !is_of_handle(sheet); }},
    {S::trouble, I::go_on, "Go on", go_on, "Or press Select to go on without force.",
     [](const VisitSheet& sheet) { return is_of_handle(sheet) && !can_call_staff(sheet); }},
    {S::trouble, I::go_on, "Go on", go_on,
     "Press Down to call staff, or Select to go on without force.",
     [](const VisitSheet& sheet) { return can_call_staff(sheet) && has_keys(sheet.world); }},
    {S::trouble, I::go_on, "Go on", go_on,
     "Move on to call staff. Or press Select to go on without force.",
     [](const VisitSheet& sheet) {
         return can_call_staff(sheet) && !has_keys(sheet.world) && !moves_by_itself(sheet.world);
     }},
    {S::trouble, I::go_on, "Go on", go_on,
     "Call staff comes next. Or press Select to go on without force.",
     [](const VisitSheet& sheet) { return can_call_staff(sheet) && moves_by_itself(sheet.world); }},
    {S::trouble, I::call_staff, "Call staff", call_staff, nullptr, can_call_staff},
});

}  // namespace

void call_staff(VisitWork& work) {
    work.site.is_staff_called = true;
    order(work, CallStaff{true});
    const std::string told = words(work, "The staff have been called. You can carry on meanwhile.");
    if (!work.visitor.over) return say(work, told);
    open_screen(work) == VisitScreen::trouble ? close_trouble(work, told) : uncover(work, told);
}

bool has_gallery(const VisitWorld& world) {
    return !world.gallery.empty() && !world.gallery.front().empty();
}

VisitMenu main_menu() {
    return {main_screens, main_items};
}

}  // namespace touchline
