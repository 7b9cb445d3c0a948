#include "app/decode/svg_references.h"

#include "app/decode/svg_nodes.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>

#include <pugixml.hpp>

namespace touchline::decode {
namespace {

constexpr int deepest = 1000;  // nesting and references together
constexpr std::size_t too_many = most_drawn_again + 1;

constexpr std::array<const char*, 9> painted_with{"fill",         "stroke",     "mask",
                                                  "clip-path",    "filter",     "marker",
                                                  "marker-start", "marker-mid", "marker-end"};

/// NAME of "#NAME" and of "url(#NAME)"; empty if it refers to nothing in this file.
std::string_view target_of(std::string_view reference) {
    const auto from = reference.find('#');
    if (from == std::string_view::npos) return {};
    const std::string_view name = reference.substr(from + 1);
    return name.substr(0, name.find_first_of("\"')"));
}

struct Drawn {
    std::size_t in_all = 0;
    std::size_t again = 0;

    void add(const Drawn& other) {
        in_all = std::min(in_all + other.in_all, too_many);
        again = std::min(again + other.again, too_many);
    }
};

class Counter {
  public:
    explicit Counter(const pugi::xml_node& root) {
        struct Names : pugi::xml_tree_walker {
            bool for_each(pugi::xml_node& node) override {
                if (const auto id = node.attribute("id")) named->emplace(id.value(), node);
                return true;
            }

            std::unordered_map<std::string_view, pugi::xml_node>* named = nullptr;
        } names;

        names.named = &named_;
        pugi::xml_node(root).traverse(names);
    }

    /// A reference back to an element being counted draws nothing: librsvg breaks such circles.
    Drawn count(const pugi::xml_node& element, int depth) {
        if (depth > deepest) return {too_many, too_many};
        const auto [known, is_new] = counted_.try_emplace(element.hash_value());
        if (!is_new) return known->second;
        Drawn drawn{1, 0};
        for (const pugi::xml_node& child : element.children())
            if (child.type() == pugi::node_element) drawn.add(count(child, depth + 1));
        for (const char* name : {"href", "xlink:href"})
            drawn.add(referred(element.attribute(name).value(), depth));
        for (const char* name : painted_with)
            drawn.add(referred(property_of(element, name), depth));
        return counted_[element.hash_value()] = drawn;
    }

  private:
    Drawn referred(std::string_view reference, int depth) {
        const auto target = named_.find(target_of(reference));
        if (target == named_.end()) return {};
        const std::size_t drawn = count(target->second, depth + 1).in_all;
        return {drawn, drawn};
    }

    std::unordered_map<std::string_view, pugi::xml_node> named_;
    std::unordered_map<std::size_t, Drawn> counted_;
};

}  // namespace

std::size_t drawn_again(std::string_view svg) {
    pugi::xml_document document;
    if (!document.load_buffer(svg.data(), svg.size())) return 0;
    return Counter(document).count(document, 0).again;
}

}  // namespace touchline::decode
