// A drawing that somebody makes for the visitor, line by line: what the pen and its keys do, what
// is said of it, and what of it the visitor can do alone.
#include "app/visit/visit_menu.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {
namespace {

constexpr double erase_reach_m = 0.005;  // a pen on a screen is no nearer, nor is a fingertip

/// What a refusal tells whoever draws: why, and what to do.
const char* words_of(DrawingRefusal refusal) {
    switch (refusal) {
        case DrawingRefusal::too_short:
            return "That line is too short to be felt.";
        case DrawingRefusal::too_long:
            return "That line was too long and was not taken. Draw it in parts.";
        case DrawingRefusal::scribbled:
            return "That line crosses itself too often and was not taken. Draw it in parts.";
        case DrawingRefusal::full:
            return "That line was not taken, for the drawing is full. Erase another one first.";
        case DrawingRefusal::nothing_near:
            return "No line is near enough. Go closer to one.";
        case DrawingRefusal::nothing_to_undo:
            return "There is nothing to undo.";
        case DrawingRefusal::nothing_to_redo:
            return "There is nothing to bring back.";
    }
    return "";
}

std::string line_name(const Language& language, int number) {
    return language.text("visit", "Line {0}", {std::to_string(number)});
}

/// Not the line's name alone: that is said of a line under the hand.
std::string told_line(const LineChange& change, bool is_drawn, const Language& language) {
    const char* const words = !change.is_there ? "Line {0} is gone."
                              : is_drawn       ? "Line {0} is finished."
                                               : "Line {0} is back.";
    return language.text("visit", words, {std::to_string(change.number)});
}

/// The picture's screen, open or covered, without what covers it; nothing: it is not on the path.
std::optional<Visit> at_picture(const VisitWork& work) {
    Visit visit = visit_of(work);
    std::vector<Standing>& path = visit.visitor.path;
    while (!path.empty() && path.back().screen != VisitScreen::picture) path.pop_back();
    visit.visitor.over.reset();
    if (path.empty()) return std::nullopt;
    return visit;
}

/// Has the next drawing felt. Returns what is said of it.
std::string take_next(VisitWork& work, const Drawing::Or<Drawing>& next, bool is_drawn) {
    if (!next) return words(work, words_of(next.error()));
    const auto change = change_between(*work.visitor.drawing, *next);
    work.visitor.drawing = std::make_shared<const Drawing>(*next);
    feel_drawing(work);
    return change ? told_line(*change, is_drawn, language_of(work)) : std::string();
}

/// Who draws interrupts no word that the visitor is listening to, and keeps the visit alive.
void change_by_pen(VisitWork& work, const Drawing::Or<Drawing>& next, bool is_drawn) {
    work.visitor.active_s = work.site.now_s;
    cue(work, next ? ScreenEvent::news : ScreenEvent::key_refused);
    const std::string told = take_next(work, next, is_drawn);
    if (open_screen(work) == VisitScreen::question) uncover(work);
    say_next(work, told);
}

/// The focus stays on the item that was chosen, or goes to the one that takes it back: never to
/// the one that takes its place on the screen, which may erase.
void keep_focus(VisitWork& work, VisitItem chosen, VisitItem other) {
    const SpokenScreen screen = screen_of(work);
    for (const VisitItem item : {chosen, other}) {
        const auto place = place_of(screen.items, static_cast<int>(item));
        if (!place) continue;
        work.visitor.path.back().focus = *place;
        return;
    }
}

/// The same, chosen by the visitor, who waits for the answer.
void change_by_item(VisitWork& work, const Drawing::Or<Drawing>& next, VisitItem chosen,
                    VisitItem other) {
    if (!next) refuse(work);
    const std::string told = take_next(work, next, false);
    keep_focus(work, chosen, other);
    say_item(work, told);
}

void undo_line(VisitWork& work) {
    change_by_item(work, work.visitor.drawing->undone(), VisitItem::undo_line,
                   VisitItem::redo_line);
}

void redo_line(VisitWork& work) {
    change_by_item(work, work.visitor.drawing->redone(), VisitItem::redo_line,
                   VisitItem::undo_line);
}

void erase_line_here(VisitWork& work) {
    change_by_item(
        work, work.visitor.drawing->without_line_near(work.visitor.handle.place_W, erase_reach_m),
        VisitItem::erase_line, VisitItem::undo_line);
}

bool can_undo(const VisitSheet& sheet) {
    return sheet.visitor().drawing && sheet.visitor().drawing->can_undo();
}

bool can_redo(const VisitSheet& sheet) {
    return sheet.visitor().drawing && sheet.visitor().drawing->can_redo();
}

bool has_line(const VisitSheet& sheet) {
    return sheet.visitor().drawing && !sheet.visitor().drawing->lines().empty();
}

using S = VisitScreen;
using I = VisitItem;

constexpr auto drawing_items = std::to_array<VisitItemRow>({
    {S::picture, I::undo_line, "Undo in the drawing", undo_line, nullptr, can_undo},
    {S::picture, I::redo_line, "Bring back what was undone", redo_line, nullptr, can_redo},
    {S::picture, I::erase_line, "Erase the line under my hand", erase_line_here, nullptr, has_line},
});

}  // namespace

VisitMenu drawing_menu() {
    return {{}, drawing_items};
}

void draw_for_me(VisitWork& work) {
    Visitor& visitor = work.visitor;
    if (visitor.loading) order(work, CancelLoad{visitor.loading->order.request});
    visitor.loading.reset();
    LoadPicture drawn;
    drawn.request = ++work.site.request;
    drawn.source = PictureSource::drawing;
    drawn.index = static_cast<std::size_t>(drawn.request);  // each is another picture
    visitor.felt = KnownPicture{drawn, {}};
    visitor.felt->facts.title = words(work, "A drawing");
    visitor.drawing = std::make_shared<const Drawing>(drawn.request);
    visitor.before.reset();
    visitor.feel.shape = HeldShape::none;  // would have to be put down for every line
    visitor.part_said.reset();
    visitor.handle.part.reset();
    visitor.has_touched = visitor.has_felt = visitor.is_told_shortly = false;
    feel_drawing(work);
    go_to(work, VisitScreen::picture);
    say_screen(work);
}

bool takes_pen(const Visit& visit) {
    const Visitor& visitor = visit.visitor;
    return visitor.drawing != nullptr &&
           std::ranges::any_of(visitor.path, [](const Standing& standing) {
               return standing.screen == VisitScreen::picture;
           });
}

void feel_drawing(VisitWork& work) {
    LoadPicture& felt = work.visitor.felt->order;
    felt.language = work.visitor.sound.language;
    felt.detail = work.visitor.detail;
    const Language& language = language_of(work);
    order(work, FeelDrawing{felt.request, map_of(*work.visitor.drawing, words(work, "A drawing"),
                                                 [&language](int number) {
                                                     return line_name(language, number);
                                                 })});
}

PictureFocus::PictureFocus(VisitWork& work) : work_(work) {
    const auto picture = at_picture(work);
    if (!picture) return;
    const SpokenScreen screen = screen_of(*picture, work.world);
    if (screen.focus) item_ = screen.items[*screen.focus].id;
}

PictureFocus::~PictureFocus() {
    const auto picture = item_ ? at_picture(work_) : std::nullopt;
    if (!picture) return;
    const auto place = place_of(screen_of(*picture, work_.world).items, *item_);
    if (place) work_.visitor.path[picture->visitor.path.size() - 1].focus = *place;
}

void take(VisitWork& work, const PenStroke& stroke) {
    if (!takes_pen(visit_of(work)) || stroke.points_W.empty()) return;
    const PictureFocus focus(work);
    const Drawing& drawing = *work.visitor.drawing;
    const bool is_eraser = std::exchange(work.visitor.is_erasing, false) || stroke.is_eraser;
    if (!is_eraser) return change_by_pen(work, drawing.with_stroke(stroke.points_W), true);
    change_by_pen(work, drawing.without_line_near(stroke.points_W.front(), erase_reach_m), false);
}

/// Half a line is not what was meant, so it is not felt; whoever drew it must know. The next
/// visitor hears nothing of it.
void take(VisitWork& work, const StrokeLost& /*lost*/) {
    if (!is_visit_on(visit_of(work))) return;
    work.visitor.active_s = work.site.now_s;
    cue(work, ScreenEvent::key_refused);
    say_next(work, words(work,
                         "That line was not taken, for the drawing left the screen. "
                         "Draw it again later."));
}

void take(VisitWork& work, const DrawerKeyPressed& pressed) {
    if (!takes_pen(visit_of(work))) return take(work, DeadKeyPressed{});
    const PictureFocus focus(work);
    const Drawing& drawing = *work.visitor.drawing;
    switch (pressed.key) {
        case DrawerKey::undo:
            return change_by_pen(work, drawing.undone(), false);
        case DrawerKey::redo:
            return change_by_pen(work, drawing.redone(), false);
        case DrawerKey::erase:
            break;
    }
    work.visitor.active_s = work.site.now_s;
    work.visitor.is_erasing = true;
    cue(work, ScreenEvent::news);
    say_next(work, words(work, "With the pen, touch the line to erase."));
}

}  // namespace touchline
