// Private to app/documents/decode: the elements of an SVG in pugixml; which of their texts is said:
// SVG gives an element a <title> and a <desc> for each language, told apart by xml:lang; and the
// numbers and transforms in their attributes, whatever the locale, each in O(length).
// Threads: pure functions and values; a scanner by one thread.
#pragma once

#include "config/types/choices.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace touchline::decode {

constexpr int max_nesting = 100;  // drawing programs nest groups ten deep

/// The name without a prefix.
[[nodiscard]] std::string_view local_name(const pugi::xml_node& element);

/// True if an element of this name, given without its prefix, draws a line. Texts, uses and images
/// do not.
[[nodiscard]] bool is_shape(std::string_view name);

/// Parses the text and gives its <svg>; null if it is no SVG.
[[nodiscard]] pugi::xml_node svg_root_in(std::string_view text, pugi::xml_document& document);

/// Visits the elements below `root` in the order of the document, without recursion, because the
/// nesting comes from the file.
template <class Visit>
void for_each_element(pugi::xml_node root, const Visit& visit) {
    struct Walker : pugi::xml_tree_walker {
        bool for_each(pugi::xml_node& node) override {
            if (node.type() == pugi::node_element) (*seen)(node);
            return true;
        }

        const Visit* seen = nullptr;
    } walker;

    walker.seen = &visit;
    root.traverse(walker);
}

/// True if the document is drawn in millimetres, and no larger than the area. `width_mm` and
/// `height_mm`: the size of its viewBox.
[[nodiscard]] bool is_in_millimetres(const pugi::xml_node& root, double width_mm, double height_mm,
                                     const Area& area);

/// The first child element of this name; null if there is none.
[[nodiscard]] pugi::xml_node child_named(const pugi::xml_node& parent, std::string_view name);

/// Appends words, one blank between them.
void append_words(std::string& text, std::string_view more);

/// All text inside an element, except the titles and descriptions of its children.
[[nodiscard]] std::string text_of(pugi::xml_node element);

/// An attribute, or the same property in the style attribute, which wins; empty if there is
/// neither.
[[nodiscard]] std::string_view property_of(const pugi::xml_node& element, const char* name);

/// True if the element itself has display: none.
[[nodiscard]] bool is_hidden(const pugi::xml_node& element);

/// "de" of "de-AT".
[[nodiscard]] constexpr std::string_view language_in(std::string_view tag) {
    return tag.substr(0, tag.find('-'));
}

/// The language of a text; SVG 2: if both attributes exist, XML's counts.
[[nodiscard]] std::string_view tag_of(const pugi::xml_node& element);

/// The best of the element's children of this name; empty if there is none.
[[nodiscard]] std::string words_in(const pugi::xml_node& parent, std::string_view name,
                                   const LanguageTag& language);

/// The words for a shape. Its data-label is a title without a language that comes before the
/// others.
[[nodiscard]] std::string words_of_shape(const pugi::xml_node& shape, const LanguageTag& language);

/// The words for a <text>: the text as it is drawn, or a title inside it in another language.
[[nodiscard]] std::string words_of_text(const pugi::xml_node& text, const LanguageTag& language);

/// Walks over a list such as "10,20 -.5.5e1", where a sign or a point may begin the next number.
class SvgScanner {
  public:
    explicit SvgScanner(std::string_view text) : text_(text) {}

    void skip_space();

    /// Skips white space with at most one comma in it.
    void skip_separator();

    [[nodiscard]] bool is_at_end() const { return position_ == text_.size(); }

    [[nodiscard]] std::size_t position() const { return position_; }

    /// The current character, 0 at the end.
    [[nodiscard]] char peek() const { return is_at_end() ? '\0' : text_[position_]; }

    char take() { return is_at_end() ? '\0' : text_[position_++]; }

    /// Takes the word if it comes next.
    bool take_word(std::string_view word);

    /// Takes a finite number and the separator behind it; nothing if there is none.
    std::optional<double> take_number();

    /// Takes a flag of an arc: one digit, 0 or 1, which may touch what follows it.
    std::optional<double> take_flag();

  private:
    std::string_view text_;
    std::size_t position_ = 0;
};

/// Reads an attribute that is one number; "px" may follow it (it is the user unit).
[[nodiscard]] std::optional<double> parse_svg_length(std::string_view text);

using UserPoint = Vec2<struct UserUnit>;  // in an SVG; millimetres of a map once transformed

/// x' = a x + c y + e, y' = b x + d y + f, as SVG's matrix(a b c d e f).
struct Affine {
    double a = 1.0;
    double b = 0.0;
    double c = 0.0;
    double d = 1.0;
    double e = 0.0;
    double f = 0.0;

    friend bool operator==(const Affine&, const Affine&) = default;

    [[nodiscard]] UserPoint operator()(UserPoint p) const {
        return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
    }

    /// The largest factor by which a length grows: the greater singular value.
    [[nodiscard]] double stretch() const;
};

/// Applies `inner`, then `outer`.
[[nodiscard]] Affine operator*(const Affine& outer, const Affine& inner);

/// Reads matrix, translate, scale, rotate, skewX and skewY, in any number; the empty text is the
/// identity. Returns nothing if the text is no transform.
[[nodiscard]] std::optional<Affine> parse_svg_transform(std::string_view text);

}  // namespace touchline::decode
