// The screens of what is felt, and what their items do.
#include "app/visit/page_place.h"
#include "app/visit/status.h"
#include "app/visit/visit_menu.h"
#include "audio-cues/words/language.h"
#include "config/types/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace touchline {
namespace {

// Facts that decide what is shown.

const PictureFacts& facts_of(const VisitSheet& sheet) {
    return sheet.felt().facts;
}

bool has_outline(const VisitSheet& sheet) {
    return facts_of(sheet).outline_count > 0;
}

bool is_zoomed(const VisitSheet& sheet) {
    return sheet.felt().order.zoom.factor > 1.0;
}

/// The views of what is felt are things of a photograph, not pictures of a page.
bool is_of_things(const VisitSheet& sheet) {
    return facts_of(sheet).place.things == ThingSearch::found;
}

bool is_photo(const VisitSheet& sheet) {
    return sheet.felt().order.source == PictureSource::camera;
}

bool has_view_after(const VisitSheet& sheet) {
    const PagePlace& place = facts_of(sheet).place;
    return place.view + 1 < place.view_count;
}

bool is_before_whole(const VisitSheet& sheet) {
    const PagePlace& place = facts_of(sheet).place;
    return place.view + 1 == place.view_count;
}

bool has_view_before(const VisitSheet& sheet) {
    return facts_of(sheet).place.view > 1;
}

bool has_pages(const VisitSheet& sheet) {
    const PagePlace& place = facts_of(sheet).place;
    return place.page_count > 1 || place.view_count > 1;
}

/// The condition, and that the views are things.
template <bool (*holds)(const VisitSheet&)>
bool of_things(const VisitSheet& sheet) {
    return is_of_things(sheet) && holds(sheet);
}

/// The condition, and that they are pictures of a page.
template <bool (*holds)(const VisitSheet&)>
bool of_page(const VisitSheet& sheet) {
    return !is_of_things(sheet) && holds(sheet);
}

/// A drawing is felt whole, and as it is drawn.
bool is_loaded(const VisitSheet& sheet) {
    return !sheet.visitor().drawing;
}

bool offers_shape(const VisitSheet& sheet) {
    return sheet.world.settings.offers_shapes && has_outline(sheet) && is_loaded(sheet);
}

bool holds_shape(const VisitSheet& sheet) {
    return offers_shape(sheet) && sheet.visitor().feel.shape != HeldShape::none;
}

// Values and texts.

std::string told_zoom(const VisitSheet& sheet) {
    if (!is_zoomed(sheet)) return sheet.words("off");
    const ZoomWanted& zoom = sheet.felt().order.zoom;
    return sheet.language.text("visit", "{0} times larger, {1}",
                               {sheet.language.number(zoom.factor, 0),
                                words_of(place_of(zoom.centre, CueArea{}), sheet.language)});
}

/// The item's name tells enough of a single part.
std::string told_part_count(const VisitSheet& sheet) {
    const auto count = static_cast<int>(facts_of(sheet).parts.size());
    if (count == 1) return {};
    return sheet.language.counted("count", "{0} part", "{0} parts", count);
}

/// What would be undone.
std::string told_last_change(const VisitSheet& sheet) {
    constexpr std::array names{"Enlargement", "Detail", "Kind of line"};  // as FeltBefore
    return sheet.words(names.at(sheet.visitor().before->index()));
}

std::string told_page_place(const VisitSheet& sheet) {
    return words_of(facts_of(sheet).place, sheet.language);
}

/// The turn from the start, the short way round; left is counter-clockwise.
std::string told_turn(double turn_rad, const Language& language) {
    const int left_deg = static_cast<int>(std::lround(std::remainder(degrees(turn_rad), 360.0)));
    if (left_deg == 0) return language.text("visit", "not turned");
    const int turned = std::abs(left_deg);
    return left_deg > 0 ? language.counted("visit", "turned left by {0} degree",
                                           "turned left by {0} degrees", turned)
                        : language.counted("visit", "turned right by {0} degree",
                                           "turned right by {0} degrees", turned);
}

std::string turn_value(const VisitSheet& sheet) {
    return told_turn(sheet.visitor().feel.turn_rad, sheet.language);
}

void write_practice(VisitSheet& sheet) {
    sheet.told(sheet.visitor().felt ? facts_of(sheet).title : std::string());
    sheet.sentence("Move the handle until a line holds it.");
    sheet.sentence("Then follow the line.");
}

void write_picture(VisitSheet& sheet) {
    const PictureFacts& facts = facts_of(sheet);
    sheet.screen.title = picture_title(sheet);
    sheet.screen.title_recording = facts.title_recording;
    if (!is_loaded(sheet)) {
        sheet.sentence("Somebody beside you draws with a mouse or a pen.");
        sheet.sentence("You feel each line once it is finished.");
    }
    sheet.told({facts.description, facts.description_recording});
    sheet.told(words_of(facts.names, sheet.language));
    if (has_outline(sheet) || is_loaded(sheet))
        sheet.told(
            sheet.language.counted("count", "{0} outline", "{0} outlines", facts.outline_count));
    sheet.told(told_page_place(sheet));
    sheet.told(facts.note);
    if (holds_shape(sheet))
        sheet.sentence("You hold a shape. It works once no line goes through it.");
}

const char* hint_of_part(const VisitSheet& sheet) {
    return has_force(sheet.visit.site) ? "Press Select, and the handle guides you to the part."
                                       : no_force_words;
}

void write_parts_text(VisitSheet& sheet) {
    sheet.sentence(hint_of_part(sheet));
}

void write_parts(VisitSheet& sheet) {
    const std::vector<PartFacts>& parts = facts_of(sheet).parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        sheet.row(i, {parts[i].name, parts[i].recording},
                  words_of(place_of(parts[i].middle_W, CueArea{}), sheet.language),
                  hint_of_part(sheet), told_place_among(i + 1, parts.size(), sheet.language));
    }
}

void write_zoom(VisitSheet& sheet) {
    if (is_zoomed(sheet)) sheet.told(sheet.language.text("visit", "Now: {0}.", {told_zoom(sheet)}));
}

void write_parts_to_enlarge(VisitSheet& sheet) {
    const std::vector<PartFacts>& parts = facts_of(sheet).parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        sheet.row(i, {parts[i].name, parts[i].recording}, sheet.words("enlarged"),
                  "Press Select to enlarge it twice, then four times.");
}

void write_pages(VisitSheet& sheet) {
    sheet.title(is_of_things(sheet) ? "How much of the photo" : "Pages");
    sheet.told(sheet.language.text("visit", "Now: {0}.", {told_page_place(sheet)}));
}

// Acts.

void lead_round(VisitWork& work) {
    lead(work, {GuideKind::outline, {}, work.visitor.felt->facts.outer_outline},
         words(work, "The handle will guide you along the outline."));
}

void bring_back(VisitWork& work) {
    lead(work, {GuideKind::bring_back, {}, -1},
         words(work, "The handle will guide you back to a line."));
}

void lead_to_part(VisitWork& work, std::size_t part, const std::string& name) {
    lead(work, {GuideKind::to_place, work.visitor.felt->facts.parts[part].place_W, -1},
         words(work, "The handle will guide you to this part: {0}.", {name}));
}

/// To the pictures of the gallery, if there are any.
void go_on_to_pictures(VisitWork& work) {
    go_to(work, has_gallery(work.world) ? VisitScreen::gallery : VisitScreen::choose);
    say_screen(work);
}

void other_shape(VisitWork& work) {
    const std::size_t shape = work.visitor.felt->order.index == 0 ? 1 : 0;
    open_picture(work, PictureSource::practice, shape, {});
}

void tell_again(VisitWork& work) {
    say(work, told_picture(work));
}

/// Names said before are said again there.
void explore(VisitWork& work) {
    work.visitor.part_said.reset();
    show(work, VisitScreen::explore);
}

/// "On the tail, upper right."
void tell_place(VisitWork& work) {
    const Visitor& visitor = work.visitor;
    const std::string place =
        words_of(place_of(visitor.handle.place_W, CueArea{}), language_of(work));
    if (!visitor.felt || !visitor.handle.part ||
        *visitor.handle.part >= visitor.felt->facts.parts.size())
        return say(work, words(work, "Not on a line. In the picture: {0}.", {place}));
    say(work, words(work, "On: {0}. In the picture: {1}.",
                    {visitor.felt->facts.parts[*visitor.handle.part].name, place}));
}

/// Turns a place of what is felt into W of the whole picture.
Position in_whole_picture(const VisitWork& work, Position place_W) {
    const ZoomWanted& zoom = work.visitor.felt->order.zoom;
    if (zoom.factor <= 1.0) return place_W;
    return zoom.centre + (1.0 / zoom.factor) * place_W;
}

/// Enlarges around the place; 1: the whole picture.
void zoom_around(VisitWork& work, Position place_W, double factor) {
    LoadPicture wanted = work.visitor.felt->order;
    wanted.zoom = {factor, factor > 1.0 ? in_whole_picture(work, place_W) : Position{}};
    open_again(work, wanted, LoadReason::zoom);
}

/// Enlarges twice around the part, or four times if it is in the middle already.
void zoom_in_on_part(VisitWork& work, std::size_t part, const std::string& /*name*/) {
    constexpr double middle_m = 0.002;
    const Position place_W = work.visitor.felt->facts.parts[part].place_W;
    const ZoomWanted& zoom = work.visitor.felt->order.zoom;
    const bool is_in_middle = zoom.factor > 1.0 && std::hypot(place_W.x, place_W.y) < middle_m;
    zoom_around(work, place_W, is_in_middle ? 4.0 : 2.0);
}

template <int factor>
void zoom_here(VisitWork& work) {
    zoom_around(work, work.visitor.handle.place_W, factor);
}

std::size_t chosen_detail(const Visitor& visitor) {
    return static_cast<std::size_t>(std::clamp(visitor.detail, 1, 5) - 1);
}

std::size_t chosen_mode(const Visitor& visitor) {
    return static_cast<std::size_t>(visitor.feel.mode);
}

template <int change>
void step_view(VisitWork& work) {
    const PagePlace& place = work.visitor.felt->facts.place;
    open_view(work, place.page, place.view + change);
    work.visitor.loading->focus = change > 0 ? VisitItem::next_view : VisitItem::view_before;
}

template <int change>
void step_page(VisitWork& work) {
    open_view(work, work.visitor.felt->facts.place.page + change, 1);
    work.visitor.loading->focus = change > 0 ? VisitItem::next_page : VisitItem::page_before;
}

void find_thing_here(VisitWork& work) {
    LoadPicture wanted = work.visitor.felt->order;
    wanted.view = work.visitor.felt->facts.place.view;
    wanted.thing_at = in_whole_picture(work, work.visitor.handle.place_W);
    wanted.zoom = {};
    open_again(work, wanted, LoadReason::thing_here);
}

/// A shape's turn in steps of a key, wherever a knob left it.
void turn_to(VisitWork& work, double (*step_of)(double steps)) {
    constexpr double step_rad = radians(15.0);
    double& turn_rad = work.visitor.feel.turn_rad;
    turn_rad = step_rad * step_of(turn_rad / step_rad);
    say(work, told_turn(turn_rad, language_of(work)));
}

void turn_left(VisitWork& work) {
    turn_to(work, [](double steps) { return std::floor(steps + 1e-6) + 1.0; });
}

void turn_right(VisitWork& work) {
    turn_to(work, [](double steps) { return std::ceil(steps - 1e-6) - 1.0; });
}

void turn_back(VisitWork& work) {
    turn_to(work, [](double /*steps*/) { return 0.0; });
}

bool is_printable(const VisitSheet& sheet) {
    return sheet.world.rules.has_printer && has_outline(sheet);
}

std::string told_printing(const VisitSheet& sheet) {
    const Visitor& visitor = sheet.visitor();
    if (visitor.awaits_sheet) return sheet.words("being printed");
    if (visitor.sheets == 0) return {};
    return sheet.language.counted("visit", "{0} sheet printed", "{0} sheets printed",
                                  visitor.sheets);
}

/// The visit goes on meanwhile.
void print_sheet(VisitWork& work) {
    if (work.visitor.awaits_sheet) return say(work, words(work, "Your sheet is being printed."));
    if (work.site.is_printing)
        return say(work, words(work, "The printer is busy. Please try again in a minute."));
    if (work.visitor.sheets >= most_sheets)
        return say(work, words(work, "One visit can print {0} sheets, and no more.",
                               {language_of(work).number(most_sheets, 0)}));
    if (work.visitor.failed_sheet) return show_failed_sheet(work);  // before another one fails
    work.site.is_printing = true;
    work.visitor.awaits_sheet = true;
    order(work, PrintSheet{});
    say(work, words(work, "Printing. You can carry on meanwhile."));
}

/// Opens the list that the picture came from.
void choose_another(VisitWork& work) {
    const LoadPicture felt = work.visitor.felt->order;
    switch (felt.source) {
        case PictureSource::gallery:
        case PictureSource::stick:
            return_to_row(work, felt.source, felt.index);
            break;
        case PictureSource::camera:
            go_to(work, VisitScreen::camera);
            break;
        case PictureSource::practice:
        case PictureSource::drawing:
            go_to(work, VisitScreen::choose);
            break;
    }
    say_screen(work);
}

// The tables.

std::vector<std::string> stiffness_names(const VisitWorld& /*world*/, const Language& language) {
    std::vector<std::string> names;
    for (const StiffnessStep& step : stiffness_steps)
        names.push_back(language.text("stiffness", std::string(step.name)));
    return names;
}

constexpr NamedValues<5> details{"detail", detail_names};
constexpr NamedValues<4> modes{"mode", mode_names};
constexpr NamedValues<held_shape_count> shapes{"shape", shape_names};

constexpr const char* begin_hint = "Press Select to begin.";
constexpr const char* turn_hint = "Press Select to turn it a little. A knob turns it too.";

using S = VisitScreen;
using I = VisitItem;

constexpr auto picture_screens = std::to_array<VisitScreenRow>({
    {.screen = S::practice,
     .title = "Practice shape",
     .write = write_practice,
     .back_item = "Go on to the pictures",
     .back = go_on_to_pictures,
     .view = ScreenView::picture},
    {.screen = S::picture,
     .write = write_picture,
     .back_item = "Back",
     .view = ScreenView::picture},
    {.screen = S::parts,
     .title = "Parts",
     .write = write_parts_text,
     .back_item = "Back",
     .view = ScreenView::picture},
    {.screen = S::explore,
     .title = "Explore freely",
     .text = "Rest on a line to hear its name.",
     .back_item = "Back",
     .view = ScreenView::picture},
    {.screen = S::zoom,
     .title = "Enlargement",
     .write = write_zoom,
     .back_item = "Back",
     .view = ScreenView::picture},
    {.screen = S::pages, .write = write_pages, .back_item = "Back", .view = ScreenView::picture},
});

constexpr auto picture_items = std::to_array<VisitItemRow>({
    {S::practice, I::lead_round, "Guide me along the outline", lead_round, begin_hint, nullptr,
     nullptr, true},
    {S::practice, I::other_shape, "Another shape", other_shape},
    {S::practice, I::bring_back, "Bring me back to the line", bring_back, nullptr, nullptr, nullptr,
     true},

    {S::picture, I::lead_round, "Guide me along the largest outline", lead_round, begin_hint,
     [](const VisitSheet& sheet) { return facts_of(sheet).outline_count > 1; }, nullptr, true},
    {S::picture, I::lead_round, "Guide me along the outline", lead_round, begin_hint,
     [](const VisitSheet& sheet) { return facts_of(sheet).outline_count == 1; }, nullptr, true},
    {S::picture, I::parts, "Parts", S::parts, "Choose a part, and the handle guides you to it.",
     [](const VisitSheet& sheet) { return !facts_of(sheet).parts.empty(); }, told_part_count, true},
    {S::picture, I::explore, "Explore freely", explore, "Parts say their names."},
    {S::picture, I::bring_back, "Bring me back to a line", bring_back, nullptr, has_outline,
     nullptr, true},
    {S::picture, I::tell_again, "Tell me again", tell_again},
    {S::picture, I::detail, "Detail", VisitSetting{named<details>, {chosen_detail, choose_detail}},
     nullptr, is_loaded},
    {S::picture, I::zoom, "Enlargement", S::zoom, nullptr, is_loaded, told_zoom},
    {S::picture, I::mode, "Kind of line", VisitSetting{named<modes>, {chosen_mode, choose_mode}}},
    {S::picture, I::stiffness, "Firmness",
     VisitSetting{stiffness_names, kept_in<&Visitor::feel, &Feel::stiffness>}},
    {S::picture, I::held_shape, "Shape in the hand",
     VisitSetting{named<shapes>, kept_in<&Visitor::feel, &Feel::shape>},
     "For the curious: lines push and twist it.", offers_shape},
    {S::picture, I::turn_left, "Turn it left", turn_left, turn_hint, holds_shape, turn_value},
    {S::picture, I::turn_right, "Turn it right", turn_right, turn_hint, holds_shape, turn_value},
    {S::picture, I::turn_back, "Turn it back", turn_back, nullptr, holds_shape},
    {S::picture, I::pages, "How much of the photo", S::pages, nullptr, is_of_things},
    {S::picture, I::pages, "Pages", S::pages, nullptr, of_page<has_pages>},
    {S::picture, I::thing_here, "Find the thing under my hand", find_thing_here, nullptr,
     [](const VisitSheet& sheet) {
         return is_of_things(sheet) || facts_of(sheet).place.things == ThingSearch::unclear;
     }},
    {S::picture, I::undo, "Undo the last change", undo, nullptr,
     [](const VisitSheet& sheet) { return sheet.visitor().before.has_value(); }, told_last_change},
    {S::picture, I::print_sheet, "Print to take home", print_sheet,
     "A sheet with its lines and words comes out of the printer.", is_printable, told_printing},
    {S::picture, I::another_picture, "Take another photo", choose_another, nullptr, is_photo},
    {S::picture, I::another_picture, "Another picture", choose_another, nullptr,
     [](const VisitSheet& sheet) { return !is_photo(sheet); }},

    {S::parts, I::entry, "", VisitList{write_parts, lead_to_part}},

    {S::explore, I::where_am_i, "Where am I?", tell_place},
    {S::explore, I::bring_back, "Bring me back to a line", bring_back, nullptr, has_outline,
     nullptr, true},

    {S::zoom, I::whole_picture, "The whole picture", zoom_here<1>, nullptr, is_zoomed},
    {S::zoom, I::twice_here, "Twice as large, around your hand", zoom_here<2>},
    {S::zoom, I::four_times_here, "Four times as large, around your hand", zoom_here<4>},
    {S::zoom, I::entry, "", VisitList{write_parts_to_enlarge, zoom_in_on_part}},

    {S::pages, I::next_view, "The next thing", step_view<+1>, nullptr, of_things<has_view_after>},
    {S::pages, I::next_view, "Next picture of the page", step_view<+1>, nullptr,
     of_page<has_view_after>},
    {S::pages, I::next_view, "The whole photograph", step_view<+1>, nullptr,
     of_things<is_before_whole>},
    {S::pages, I::next_view, "The whole page", step_view<+1>, nullptr, of_page<is_before_whole>},
    {S::pages, I::view_before, "The previous thing", step_view<-1>, nullptr,
     of_things<has_view_before>},
    {S::pages, I::view_before, "The previous picture", step_view<-1>, nullptr,
     of_page<has_view_before>},
    {S::pages, I::next_page, "Go to the next page", step_page<+1>, nullptr,
     [](const VisitSheet& sheet) {
         return facts_of(sheet).place.page < facts_of(sheet).place.page_count;
     }},
    {S::pages, I::page_before, "Go to the previous page", step_page<-1>, nullptr,
     [](const VisitSheet& sheet) { return facts_of(sheet).place.page > 1; }},
});

}  // namespace

void open_view(VisitWork& work, int page, int view) {
    LoadPicture wanted = work.visitor.felt->order;
    wanted.page = page;
    wanted.view = view;
    wanted.zoom = {};
    open_again(work, wanted, LoadReason::other_view);
}

VisitMenu picture_menu() {
    return {picture_screens, picture_items};
}

std::string picture_title(const VisitSheet& sheet) {
    const std::string& title = facts_of(sheet).title;
    if (!title.empty()) return title;
    return sheet.words(is_photo(sheet) ? "Your photo" : "A picture without a name");
}

}  // namespace touchline
