// Words with their boxes, from the text layer of a PDF.
#include "app/decode/pdf_parts.h"
#include "app/decode/text_line.h"

#include <algorithm>
#include <cmath>

namespace touchline::decode {
namespace {

constexpr std::size_t most_texts = 2000;  // a page of a newspaper has 500 lines

bool is_finite(const PopplerRectangle& box) {
    return std::isfinite(box.x1) && std::isfinite(box.y1) && std::isfinite(box.x2) &&
           std::isfinite(box.y2);
}

PopplerRectangle ordered(const PopplerRectangle& box) {
    return {std::min(box.x1, box.x2), std::min(box.y1, box.y2), std::max(box.x1, box.x2),
            std::max(box.y1, box.y2)};
}

TextBox text_box(const PopplerRectangle& box) {
    return {box.x1, box.y1, box.x2, box.y2};
}

void grow(PopplerRectangle& box, const PopplerRectangle& other) {
    const TextBox both = around(text_box(box), text_box(other));
    box = {both.left, both.top, both.right, both.bottom};
}

/// Puts characters together, in the order in which poppler reads them.
class TextJoiner {
  public:
    void take(gunichar character, const PopplerRectangle& box) {
        if (character == '\n') return end();
        if (g_unichar_isspace(character)) {
            has_blank_ = true;
            return;
        }
        if (!is_finite(box)) return;
        if (!text_.text.empty() && !continues(text_box(text_.box), text_box(box))) end();
        if (text_.text.empty()) {
            text_.box = box;
        } else {
            grow(text_.box, box);
            if (has_blank_) text_.text += ' ';
        }
        has_blank_ = false;
        char utf8[6];
        text_.text.append(utf8, static_cast<std::size_t>(g_unichar_to_utf8(character, utf8)));
    }

    std::vector<PdfText> finish() {
        end();
        return std::move(texts_);
    }

  private:
    void end() {
        if (!text_.text.empty() && texts_.size() < most_texts) texts_.push_back(text_);
        text_ = {};
        has_blank_ = false;
    }

    PdfText text_;
    bool has_blank_ = false;
    std::vector<PdfText> texts_;
};

}  // namespace

std::vector<PdfText> texts_of(PopplerPage* page) {
    const GlibOwned<gchar> text(poppler_page_get_text(page));
    PopplerRectangle* found = nullptr;
    guint count = 0;
    if (text == nullptr || poppler_page_get_text_layout(page, &found, &count) == FALSE) return {};
    const GlibOwned<PopplerRectangle> boxes(found);
    TextJoiner joiner;
    const gchar* at = text.get();
    for (guint i = 0; i < count && *at != '\0'; ++i, at = g_utf8_next_char(at))
        joiner.take(g_utf8_get_char(at), ordered(boxes.get()[i]));
    return joiner.finish();
}

}  // namespace touchline::decode
