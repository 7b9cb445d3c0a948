// Private to app/decode: the elements of an SVG in pugixml.
// Threads: pure functions.
#pragma once

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

}  // namespace touchline::decode
