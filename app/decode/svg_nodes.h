// Private to app/decode: the elements of an SVG as pugixml has them.
// Threads: pure functions.
#pragma once

#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace touchline::decode {

constexpr int max_nesting = 100;  // drawing programs nest groups ten deep

/// The name without a prefix.
[[nodiscard]] std::string_view local_name(const pugi::xml_node& element);

/// Does an element of this name, without its prefix, draw a line? Texts, uses and images are none.
[[nodiscard]] bool is_shape(std::string_view name);

/// The first child element of this name; null where there is none.
[[nodiscard]] pugi::xml_node child_named(const pugi::xml_node& parent, std::string_view name);

/// Appends words, one blank between them.
void append_words(std::string& text, std::string_view more);

/// All text inside an element, but for the titles and descriptions of what is in it.
[[nodiscard]] std::string text_of(pugi::xml_node element);

/// An attribute, or the same in the style attribute, which wins; empty where neither is.
[[nodiscard]] std::string_view property_of(const pugi::xml_node& element, const char* name);

/// display: none, said of the element itself.
[[nodiscard]] bool is_hidden(const pugi::xml_node& element);

}  // namespace touchline::decode
