#include "app/braille/line_contents.h"

#include <algorithm>

namespace touchline {
namespace {

void overwrite(LineText& text) {
    std::ranges::fill(text.text, '\0');
    text = {};
}

}  // namespace

BrailleCells LineContents::cells_of(const LineText& text) {
    const std::string language = has_braille(text.language) ? text.language : "en";
    auto braille = braille_of(text.text, language, grade_);
    problem_ = braille ? std::string() : braille.error().line;
    return braille ? std::move(braille->cells) : BrailleCells();
}

void LineContents::say(LineText text, LineUse use, double now_s) {
    if (text.text.empty()) return;
    if (reading_.width > 0) reading_ = with_text(std::move(reading_), cells_of(text), use, now_s);
    said_.emplace_back(std::move(text), use);
    if (said_.size() <= most_line_texts) return;
    overwrite(said_.front().first);
    said_.pop_front();
}

void LineContents::rest(LineText text, double now_s) {
    if (text == resting_) return;
    resting_ = std::move(text);
    if (reading_.width > 0) reading_ = with_resting(std::move(reading_), cells_of(resting_), now_s);
}

void LineContents::choose(BrailleGrade grade, double now_s) {
    if (grade == grade_) return;
    grade_ = grade;
    if (reading_.width > 0) write_all(now_s);
}

void LineContents::set_width(std::size_t width, double now_s) {
    const bool is_new = reading_.width == 0 && width > 0;
    reading_ = width > 0 ? with_width(std::move(reading_), width, now_s) : LineReading{};
    if (is_new) write_all(now_s);
}

/// The newest text that cut the others is read, from its beginning.
void LineContents::write_all(double now_s) {
    const std::size_t width = reading_.width;
    reading_ = LineReading{};
    reading_.width = width;
    for (const auto& [text, use] : said_)
        reading_ = with_text(std::move(reading_), cells_of(text), use, now_s);
    reading_ = with_resting(std::move(reading_), cells_of(resting_), now_s);
}

bool LineContents::turn(LineTurn turn, double now_s) {
    auto next = turned(reading_, turn, now_s);
    if (!next) return false;
    reading_ = std::move(*next);
    return true;
}

void LineContents::pass(double now_s) {
    if (const auto due = due_s(); due && now_s >= *due)
        reading_ = passed(std::move(reading_), now_s);
}

void LineContents::forget() {
    for (auto& [text, use] : said_) overwrite(text);
    said_.clear();
    overwrite(resting_);
    for (BrailleCells& text : reading_.texts) std::ranges::fill(text, std::uint8_t{0});
    std::ranges::fill(reading_.resting, std::uint8_t{0});
    const std::size_t width = reading_.width;
    reading_ = LineReading{};
    reading_.width = width;
}

}  // namespace touchline
