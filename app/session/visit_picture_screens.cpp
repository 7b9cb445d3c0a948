// The screens of a picture that is felt, in words.
#include "app/session/page_words.h"
#include "app/session/screen_writer.h"
#include "audio-cues/words/guidance_words.h"
#include "audio-cues/words/thing_words.h"

namespace touchline {
namespace {

std::string told_zoom(const ScreenWriter& sheet) {
    const ZoomWanted& zoom = sheet.visit.visitor.felt->order.zoom;
    if (zoom.factor <= 1.0) return sheet.words("off");
    return sheet.language.text("visit", "{0} times larger, {1}",
                               {sheet.language.number(zoom.factor, 0),
                                words_of(place_of(zoom.centre, CueArea{}), sheet.language)});
}

void put_told(ScreenWriter& sheet) {
    const PictureFacts& facts = sheet.visit.visitor.felt->facts;
    sheet.told(facts.description);
    sheet.told(words_of(facts.names, sheet.language));
    sheet.told(sheet.language.counted("count", "{0} outline", "{0} outlines", facts.outline_count));
    sheet.told(words_of(facts.place, sheet.language));
    sheet.told(facts.note);
}

}  // namespace

std::string picture_title(const ScreenWriter& sheet) {
    const std::string& title = sheet.visit.visitor.felt->facts.title;
    if (!title.empty()) return title;
    const bool is_photo = sheet.visit.visitor.felt->order.source == PictureSource::camera;
    return sheet.words(is_photo ? "Your photo" : "A picture without a name");
}

void put_picture(ScreenWriter& sheet) {
    const PictureFacts& facts = sheet.visit.visitor.felt->facts;
    sheet.screen.title = picture_title(sheet);
    put_told(sheet);
    if (facts.outline_count > 0) {
        sheet.item(VisitItem::lead_round,
                   facts.outline_count > 1 ? "Guide me round the outer outline"
                                           : "Guide me round the outline",
                   {}, "Press Select to begin.");
    }
    if (!facts.parts.empty()) {
        sheet.item(VisitItem::parts, "Parts",
                   sheet.language.counted("count", "{0} part", "{0} parts",
                                          static_cast<int>(facts.parts.size())),
                   "Choose a part, and the handle guides you to it.");
    }
    sheet.item(VisitItem::explore, "Explore freely", {}, "Parts say their names.");
    if (facts.outline_count > 0) {
        sheet.item(VisitItem::bring_back, "Bring me back to a line");
    }
    sheet.item(VisitItem::tell_again, "Tell me again");
    sheet.setting(VisitItem::detail);
    sheet.item(VisitItem::zoom, "Enlargement", told_zoom(sheet));
    sheet.setting(VisitItem::mode);
    sheet.setting(VisitItem::stiffness);
    if (sheet.world.settings.offers_shapes && facts.outline_count > 0) put_shape(sheet);
    const std::string page = words_of(facts.place, sheet.language);
    const bool is_of_things = facts.place.things == ThingSearch::found;
    if (is_of_things) {
        sheet.item(VisitItem::pages, "How much of the photo", page);
    } else if (facts.place.page_count > 1 || facts.place.view_count > 1) {
        sheet.item(VisitItem::pages, "Pages", page);
    }
    const bool was_looked_at = is_of_things || facts.place.things == ThingSearch::unclear;
    if (was_looked_at) sheet.item(VisitItem::thing_here, "Find the thing under my hand");
    sheet.item(VisitItem::another_picture, "Another picture");
    sheet.back();
}

void put_parts(ScreenWriter& sheet) {
    sheet.title("Parts");
    sheet.sentence("Press Select, and the handle guides you to the part.");
    std::vector<ListRow> rows;
    for (const PartFacts& part : sheet.visit.visitor.felt->facts.parts) {
        rows.push_back(
            {rows.size(), part.name, words_of(place_of(part.middle_W, CueArea{}), sheet.language)});
    }
    sheet.list(rows, "Press Select, and the handle guides you to the part.");
    sheet.back();
}

void put_explore(ScreenWriter& sheet) {
    sheet.title("Explore freely");
    sheet.sentence("Rest on a line to hear its name.");
    sheet.item(VisitItem::where_am_i, "Where am I?");
    if (sheet.visit.visitor.felt->facts.outline_count > 0) {
        sheet.item(VisitItem::bring_back, "Bring me back to a line");
    }
    sheet.back();
}

void put_zoom(ScreenWriter& sheet) {
    const bool is_zoomed = sheet.visit.visitor.felt->order.zoom.factor > 1.0;
    sheet.title("Enlargement");
    if (is_zoomed) sheet.told(sheet.language.text("visit", "Now: {0}.", {told_zoom(sheet)}));
    if (is_zoomed) sheet.item(VisitItem::whole_picture, "The whole picture");
    sheet.item(VisitItem::twice_here, "Twice as large, around your hand");
    sheet.item(VisitItem::four_times_here, "Four times as large, around your hand");
    std::vector<ListRow> rows;
    for (const PartFacts& part : sheet.visit.visitor.felt->facts.parts) {
        rows.push_back({rows.size(), part.name, sheet.words("enlarged")});
    }
    sheet.list(rows, "Press Select to enlarge it twice, then four times.");
    sheet.back();
}

void put_pages(ScreenWriter& sheet) {
    const PagePlace& place = sheet.visit.visitor.felt->facts.place;
    const bool is_of_things = place.things == ThingSearch::found;
    sheet.title(is_of_things ? "How much of the photo" : "Pages");
    sheet.told(sheet.language.text("visit", "Now: {0}.", {words_of(place, sheet.language)}));
    if (place.view + 1 < place.view_count) {
        sheet.item(VisitItem::next_view,
                   is_of_things ? "The next thing" : "Next picture of the page");
    }
    if (place.view + 1 == place.view_count) {
        sheet.item(VisitItem::next_view, is_of_things ? "The whole photograph" : "The whole page");
    }
    if (place.view > 1) {
        sheet.item(VisitItem::view_before,
                   is_of_things ? "The thing before" : "The picture before");
    }
    if (place.page < place.page_count) sheet.item(VisitItem::next_page, "Go to the next page");
    if (place.page > 1) sheet.item(VisitItem::page_before, "Go to the page before");
    sheet.back();
}

}  // namespace touchline
