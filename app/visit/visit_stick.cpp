// A stick's list of files, all of them or those that begin alike, and its letters.
#include "app/documents/sticks/spoken_name.h"
#include "app/visit/visit_menu.h"

#include <array>
#include <memory>
#include <numeric>

namespace touchline {
namespace {

std::size_t rows_of(const Visitor& visitor) {
    return visitor.found ? visitor.found->rows.size() : visitor.stick_list->names.size();
}

std::size_t row_at(const Visitor& visitor, std::size_t place) {
    return visitor.found ? visitor.found->rows[place] : place;
}

std::string name_of(const LetterGroup& group, const Language& language) {
    switch (group.kind) {
        case LetterKind::letters:
            return spoken_name(group.beginning, language, {NameDetail::whole});
        case LetterKind::digits:
            return language.text("visit", "digits");
        case LetterKind::other:
            return language.text("visit", "other signs");
    }
    return {};
}

std::string files_in_words(std::size_t count, const Language& language) {
    return language.counted("count", "{0} file", "{0} files", static_cast<int>(count));
}

/// The letters of all files that the list shows now.
std::vector<LetterGroup> groups_of(const VisitWork& work) {
    const Visitor& visitor = work.visitor;
    std::vector<std::size_t> rows(visitor.stick_list->names.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    if (visitor.found) rows = visitor.found->rows;
    return letter_groups(visitor.stick_list->names, rows, language_of(work).code());
}

/// True once the stick has been read.
bool has_list(const VisitSheet& sheet) {
    return sheet.visitor().has_stick && sheet.visitor().stick_list;
}

bool is_part(const VisitSheet& sheet) {
    return has_list(sheet) && sheet.visitor().found;
}

/// True if there is more than a page, so that a search helps.
bool can_be_grouped(const VisitSheet& sheet) {
    return has_list(sheet) && rows_of(sheet.visitor()) > list_page;
}

void write_stick(VisitSheet& sheet) {
    const Visitor& visitor = sheet.visitor();
    if (!visitor.has_stick) {
        sheet.sentence("There is no USB stick.");
        return sheet.sentence("Put one into the USB slot; nothing is written to it.");
    }
    if (!visitor.stick_list) return sheet.sentence("Your USB stick is being read.");
    const std::vector<std::string>& names = visitor.stick_list->names;
    if (names.empty()) sheet.sentence("There is nothing to feel on it.");
    if (visitor.found) {
        sheet.told(sheet.language.text("visit", "Beginning with {0}: {1}",
                                       {name_of(*visitor.found, sheet.language),
                                        files_in_words(rows_of(visitor), sheet.language)}));
    } else {
        sheet.told(words_of(visitor.stick_list->rest, names.size(), sheet.language));
    }
}

void write_files(VisitSheet& sheet) {
    if (!has_list(sheet)) return;
    const Visitor& visitor = sheet.visitor();
    sheet.list(
        rows_of(visitor),
        [&](std::size_t place) {
            const std::size_t row = row_at(visitor, place);
            const NameForm& form = visitor.stick_list->forms[row];
            return ListRow{
                row, spoken_name(visitor.stick_list->names[row], sheet.language, form), {}};
        },
        "Press Select to open it.");
}

void take_file(VisitWork& work, std::size_t row, const std::string& name) {
    open_picture(work, PictureSource::stick, row, name);
}

void write_letters(VisitSheet& sheet) {
    if (!sheet.visitor().letters) return;
    const std::vector<LetterGroup>& letters = *sheet.visitor().letters;
    for (std::size_t i = 0; i < letters.size(); ++i)
        sheet.row(i, name_of(letters[i], sheet.language),
                  files_in_words(letters[i].rows.size(), sheet.language));
}

/// Opens the letters of the rows that the list shows now.
void open_letters(VisitWork& work) {
    if (!work.visitor.stick_list) return;
    work.visitor.letters = std::make_shared<const std::vector<LetterGroup>>(groups_of(work));
    show(work, VisitScreen::letters);
}

void say_list_from_start(VisitWork& work) {
    Standing& list = work.visitor.path.back();
    list.about = 0;
    list.focus = 0;
    say_screen(work);
}

/// `row` of Visitor::letters: from now on the list shows its files.
void take_letter(VisitWork& work, std::size_t row, const std::string& /*name*/) {
    Visitor& visitor = work.visitor;
    if (!visitor.letters || row >= visitor.letters->size()) return;
    visitor.found = std::make_shared<const LetterGroup>((*visitor.letters)[row]);
    visitor.letters.reset();
    leave(work);
    say_list_from_start(work);
}

void show_all_files(VisitWork& work) {
    forget_letters(work.visitor);
    say_list_from_start(work);
}

using S = VisitScreen;
using I = VisitItem;

constexpr auto stick_screens = std::to_array<VisitScreenRow>({
    {.screen = S::stick, .title = "Your USB stick", .write = write_stick, .back_item = "Back"},
    {.screen = S::letters, .title = "How names begin", .back_item = "Back"},
});

constexpr const char* group_hint = "Groups the files by how their names begin.";

constexpr auto stick_items = std::to_array<VisitItemRow>({
    {S::stick, I::entry, "", VisitList{write_files, take_file}},
    {S::stick, I::letters, "By the next letter", open_letters, group_hint,
     [](const VisitSheet& sheet) { return can_be_grouped(sheet) && is_part(sheet); }},
    {S::stick, I::letters, "By the first letter", open_letters, group_hint,
     [](const VisitSheet& sheet) { return can_be_grouped(sheet) && !is_part(sheet); }},
    {S::stick, I::all_files, "All files", show_all_files, nullptr, is_part},
    {S::letters, I::entry, "", VisitList{write_letters, take_letter}},
});

}  // namespace

VisitMenu stick_menu() {
    return {stick_screens, stick_items};
}

void forget_letters(Visitor& visitor) {
    visitor.found.reset();
    visitor.letters.reset();
}

void return_to_file(VisitWork& work, std::size_t row) {
    const Visitor& visitor = work.visitor;
    if (!visitor.stick_list) return;
    const std::size_t count = rows_of(visitor);
    std::size_t place = 0;
    while (place < count && row_at(visitor, place) != row) ++place;
    if (place == count) return;
    Standing& list = work.visitor.path.back();
    list.about = static_cast<int>(place / list_page * list_page);
    list.focus = place % list_page;
}

}  // namespace touchline
