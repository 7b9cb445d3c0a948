// Joins letters that follow each other into texts, whichever way they run.
#include "app/documents/decode/pdf_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glib.h>

namespace touchline::decode {
namespace {

constexpr std::size_t most_texts = 2000;  // a page of a newspaper has 500 lines
constexpr double blank_gap = 0.2;         // of a letter's height: a wider gap separates two words
constexpr double widest_step = 1.6;       // likewise: a wider gap separates two texts
constexpr double largest_overlap = 0.6;   // likewise
constexpr double off_line = 0.6;          // likewise: for raised and lowered letters
constexpr double same_way = 0.95;         // cosine
constexpr double upright_slack = 0.05;    // sine: 3 degrees

double length(const Place& way) {
    return std::hypot(way.x, way.y);
}

Place between(const Place& from, const Place& to) {
    return {to.x - from.x, to.y - from.y};
}

double dot(const Place& a, const Place& b) {
    return a.x * b.x + a.y * b.y;
}

/// The letter's direction, of length 1; the line's direction if the letter takes no room.
Place way_of(const DrawnLetter& letter) {
    const Place along = between(letter.at, letter.next);
    const double long_px = length(along);
    if (long_px > 1e-6) return {along.x / long_px, along.y / long_px};
    const double up_px = std::max(length(letter.up), 1e-6);
    return {-letter.up.y / up_px, letter.up.x / up_px};
}

bool is_blank(const DrawnLetter& letter) {
    return !letter.text.empty() && g_unichar_isspace(g_utf8_get_char(letter.text.c_str())) != FALSE;
}

struct Letter {
    DrawnLetter drawn;
    double gap = 0.0;  // before the letter, in heights
    bool has_blank = false;
    bool is_typed_blank = false;  // the document has a blank there
};

bool is_right_to_left(const std::string& text) {
    switch (g_unichar_get_script(g_utf8_get_char(text.c_str()))) {
        case G_UNICODE_SCRIPT_HEBREW:
        case G_UNICODE_SCRIPT_ARABIC:
        case G_UNICODE_SCRIPT_SYRIAC:
        case G_UNICODE_SCRIPT_THAANA:
            return true;
        default:
            return false;
    }
}

bool is_letter(const std::string& text) {
    return g_unichar_isalpha(g_utf8_get_char(text.c_str())) != FALSE;
}

bool is_letter_or_digit(const std::string& text) {
    return g_unichar_isalnum(g_utf8_get_char(text.c_str())) != FALSE;
}

/// Removes the blanks of a spaced word: letters drawn one by one, apart. The gap between such words
/// is wider. Digits side by side stay separate numbers, and typed blanks stay.
void close_up(std::vector<Letter>& letters) {
    constexpr std::size_t least_letters = 3;
    constexpr double wider = 0.6;  // of a letter's height
    const auto gaps = std::ranges::count_if(letters, &Letter::has_blank);
    const bool is_spaced = letters.size() >= least_letters && 2 * gaps >= std::ssize(letters) &&
                           std::ranges::all_of(letters, [](const Letter& letter) {
                               return !letter.is_typed_blank && is_letter(letter.drawn.text);
                           });
    if (!is_spaced) return;
    std::vector<double> widths;
    for (std::size_t i = 1; i < letters.size(); ++i) widths.push_back(letters[i].gap);
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    for (Letter& letter : letters) letter.has_blank = letter.gap > *middle + wider;
}

/// Turns the order on the page into the order of reading.
void put_in_reading_order(std::vector<Letter>& letters) {
    std::ranges::reverse(letters);
    for (std::size_t i = letters.size(); i-- > 1;) letters[i].has_blank = letters[i - 1].has_blank;
    letters.front().has_blank = false;
    for (std::size_t i = 0; i < letters.size();) {
        std::size_t end = i;
        while (end < letters.size() && !is_right_to_left(letters[end].drawn.text) &&
               is_letter_or_digit(letters[end].drawn.text) && (end == i || !letters[end].has_blank))
            ++end;
        std::reverse(letters.begin() + static_cast<std::ptrdiff_t>(i),
                     letters.begin() + static_cast<std::ptrdiff_t>(end));
        if (end > i) std::swap(letters[i].has_blank, letters[end - 1].has_blank);
        i = std::max(end, i + 1);
    }
}

class TextJoiner {
  public:
    void take(const DrawnLetter& letter) {
        if (is_blank(letter) || letter.is_sign) {
            if (!letters_.empty() && follows(letter)) {
                end_ = letter;
                has_blank_ = true;
            }
            return;
        }
        if (!letters_.empty() && !follows(letter)) end();
        const double gap = letters_.empty() ? 0.0 : gap_before(letter);
        const bool is_typed = !letters_.empty() && has_blank_;
        letters_.push_back(
            {letter, gap, is_typed || (!letters_.empty() && gap > blank_gap), is_typed});
        end_ = letter;
        has_blank_ = false;
    }

    std::vector<DrawnText> finish() {
        end();
        return std::move(texts_);
    }

  private:
    /// True if it stands behind the last letter, or before it on a line that runs from the right.
    bool follows(const DrawnLetter& next) {
        const double height = std::max(length(end_.up), 1e-6);
        const Place way = way_of(end_);
        const double ratio = length(next.up) / height;
        if (dot(way, way_of(next)) < same_way || ratio > 2.5 || ratio < 0.4) return false;
        const Place step = between(end_.next, next.at);
        const Place step_back = between(next.next, end_.at);
        const auto is_near = [&](const Place& s) {
            const double along = dot(s, way) / height;
            const double across = std::abs(s.x * way.y - s.y * way.x) / height;
            return along > -largest_overlap && along < widest_step && across < off_line;
        };
        if (is_near(step)) return true;
        const bool is_before = is_near(step_back) && is_right_to_left(end_.text);
        runs_from_right_ = runs_from_right_ || is_before;
        return is_before;
    }

    double gap_before(const DrawnLetter& letter) const {
        const DrawnLetter& last = letters_.back().drawn;
        const Place step =
            runs_from_right_ ? between(letter.next, last.at) : between(last.next, letter.at);
        return dot(step, way_of(last)) / std::max(length(last.up), 1e-6);
    }

    void end() {
        if (is_text() && texts_.size() < most_texts) texts_.push_back(text());
        letters_.clear();
        has_blank_ = false;
        runs_from_right_ = false;
    }

    bool is_text() const {
        return std::ranges::any_of(
            letters_, [](const Letter& l) { return is_letter_or_digit(l.drawn.text); });
    }

    DrawnText text() {
        close_up(letters_);
        const auto from_right = std::ranges::count_if(
            letters_, [](const Letter& l) { return is_right_to_left(l.drawn.text); });
        if (!runs_from_right_ && 2 * from_right > std::ssize(letters_))
            put_in_reading_order(letters_);
        DrawnText text;
        const Place way = way_of(letters_.front().drawn);
        text.is_slanted = std::min(std::abs(way.x), std::abs(way.y)) > upright_slack;
        text.runs_upright = std::abs(way.y) > std::abs(way.x);
        text.letters = letters_.size();
        text.box = letters_.front().drawn.box;
        for (const Letter& letter : letters_) add(letter, text);
        return text;
    }

    static void add(const Letter& letter, DrawnText& text) {
        const TextBox& box = letter.drawn.box;
        if (text.words.empty() || letter.has_blank) {
            if (!text.words.empty()) text.text += ' ';
            text.words.push_back({box, {}});
        }
        DrawnWord& word = text.words.back();
        word.box = around(word.box, box);
        word.letters.push_back(box);
        text.box = around(text.box, box);
        text.text += letter.drawn.text;
        const double across = text.runs_upright ? box.right - box.left : box.bottom - box.top;
        text.height_px = std::max(text.height_px, across);
    }

    std::vector<Letter> letters_;
    DrawnLetter end_;  // the last letter or blank drawn
    bool has_blank_ = false;
    bool runs_from_right_ = false;
    std::vector<DrawnText> texts_;
};

}  // namespace

std::vector<DrawnText> texts_in(std::span<const DrawnLetter> letters) {
    TextJoiner joiner;
    for (const DrawnLetter& letter : letters) joiner.take(letter);
    return joiner.finish();
}

}  // namespace touchline::decode
