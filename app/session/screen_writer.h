// A screen while it is being written. Only for visit_screens.cpp and screen_writer.cpp. Threads:
// values; one call's.
#pragma once

#include "app/session/visit_work.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace touchline {

struct ListRow {
    std::size_t number = 0;  // what the row stands for
    std::string name;
    std::string value;
};

/// The English texts belong to the context "visit".
struct ScreenWriter {
    const Visit& visit;
    const VisitWorld& world;
    const Language& language;
    SpokenScreen screen;

    [[nodiscard]] std::string words(const char* english) const;
    void title(const char* english);
    void sentence(const char* english);

    /// Adds text that is in the visitor's language already.
    void told(const std::string& text);
    void item(VisitItem item, const char* english, const std::string& value = {},
              const char* hint = nullptr);
    void toggle(VisitItem item, const char* english, bool is_on, const char* hint = nullptr);
    void setting(VisitItem item);
    void row(std::size_t number, const std::string& name, const std::string& value = {});

    /// Writes the page of ten rows that begins at Standing::about, and the items that lead to the
    /// other pages. Asks `row_at` only for the rows on the page.
    void list(std::size_t count, const std::function<ListRow(std::size_t)>& row_at,
              const char* hint);
    void list(const std::vector<ListRow>& rows, const char* hint);
    void back(const char* english = "Back");

    /// Rewords the hint of a single item, because it must not send anybody to another item.
    void mind_the_only_item();
};

[[nodiscard]] const std::vector<GalleryTitle>& gallery_of(const ScreenWriter& sheet);

/// The easiest first; ungraded pictures last.
[[nodiscard]] std::vector<std::size_t> gallery_order(const ScreenWriter& sheet);
[[nodiscard]] std::string picture_title(const ScreenWriter& sheet);

void put_stick(ScreenWriter& sheet);
void put_letters(ScreenWriter& sheet);
void put_picture(ScreenWriter& sheet);
void put_parts(ScreenWriter& sheet);
void put_explore(ScreenWriter& sheet);
void put_zoom(ScreenWriter& sheet);
void put_pages(ScreenWriter& sheet);

/// Writes the items of a shape in the hand, on the screen of the picture (visit_shape.cpp).
void put_shape(ScreenWriter& sheet);

}  // namespace touchline
