// A stick's list of files, all of them or those that begin alike, and its letters.
#include "app/session/screen_writer.h"
#include "app/sticks/spoken_name.h"
#include "app/sticks/stick_words.h"

#include <algorithm>
#include <numeric>

namespace touchline {
namespace {

/// True if there is more than a page, so that a search helps.
bool is_long(std::size_t rows) {
    return rows > list_page;
}

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

}  // namespace

void put_stick(ScreenWriter& sheet) {
    const Visitor& visitor = sheet.visit.visitor;
    sheet.title("Your USB stick");
    if (!visitor.has_stick) {
        sheet.sentence("There is no USB stick.");
        sheet.sentence("Put one into the USB slot; nothing is written to it.");
        return sheet.back();
    }
    if (!visitor.stick_list) {
        sheet.sentence("Your USB stick is being read.");
        return sheet.back();
    }
    const std::vector<std::string>& names = visitor.stick_list->names;
    if (names.empty()) sheet.sentence("There is nothing to feel on it.");
    if (visitor.found) {
        sheet.told(sheet.language.text("visit", "Beginning with {0}: {1}",
                                       {name_of(*visitor.found, sheet.language),
                                        files_in_words(rows_of(visitor), sheet.language)}));
    } else {
        sheet.told(words_of(visitor.stick_list->rest, names.size(), sheet.language));
    }
    sheet.list(
        rows_of(visitor),
        [&](std::size_t place) {
            const std::size_t row = row_at(visitor, place);
            const NameForm& form = visitor.stick_list->forms[row];
            return ListRow{row, spoken_name(names[row], sheet.language, form), {}};
        },
        "Press Select to open it.");
    if (is_long(rows_of(visitor)))
        sheet.item(VisitItem::letters, visitor.found ? "By the next letter" : "By the first letter",
                   {}, "Groups the files by how their names begin.");
    if (visitor.found) sheet.item(VisitItem::all_files, "All files");
    sheet.back();
}

void put_letters(ScreenWriter& sheet) {
    const Visitor& visitor = sheet.visit.visitor;
    sheet.title("How names begin");
    if (visitor.letters) {
        for (std::size_t i = 0; i < visitor.letters->size(); ++i) {
            const LetterGroup& group = (*visitor.letters)[i];
            sheet.row(i, name_of(group, sheet.language),
                      files_in_words(group.rows.size(), sheet.language));
        }
    }
    sheet.back();
}

void open_letters(VisitWork& work) {
    if (!work.visitor.stick_list) return;
    work.visitor.letters = std::make_shared<const std::vector<LetterGroup>>(groups_of(work));
    enter(work, VisitScreen::letters);
    say_screen(work);
}

void take_letter(VisitWork& work, std::size_t row) {
    Visitor& visitor = work.visitor;
    if (!visitor.letters || row >= visitor.letters->size()) return;
    visitor.found = std::make_shared<const LetterGroup>((*visitor.letters)[row]);
    visitor.letters.reset();
    leave(work);
    Standing& list = work.visitor.path.back();
    list.about = 0;
    list.focus = 0;
    say_screen(work);
}

void show_all_files(VisitWork& work) {
    forget_letters(work.visitor);
    Standing& list = work.visitor.path.back();
    list.about = 0;
    list.focus = 0;
    say_screen(work);
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
