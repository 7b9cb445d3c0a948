// Private to app/documents/decode: the elements of an SVG in pugixml, and which of their texts is
// said: SVG gives an element a <title> and a <desc> for each language, told apart by xml:lang.
// Threads: pure functions and values.
#pragma once

#include "config/types/choices.h"
#include "config/types/tactile_map.h"

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

}  // namespace touchline::decode
