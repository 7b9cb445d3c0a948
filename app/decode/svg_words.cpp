#include "app/decode/svg_words.h"

#include "app/decode/ascii.h"
#include "app/decode/svg_nodes.h"

#include <utility>

namespace touchline::decode {
namespace {

std::string_view language_in(std::string_view tag) {
    return tag.substr(0, tag.find('-'));
}

/// SVG 2: if both attributes exist, XML's counts.
std::string_view tag_of(const pugi::xml_node& element) {
    const auto attribute = element.attribute("xml:lang");
    return attribute ? attribute.value() : element.attribute("lang").value();
}

}  // namespace

BestWords::BestWords(const LanguageTag& wanted)
    : wanted_(wanted.text.empty() ? LanguageTag{}.text : lower(wanted.text)) {}

int BestWords::rank_of(std::string_view tag) const {
    if (tag.empty()) return 1;
    const std::string has = lower(tag);
    if (has == wanted_) return 3;
    return language_in(has) == language_in(wanted_) ? 2 : 0;
}

void BestWords::offer(std::string_view tag, std::string text) {
    const int rank = rank_of(tag);
    if (text.empty() || rank <= rank_) return;
    best_ = std::move(text);
    rank_ = rank;
}

void BestWords::offer_children(const pugi::xml_node& parent, std::string_view name) {
    for (const pugi::xml_node& child : parent.children()) {
        if (child.type() == pugi::node_element && local_name(child) == name)
            offer(tag_of(child), text_of(child));
    }
}

std::string words_in(const pugi::xml_node& parent, std::string_view name,
                     const LanguageTag& language) {
    BestWords best(language);
    best.offer_children(parent, name);
    return best.take();
}

std::string words_of_shape(const pugi::xml_node& shape, const LanguageTag& language) {
    std::string label;
    append_words(label, shape.attribute("data-label").value());
    BestWords best(language);
    best.offer({}, std::move(label));
    best.offer_children(shape, "title");
    return best.take();
}

std::string words_of_text(const pugi::xml_node& text, const LanguageTag& language) {
    BestWords best(language);
    best.offer(tag_of(text), text_of(text));
    best.offer_children(text, "title");
    return best.take();
}

}  // namespace touchline::decode
