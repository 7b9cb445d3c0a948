#include "app/visit/page_place.h"

#include "app/visit/screen_model.h"

namespace touchline {
namespace {

/// The thing of a photograph that is felt, or why the whole is felt.
std::string told_thing(const PagePlace& place, const Language& language) {
    switch (place.things) {
        case ThingSearch::under_way:
            return language.text("page", "Its main subject is being looked for");
        case ThingSearch::unclear:
            return language.text("page", "It has no clear main subject");
        case ThingSearch::impossible:
        case ThingSearch::absent:
            return language.text("page", "Its main subject cannot be found here");
        case ThingSearch::none:
        case ThingSearch::found:
            break;
    }
    if (place.view >= place.view_count) return language.text("page", "The whole photograph");
    if (place.view_count == 2) {
        return language.text("page", place.is_face ? "A face in the photograph"
                                                   : "Only the main subject of the photograph");
    }
    if (place.is_face) {
        return language.text("page", "Thing {0} of {1} in the photograph, a face",
                             {std::to_string(place.view), std::to_string(place.view_count - 1)});
    }
    return language.text("page", "Thing {0} of {1} in the photograph",
                         {std::to_string(place.view), std::to_string(place.view_count - 1)});
}

/// Which of a page's pictures or things is felt.
std::string told_view(const PagePlace& place, const Language& language) {
    if (place.things != ThingSearch::none) return told_thing(place, language);
    if (place.view_count <= 1) return {};
    if (place.view >= place.view_count) return language.text("page", "The whole page");
    return language.text("page", "Picture {0} of {1} on this page",
                         {std::to_string(place.view), std::to_string(place.view_count - 1)});
}

}  // namespace

std::string told_page(int page, int page_count, const Language& language) {
    if (page_count <= 1) return {};
    return language.text("page", "Page {0} of {1}",
                         {std::to_string(page), std::to_string(page_count)});
}

std::string words_of(const PagePlace& place, const Language& language) {
    std::string text = told_page(place.page, place.page_count, language);
    add_sentence(text, told_view(place, language));
    return text;
}

}  // namespace touchline
