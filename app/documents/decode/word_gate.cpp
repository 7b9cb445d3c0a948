#include "app/documents/decode/readers.h"
#include "app/documents/decode/word_reader.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace touchline::decode {
namespace {

// Measured on photos, drawings and pages of text; see README.md.
constexpr double least_confidence = 60.0;
constexpr double least_of_a_long_word = 75.0;  // for a word that vouches for its line
constexpr double least_of_a_short_word = 95.0;
constexpr double least_of_a_letter = 85.0;  // in a line that another word vouches for
constexpr int letters_of_a_long_word = 4;
constexpr int letters_of_a_word = 2;
constexpr std::size_t most_labels = 2000;

struct Signs {
    int letters = 0;  // letters and digits
    int others = 0;
};

/// True for western European letters, U+00C0 to U+024F without the times and division signs.
bool is_letter(std::string_view text, std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]);
    const auto second =
        at + 1 < text.size() ? static_cast<unsigned char>(text[at + 1]) : std::uint8_t{0};
    const bool is_ascii = (first >= '0' && first <= '9') || (first >= 'a' && first <= 'z') ||
                          (first >= 'A' && first <= 'Z');
    const bool is_sign = first == 0xc3 && (second == 0x97 || second == 0xb7);
    return is_ascii || (first >= 0xc3 && first <= 0xc9 && !is_sign);
}

Signs signs_in(std::string_view text) {
    Signs signs;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if ((static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U) continue;
        ++(is_letter(text, at) ? signs.letters : signs.others);
    }
    return signs;
}

bool stands_for_its_line(const SeenWord& word) {
    const Signs signs = signs_in(word.text);
    if (signs.letters < letters_of_a_word || signs.letters <= signs.others) return false;
    return word.confidence >=
           (signs.letters >= letters_of_a_long_word ? least_of_a_long_word : least_of_a_short_word);
}

bool is_a_word(const SeenWord& word) {
    const int letters = signs_in(word.text).letters;
    return letters > 0 &&
           word.confidence >= (letters >= letters_of_a_word ? least_confidence : least_of_a_letter);
}

TextBox text_box(const WordBox& box) {
    return {static_cast<double>(box.left), static_cast<double>(box.top),
            static_cast<double>(box.right), static_cast<double>(box.bottom)};
}

/// The widest gap between words of one text, in line heights.
constexpr double widest_gap = 1.2;

/// True if `next` stands in the line of `text`, close behind it.
bool continues(const TextBox& text, const TextBox& next) {
    constexpr double least_height = 1.0;
    const double height = std::max(text.bottom - text.top, least_height);
    return next.left - text.right < widest_gap * height && next.top < text.bottom &&
           next.bottom > text.top;
}

class WordJoiner {
  public:
    WordJoiner(int width, int height) : picture_{width, height, {}, 1.0} {
        found_.width = width;
        found_.height = height;
        found_.area = told_area(picture_);
    }

    void take(const SeenWord& word) {
        const TextBox box = text_box(word.box);
        const bool goes_on = !run_.empty() && !word.begins_line && continues(box_, box);
        if (!goes_on) end();
        box_ = run_.empty() ? box : around(box_, box);
        run_.push_back(&word);
    }

    FoundWords finish() {
        end();
        return std::move(found_);
    }

  private:
    void end() {
        const bool is_text = std::ranges::any_of(
            run_, [](const SeenWord* word) { return stands_for_its_line(*word); });
        std::erase_if(run_, [](const SeenWord* word) { return !is_a_word(*word); });
        if (is_text && found_.labels.size() < most_labels &&
            found_.boxes.size() + run_.size() <= max_word_boxes)
            keep();
        run_.clear();
    }

    void keep() {
        std::string text;
        TextBox box = text_box(run_.front()->box);
        for (const SeenWord* word : run_) {
            if (!text.empty()) text += ' ';
            text += word->text;
            box = around(box, text_box(word->box));
            found_.boxes.push_back(word->box);
        }
        found_.labels.push_back({text, told_place(picture_, (box.left + box.right) / 2.0,
                                                  (box.top + box.bottom) / 2.0)});
    }

    Picture picture_;  // only its size counts
    FoundWords found_;
    std::vector<const SeenWord*> run_;  // words that stand close in one line
    TextBox box_;                       // around them
};

}  // namespace

FoundWords believed(std::span<const SeenWord> seen, int width, int height) {
    WordJoiner joiner(width, height);
    for (const SeenWord& word : seen) joiner.take(word);
    return joiner.finish();
}

}  // namespace touchline::decode
