// Private to app/decode: decides which of several texts of an SVG is said. SVG gives an element a
// <title> and a <desc> for each language, told apart by xml:lang. Threads: pure functions and
// values.
#pragma once

#include "config/types/language_tag.h"

#include <string>
#include <string_view>
#include <utility>

#include <pugixml.hpp>

namespace touchline::decode {

/// Takes texts with their tags one by one and keeps the one that serves a language best: one with
/// the same tag, else of the same language ("de" for "de-AT" and the other way round), else without
/// a tag, else any. Among equals the first counts. Ignores the case of tags.
class BestWords {
  public:
    explicit BestWords(const LanguageTag& wanted);

    /// O(tag + text). Ignores an empty text.
    void offer(std::string_view tag, std::string text);

    /// Offers every child of this name.
    void offer_children(const pugi::xml_node& parent, std::string_view name);

    [[nodiscard]] std::string take() { return std::move(best_); }

  private:
    [[nodiscard]] int rank_of(std::string_view tag) const;

    std::string wanted_;
    std::string best_;
    int rank_ = -1;
};

/// The best of the element's children of this name; empty if there is none.
[[nodiscard]] std::string words_in(const pugi::xml_node& parent, std::string_view name,
                                   const LanguageTag& language);

/// The words for a shape. Its data-label is a title without a language that comes before the
/// others.
[[nodiscard]] std::string words_of_shape(const pugi::xml_node& shape, const LanguageTag& language);

/// The words for a <text>: the text as it is drawn, or a title inside it in another language.
[[nodiscard]] std::string words_of_text(const pugi::xml_node& text, const LanguageTag& language);

}  // namespace touchline::decode
