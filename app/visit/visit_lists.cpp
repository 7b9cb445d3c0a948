// The lists of pictures, the gallery's and a stick's, and of a document's pages: a long one in
// parts, each named by how its rows are sorted; and the way from a picture to its neighbours.
#include "app/documents/sticks/first_letters.h"
#include "app/documents/sticks/spoken_name.h"
#include "app/visit/list_parts.h"
#include "app/visit/visit_menu.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace touchline {
namespace {

const std::vector<GalleryTitle>& gallery_of(const Visitor& visitor, const VisitWorld& world) {
    static const std::vector<GalleryTitle> none;
    if (world.gallery.empty()) return none;
    return world.gallery[std::min(visitor.sound.language, world.gallery.size() - 1)];
}

/// The easiest first; ungraded pictures last.
std::vector<std::size_t> gallery_order(const std::vector<GalleryTitle>& gallery) {
    std::vector<std::size_t> numbers(gallery.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::ranges::stable_sort(numbers, {}, [&gallery](std::size_t number) {
        constexpr int ungraded = 6;
        return gallery[number].difficulty.value_or(ungraded);
    });
    return numbers;
}

std::string grade_in_words(const GalleryTitle& picture, const Language& language) {
    static constexpr std::array grades{"very easy", "easy", "medium", "hard", "very hard"};
    if (!picture.difficulty) return {};
    const int grade = std::clamp(*picture.difficulty, 1, 5);
    return language.text("visit", grades[static_cast<std::size_t>(grade - 1)]);
}

std::string letter_in_words(const std::string& letter, const Language& language) {
    if (letter == digit_letter) return language.text("visit", "digits");
    return letter.empty() ? language.text("visit", "other signs") : letter;
}

std::string pictures_in_words(std::size_t count, const Language& language) {
    return language.counted("count", "{0} picture", "{0} pictures", static_cast<int>(count));
}

/// The pictures of a list, row by row.
class PictureRows {
  public:
    /// Of the gallery, or of the stick, which need not be read yet.
    PictureRows(PictureSource source, const Visitor& visitor, const VisitWorld& world,
                const Language& language)
        : language_(language) {
        if (source == PictureSource::stick) {
            stick_ = visitor.stick_list.get();
            return;
        }
        gallery_ = &gallery_of(visitor, world);
        order_ = gallery_order(*gallery_);
    }

    [[nodiscard]] std::size_t size() const { return stick_ ? stick_->names.size() : order_.size(); }

    /// LoadPicture::index.
    [[nodiscard]] std::size_t number_at(std::size_t row) const {
        return stick_ ? row : order_[row];
    }

    [[nodiscard]] std::optional<std::size_t> row_of(std::size_t number) const {
        if (stick_) return number < size() ? std::optional(number) : std::nullopt;
        const auto at = std::ranges::find(order_, number);
        if (at == order_.end()) return std::nullopt;
        return static_cast<std::size_t>(at - order_.begin());
    }

    [[nodiscard]] std::string name_at(std::size_t row) const {
        if (!stick_) return picture_at(row).title;
        return spoken_name(stick_->names[row], language_, stick_->forms[row]);
    }

    [[nodiscard]] SpokenText told_name_at(std::size_t row) const {
        return {name_at(row), stick_ ? nullptr : picture_at(row).title_recording};
    }

    [[nodiscard]] std::string value_at(std::size_t row) const {
        return stick_ ? std::string() : grade_in_words(picture_at(row), language_);
    }

    [[nodiscard]] std::vector<ListPart> parts(const ListPart& part) const {
        return parts_of(part, size(), [this](std::size_t row) { return begins_key(row); });
    }

    /// "very easy", "A to C"; "Pictures 40 to 45" where a letter or grade goes on.
    [[nodiscard]] std::string name_of(const ListPart& part) const {
        if (!is_by_key(part))
            return language_.text("visit", "Pictures {0} to {1}",
                                  {std::to_string(part.first + 1), std::to_string(part.end)});
        const std::string from = key_at(part.first);
        const std::string to = key_at(part.end - 1);
        return from == to ? from : language_.text("visit", "{0} to {1}", {from, to});
    }

    /// What its name leaves open: "35 pictures", or which they are. A name tells where one is in a
    /// stick's order; in that of the gallery it would only be long.
    [[nodiscard]] std::string told_pictures(const ListPart& part) const {
        if (is_by_key(part)) return pictures_in_words(part.size(), language_);
        const std::string first = name_at(part.first);
        if (!stick_) return language_.text("visit", "starting with {0}", {first});
        return language_.text("visit", "{0} to {1}", {first, name_at(part.end - 1)});
    }

  private:
    [[nodiscard]] const GalleryTitle& picture_at(std::size_t row) const {
        return (*gallery_)[order_[row]];
    }

    [[nodiscard]] bool begins_key(std::size_t row) const {
        if (row == 0 || row == size()) return true;
        if (stick_) return stick_->letters[row] != stick_->letters[row - 1];
        return picture_at(row).difficulty != picture_at(row - 1).difficulty;
    }

    [[nodiscard]] bool is_by_key(const ListPart& part) const {
        return begins_key(part.first) && begins_key(part.end);
    }

    [[nodiscard]] std::string key_at(std::size_t row) const {
        if (stick_) return letter_in_words(stick_->letters[row], language_);
        const std::string grade = value_at(row);
        return grade.empty() ? language_.text("visit", "not graded") : grade;
    }

    const Language& language_;
    const std::vector<GalleryTitle>* gallery_ = nullptr;  // one of these, or none
    const StickList* stick_ = nullptr;
    std::vector<std::size_t> order_;  // of the gallery
};

VisitScreen list_of(PictureSource source) {
    return source == PictureSource::stick ? VisitScreen::stick : VisitScreen::gallery;
}

PictureRows rows_of(const VisitSheet& sheet, PictureSource source) {
    return {source, sheet.visitor(), sheet.world, sheet.language};
}

PictureRows rows_of(const VisitWork& work, PictureSource source) {
    return {source, work.visitor, work.world, language_of(work)};
}

// What a list shows.

bool shows_part(const VisitSheet& sheet) {
    return sheet.visitor().path.back().end > 0;
}

/// The grade of a picture, unless it is that of the whole part, which was chosen by it.
std::string told_grade(const VisitSheet& sheet, const PictureRows& rows, std::size_t row) {
    const ListPart part = shown_part(sheet.visitor().path.back(), rows.size());
    const bool is_of_part =
        shows_part(sheet) && rows.value_at(part.first) == rows.value_at(part.end - 1);
    return is_of_part ? std::string() : rows.value_at(row);
}

/// The place of a picture in the whole list; empty for the only one.
std::string told_picture_place(const VisitSheet& sheet, const PictureRows& rows, std::size_t row) {
    if (rows.size() == 1) return {};
    return sheet.language.text("visit", "picture {0} of {1}",
                               {std::to_string(row + 1), std::to_string(rows.size())});
}

void write_picture_row(VisitSheet& sheet, const PictureRows& rows, std::size_t row) {
    sheet.row(row, rows.told_name_at(row), told_grade(sheet, rows, row), "Press Select to open it.",
              told_picture_place(sheet, rows, row));
}

/// A picture that is a part by itself is shown at once.
void write_part(VisitSheet& sheet, const PictureRows& rows, const std::vector<ListPart>& parts,
                std::size_t number) {
    const ListPart& part = parts[number];
    if (part.size() == 1) return write_picture_row(sheet, rows, part.first);
    sheet.row(part.first, rows.name_of(part), rows.told_pictures(part),
              "Press Select for these pictures.",
              told_place_among(number + 1, parts.size(), sheet.language));
}

template <PictureSource source>
void write_list(VisitSheet& sheet) {
    const PictureRows rows = rows_of(sheet, source);
    const ListPart part = shown_part(sheet.visitor().path.back(), rows.size());
    const std::vector<ListPart> parts = rows.parts(part);
    for (std::size_t i = 0; i < parts.size(); ++i) write_part(sheet, rows, parts, i);
    if (!parts.empty()) return;
    for (std::size_t row = part.first; row < part.end; ++row) write_picture_row(sheet, rows, row);
}

/// A part is called as its row was, which told the rest.
void write_name_of_part(VisitSheet& sheet, PictureSource source) {
    const PictureRows rows = rows_of(sheet, source);
    sheet.screen.title = rows.name_of(shown_part(sheet.visitor().path.back(), rows.size()));
}

void write_gallery(VisitSheet& sheet) {
    if (shows_part(sheet)) write_name_of_part(sheet, PictureSource::gallery);
}

void write_stick(VisitSheet& sheet) {
    const Visitor& visitor = sheet.visitor();
    if (shows_part(sheet)) return write_name_of_part(sheet, PictureSource::stick);
    if (!visitor.has_stick) {
        sheet.sentence("There is no USB stick.");
        return sheet.sentence("Put a USB stick into the slot; nothing is written to it.");
    }
    if (!visitor.stick_list) return sheet.sentence("Your USB stick is being read.");
    const std::size_t count = visitor.stick_list->names.size();
    if (count == 0) sheet.sentence("There is nothing to feel on it.");
    sheet.told(words_of(visitor.stick_list->rest, count, sheet.language));
}

// What is chosen.

void open_row(VisitWork& work, PictureSource source, const PictureRows& rows, std::size_t row) {
    open_picture(work, source, rows.number_at(row), rows.name_at(row));
}

/// `row`: of a picture, or the first of a part.
template <PictureSource source>
void take_row(VisitWork& work, std::size_t row, const std::string& /*name*/) {
    const PictureRows rows = rows_of(work, source);
    const std::vector<ListPart> parts =
        rows.parts(shown_part(work.visitor.path.back(), rows.size()));
    const auto part = std::ranges::find(parts, row, &ListPart::first);
    if (part == parts.end() || part->size() == 1) return open_row(work, source, rows, row);
    enter_part(work, list_of(source), *part);
    say_screen(work);
}

// From a picture to the one beside it in its list.

/// The row beside that of the picture that is felt.
std::optional<std::size_t> row_beside(const LoadPicture& felt, const PictureRows& rows,
                                      int change) {
    const bool is_of_list =
        felt.source == PictureSource::gallery || felt.source == PictureSource::stick;
    const auto row = is_of_list ? rows.row_of(felt.index) : std::nullopt;
    if (!row || (change < 0 ? *row == 0 : *row + 1 == rows.size())) return std::nullopt;
    return change < 0 ? *row - 1 : *row + 1;
}

template <int change>
bool has_picture_beside(const VisitSheet& sheet) {
    const LoadPicture& felt = sheet.felt().order;
    return row_beside(felt, rows_of(sheet, felt.source), change).has_value();
}

template <int change>
std::string picture_beside(const VisitSheet& sheet) {
    const LoadPicture& felt = sheet.felt().order;
    const PictureRows rows = rows_of(sheet, felt.source);
    return rows.name_at(*row_beside(felt, rows, change));
}

/// The item keeps the focus, so that one key goes through the list.
template <int change>
void open_picture_beside(VisitWork& work) {
    const LoadPicture felt = work.visitor.felt->order;
    const PictureRows rows = rows_of(work, felt.source);
    const auto row = row_beside(felt, rows, change);
    if (!row) return;
    open_row(work, felt.source, rows, *row);
    work.visitor.loading->focus = change > 0 ? VisitItem::next_picture : VisitItem::picture_before;
}

// The pages of a document.

std::size_t page_count(const PagePlace& place) {
    return static_cast<std::size_t>(std::max(place.page_count, 0));
}

std::vector<ListPart> parts_of_pages(const Standing& open, const PagePlace& place) {
    return parts_of(shown_part(open, page_count(place)), page_count(place),
                    [](std::size_t /*page*/) { return false; });
}

std::string name_of_pages(const ListPart& pages, const Language& language) {
    const std::string first = std::to_string(pages.first + 1);
    if (pages.size() == 1) return language.text("page", "Page {0}", {first});
    return language.text("page", "Pages {0} to {1}", {first, std::to_string(pages.end)});
}

/// With two pages, the next and the one before are enough.
bool has_many_pages(const VisitSheet& sheet) {
    return sheet.felt().facts.place.page_count > 2;
}

void write_page_rows(VisitSheet& sheet) {
    const Standing& open = sheet.visitor().path.back();
    const PagePlace& place = sheet.felt().facts.place;
    const ListPart shown = shown_part(open, page_count(place));
    if (shows_part(sheet)) {
        sheet.screen.title = name_of_pages(shown, sheet.language);
        sheet.screen.text.clear();
    }
    const std::vector<ListPart> parts = parts_of_pages(open, place);
    for (const ListPart& part : parts) sheet.row(part.first, name_of_pages(part, sheet.language));
    if (!parts.empty()) return;
    for (std::size_t page = shown.first; page < shown.end; ++page)
        sheet.row(page, name_of_pages({page, page + 1}, sheet.language));
}

/// `row`: a page, or the first of a part.
void take_page(VisitWork& work, std::size_t row, const std::string& /*name*/) {
    const Standing& open = work.visitor.path.back();
    const std::vector<ListPart> parts = parts_of_pages(open, work.visitor.felt->facts.place);
    const auto part = std::ranges::find(parts, row, &ListPart::first);
    if (part == parts.end() || part->size() == 1)
        return open_view(work, static_cast<int>(row) + 1, 1);
    enter_part(work, VisitScreen::pages, *part);
    say_screen(work);
}

using S = VisitScreen;
using I = VisitItem;

constexpr auto list_screens = std::to_array<VisitScreenRow>({
    {.screen = S::gallery, .title = "Gallery", .write = write_gallery, .back_item = "Back"},
    {.screen = S::stick, .title = "Your USB stick", .write = write_stick, .back_item = "Back"},
});

constexpr auto list_items = std::to_array<VisitItemRow>({
    {S::gallery, I::entry, "",
     VisitList{write_list<PictureSource::gallery>, take_row<PictureSource::gallery>}},
    {S::stick, I::entry, "",
     VisitList{write_list<PictureSource::stick>, take_row<PictureSource::stick>}},
    {S::pages, I::entry, "", VisitList{write_page_rows, take_page}, nullptr, has_many_pages},
    {S::picture, I::next_picture, "Next picture", open_picture_beside<+1>, nullptr,
     has_picture_beside<+1>, picture_beside<+1>},
    {S::picture, I::picture_before, "Previous picture", open_picture_beside<-1>, nullptr,
     has_picture_beside<-1>, picture_beside<-1>},
});

}  // namespace

VisitMenu list_menu() {
    return {list_screens, list_items};
}

ListPart shown_part(const Standing& open, std::size_t rows) {
    if (open.end == 0) return {0, rows};
    return {static_cast<std::size_t>(open.about), static_cast<std::size_t>(open.end)};
}

void enter_part(VisitWork& work, VisitScreen list, const ListPart& part) {
    enter(work, list, static_cast<int>(part.first));
    work.visitor.path.back().end = static_cast<int>(part.end);
}

void return_to_row(VisitWork& work, PictureSource source, std::size_t number) {
    go_to(work, list_of(source));
    const PictureRows rows = rows_of(work, source);
    const auto row = rows.row_of(number);
    while (row) {
        Standing& open = work.visitor.path.back();
        const ListPart part = shown_part(open, rows.size());
        const std::vector<ListPart> parts = rows.parts(part);
        const auto inner =
            std::ranges::find_if(parts, [&row](const ListPart& each) { return *row < each.end; });
        open.focus = inner == parts.end() ? *row - part.first
                                          : static_cast<std::size_t>(inner - parts.begin());
        if (inner == parts.end() || inner->size() == 1) return;
        enter_part(work, list_of(source), *inner);
    }
}

void leave_parts_of_stick(Visitor& visitor) {
    std::erase_if(visitor.path, [](const Standing& each) {
        return each.screen == VisitScreen::stick && each.end > 0;
    });
    for (Standing& each : visitor.path)
        if (each.screen == VisitScreen::stick) each.focus = 0;
}

}  // namespace touchline
