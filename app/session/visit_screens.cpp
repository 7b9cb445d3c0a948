// Every screen in words: titles, texts and items, in the visitor's language.
#include "app/session/screen_writer.h"
#include "audio-cues/words/guidance_words.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

using Sheet = ScreenWriter;

const Visitor& visitor_of(const Sheet& sheet) {
    return sheet.visit.visitor;
}

void put_attract(Sheet& sheet) {
    sheet.title("Pictures to feel");
    sheet.sentence("Hold the handle, or press any key.");
}

void put_language(Sheet& sheet) {
    sheet.title("Pictures to feel");
    if (!has_keys(sheet.world)) {
        const bool is_one = sheet.world.settings.two_switches == SwitchUse::by_itself;
        sheet.sentence(is_one ? "It moves on by itself; your switch is Select."
                              : "One switch moves on, the other is Select.");
        sheet.sentence("After the last item come Repeat, Back and Help.");
    } else {
        sheet.sentence("Choose your language with Up, Down and Select.");
        sheet.sentence("Press Help to try the keys.");
        sheet.sentence("Press any key to interrupt.");
    }
    for (std::size_t row = 0; row < sheet.world.languages.size(); ++row) {
        sheet.row(row, sheet.world.languages[row].name());
    }
}

std::string stick_value(const Sheet& sheet) {
    const Visitor& visitor = visitor_of(sheet);
    if (!visitor.has_stick) return sheet.words("none");
    if (!visitor.stick_list) return sheet.words("being read");
    return sheet.language.counted("count", "{0} picture", "{0} pictures",
                                  static_cast<int>(visitor.stick_list->names.size()));
}

/// Tells the troubles of force and sound, which concern everything; the others are told in their
/// place.
void put_lasting_troubles(Sheet& sheet) {
    for (const TroubleKind kind : {TroubleKind::device, TroubleKind::sound}) {
        const auto& trouble = sheet.visit.site.troubles[static_cast<std::size_t>(kind)];
        if (trouble) sheet.told(told_trouble(kind, *trouble, sheet.language));
    }
}

void put_choose(Sheet& sheet) {
    const Visitor& visitor = visitor_of(sheet);
    const VisitRules& rules = sheet.world.rules;
    sheet.title("What to feel");
    put_lasting_troubles(sheet);
    const bool has_practised =
        visitor.felt && visitor.felt->order.source == PictureSource::practice;
    if (visitor.felt && !has_practised) {
        sheet.sentence("Your picture stays until you choose another.");
        sheet.item(VisitItem::back_to_picture, "Back to the picture", picture_title(sheet));
    } else {
        sheet.sentence("Hold the handle lightly.");
        sheet.sentence("Begin with a practice shape, or choose a picture.");
    }
    sheet.item(VisitItem::practise, "Practice shape", {}, "A circle shows how a line feels.");
    if (!gallery_of(sheet).empty()) {
        sheet.item(VisitItem::gallery, "Gallery", {}, "The easiest come first.");
    }
    if (rules.has_stick_port) {
        sheet.item(VisitItem::stick, "Your USB stick", stick_value(sheet),
                   "Nothing is written to it. You can pull it out at any time.");
    }
    if (rules.has_camera) {
        sheet.item(VisitItem::camera, "Camera",
                   sheet.visit.site.has_camera ? std::string() : sheet.words("not ready"),
                   "Takes a photo of what lies under it.");
    }
    sheet.item(VisitItem::settings, "Settings", {}, "Volume, speech, language and letters.");
    if (rules.offers_staff) {
        sheet.item(VisitItem::call_staff, "Call staff",
                   sheet.visit.site.is_staff_called ? sheet.words("called") : std::string());
    }
    sheet.item(VisitItem::finish, "Finish", {}, "Ends your visit.");
}

void put_practice(Sheet& sheet) {
    sheet.title("Practice shape");
    sheet.told(visitor_of(sheet).felt ? visitor_of(sheet).felt->facts.title : std::string());
    sheet.sentence("Move the handle until a line holds it.");
    sheet.sentence("Then follow the line.");
    sheet.item(VisitItem::lead_round, "Guide me round the outline", {}, "Press Select to begin.");
    sheet.item(VisitItem::other_shape, "Another shape");
    sheet.item(VisitItem::bring_back, "Bring me back to the line");
    sheet.back("Go on to the pictures");
}

void put_gallery(Sheet& sheet) {
    static constexpr std::array grades{"very easy", "easy", "medium", "hard", "very hard"};
    sheet.title("Gallery");
    std::vector<ListRow> rows;
    for (const std::size_t number : gallery_order(sheet)) {
        const GalleryTitle& picture = gallery_of(sheet)[number];
        std::string value;
        if (picture.difficulty) {
            value = sheet.words(
                grades[static_cast<std::size_t>(std::clamp(*picture.difficulty, 1, 5) - 1)]);
        }
        rows.push_back({number, picture.title, value});
    }
    sheet.list(rows, "Press Select to open it.");
    sheet.back();
}

void put_camera(Sheet& sheet) {
    sheet.title("Camera");
    sheet.screen.view = ScreenView::camera;
    if (sheet.visit.site.has_camera) {
        sheet.sentence("Lay your picture on the tray under the camera.");
        sheet.sentence("No photo is taken until you press Select.");
    } else {
        sheet.sentence("The camera does not answer.");
        sheet.sentence("Choose other pictures, or tell the staff.");
    }
    sheet.item(VisitItem::take_picture, "Take the photo");
    sheet.back();
}

void put_opening(Sheet& sheet) {
    const Visitor& visitor = visitor_of(sheet);
    sheet.title(visitor.is_capturing ? "The photo is being taken."
                                     : "The picture is being opened.");
    if (visitor.loading) sheet.told(visitor.loading->name);
    sheet.item(VisitItem::cancel, "Cancel");
}

void put_settings(Sheet& sheet) {
    const Visitor& visitor = visitor_of(sheet);
    sheet.title("Settings");
    for (const VisitItem setting :
         {VisitItem::volume, VisitItem::rate, VisitItem::language, VisitItem::sounds}) {
        sheet.setting(setting);
    }
    sheet.toggle(VisitItem::mono, "The same in both ears", visitor.sound.is_mono);
    sheet.toggle(VisitItem::speech, "Speech", visitor.sound.is_speech_on);
    sheet.setting(VisitItem::text_size);
    sheet.setting(VisitItem::palette);
    sheet.toggle(VisitItem::screen, "Screen", !visitor.look.is_off,
                 "When it is off, nobody can read along.");
    sheet.item(VisitItem::reset, "Reset the settings");
    sheet.item(VisitItem::start_over, "Start over", {}, "Ends your visit and begins a new one.");
    sheet.back();
}

void put_values(Sheet& sheet) {
    const auto setting = static_cast<VisitItem>(visitor_of(sheet).path.back().about);
    const ValueList list = values_of(sheet.visit, sheet.world, setting);
    sheet.screen.title = name_of(setting, sheet.language);
    for (std::size_t row = 0; row < list.names.size(); ++row) {
        sheet.row(row, list.names[row], row == list.chosen ? sheet.words("chosen") : std::string());
    }
}

void put_confirm(Sheet& sheet) {
    const auto asked = static_cast<VisitItem>(visitor_of(sheet).path.back().about);
    if (asked == VisitItem::reset) {
        sheet.title("Reset the settings?");
        sheet.sentence("Sound, speech, letters and lines will be as at the start.");
    } else {
        sheet.title(asked == VisitItem::finish ? "Finish?" : "Start over?");
        sheet.sentence("Your picture and your settings will not be kept here.");
    }
    sheet.item(VisitItem::no, "No");
    sheet.item(VisitItem::yes, "Yes");
}

void put_goodbye(Sheet& sheet) {
    sheet.title("Goodbye");
    if (sheet.visit.visitor.has_stick_to_take) sheet.sentence("Take your USB stick with you.");
    sheet.sentence("If you brought headphones, take them with you.");
    sheet.sentence("Nothing about you is kept here.");
}

void put_closed(Sheet& sheet) {
    const bool is_maintained = sheet.visit.site.opening == SiteOpening::maintenance;
    sheet.title(is_maintained ? "This kiosk is being serviced." : "This kiosk is closed.");
    if (sheet.world.rules.notice.empty()) {
        sheet.sentence("Please come back later.");
    } else {
        sheet.told(sheet.world.rules.notice);
    }
}

void put_help(Sheet& sheet) {
    sheet.title("Try the keys");
    if (!has_keys(sheet.world)) {
        sheet.sentence("Move on to Repeat, Back or Help.");
        sheet.sentence("Press Select to hear its use.");
        sheet.sentence("Choose Help twice to go back.");
    } else {
        sheet.sentence("Each key says its name and its use.");
        sheet.sentence("Press Help twice to go back.");
    }
}

void put_question(Sheet& sheet) {
    sheet.title("Are you still there?");
    sheet.sentence(has_keys(sheet.world) ? "Press any key to go on." : "Press a switch to go on.");
    sheet.told(sheet.language.text(
        "visit", "Otherwise your visit ends in {0} seconds.",
        {sheet.language.number(std::max(sheet.world.rules.answer_s, 30.0), 0)}));
}

/// Without the handle's force the visit goes on.
void put_trouble(Sheet& sheet) {
    const Visitor& visitor = visitor_of(sheet);
    const bool is_of_handle = visitor.trouble == TroubleKind::device;
    sheet.title(is_of_handle ? "The handle" : "Something is wrong");
    sheet.told(visitor.error);
    const bool offers_staff =
        is_of_handle && sheet.world.rules.offers_staff && !sheet.visit.site.is_staff_called;
    const char* how = "Press Select to go on.";
    if (is_of_handle) how = "Or press Select to go on without force.";
    if (offers_staff) {
        how = has_keys(sheet.world)
                  ? "Press Down to call staff, or Select to go on without force."
                  : "Move on to call staff. Or press Select to go on without force.";
    }
    sheet.item(VisitItem::go_on, "Go on", {}, how);
    if (offers_staff) sheet.item(VisitItem::call_staff, "Call staff");
}

using Put = void (*)(Sheet&);

// In the order of VisitScreen.
constexpr std::array<Put, visit_screen_count> puts{
    put_attract, put_language, put_choose,   put_practice, put_gallery, put_stick,
    put_letters, put_camera,   put_opening,  put_picture,  put_parts,   put_explore,
    put_zoom,    put_pages,    put_settings, put_values,   put_confirm, put_goodbye,
    put_closed,  put_help,     put_question, put_trouble};

bool has_picture(VisitScreen screen) {
    return screen == VisitScreen::practice || screen == VisitScreen::picture ||
           screen == VisitScreen::parts || screen == VisitScreen::explore ||
           screen == VisitScreen::zoom || screen == VisitScreen::pages;
}

}  // namespace

SpokenScreen screen_of(const Visit& visit, const VisitWorld& world) {
    const Visitor& visitor = visit.visitor;
    const Standing& open = visitor.over ? *visitor.over : visitor.path.back();
    ScreenWriter sheet{visit, world, language_of(visit, world), {}};
    puts[static_cast<std::size_t>(open.screen)](sheet);
    if (!sheet.screen.items.empty()) {
        sheet.screen.focus = std::min(open.focus, sheet.screen.items.size() - 1);
    }
    sheet.mind_the_only_item();
    const VisitScreen beneath = visitor.path.back().screen;
    if (has_picture(beneath)) sheet.screen.view = ScreenView::picture;
    return sheet.screen;
}

}  // namespace touchline
