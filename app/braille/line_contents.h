// A braille line without its display: texts in, cells out. The line of BrlAPI (braille_line.h) and
// that of a test both hold one.
// Threads: one at a time. Translation takes up to 0.1 s the first time, so not the screen's.
#pragma once

#include "app/braille/line_pages.h"
#include "app/braille/translation.h"

#include <deque>
#include <string>
#include <utility>

namespace touchline {

/// `language`: a code as of Language. One without a braille table is written by the English one.
struct LineText {
    std::string language;
    std::string text;

    friend bool operator==(const LineText&, const LineText&) = default;
};

/// Without a line (width 0) texts are kept, as many as somebody could page back to, and not
/// translated: nobody who has no line pays for one. Times are of any clock and never go back.
class LineContents {
  public:
    void say(LineText text, LineUse use, double now_s);

    /// What comes after the last text: the item that has the focus.
    void rest(LineText text, double now_s);

    /// Writes all again.
    void choose(BrailleGrade grade, double now_s);

    /// 0: there is no line.
    void set_width(std::size_t width, double now_s);

    /// Returns false at an end.
    bool turn(LineTurn turn, double now_s);

    /// Time has passed.
    void pass(double now_s);

    /// When pass() will next do something; nothing: not by itself.
    [[nodiscard]] std::optional<double> due_s() const { return next_due_s(reading_); }

    /// As wide as the line.
    [[nodiscard]] BrailleCells shown() const { return shown_on(reading_); }

    /// What is kept, and where the reader is.
    [[nodiscard]] const LineReading& reading() const { return reading_; }

    [[nodiscard]] std::size_t width() const { return reading_.width; }

    /// Why the last text could not be written; empty: it was.
    [[nodiscard]] const std::string& problem() const { return problem_; }

    /// The visitor is gone: overwrites everything that was said.
    void forget();

  private:
    [[nodiscard]] BrailleCells cells_of(const LineText& text);
    void write_all(double now_s);

    std::deque<std::pair<LineText, LineUse>> said_;  // oldest first
    LineText resting_;
    BrailleGrade grade_ = BrailleGrade::uncontracted;
    LineReading reading_;
    std::string problem_;
};

}  // namespace touchline
