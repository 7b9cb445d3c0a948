#include "app/decode/svg_texts.h"

#include "app/decode/page.h"
#include "app/decode/svg_nodes.h"
#include "app/decode/svg_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace touchline::decode {
namespace {

/// True for elements whose content is painted elsewhere, or nowhere.
bool is_apart(std::string_view name) {
    constexpr std::array<std::string_view, 5> apart{"defs", "symbol", "clipPath", "mask",
                                                    "pattern"};
    return std::ranges::find(apart, name) != apart.end();
}

class Collector {
  public:
    explicit Collector(std::string_view svg) : svg_(svg) {}

    SvgWithTexts collected(const pugi::xml_node& root) {
        walk(root, 0);
        made_.svg.append(svg_.substr(copied_));
        return std::move(made_);
    }

  private:
    void walk(const pugi::xml_node& parent, int depth) {
        if (depth > max_nesting) return;
        for (const pugi::xml_node& element : parent.children()) {
            if (element.type() != pugi::node_element || is_hidden(element)) continue;
            const std::string_view name = local_name(element);
            if (name == "text") take(element);
            if (name != "text" && !is_apart(name)) walk(element, depth + 1);
        }
    }

    void take(const pugi::xml_node& element) {
        std::string words = words_of_text(element, {});
        if (words.empty() || made_.texts.size() >= max_word_boxes) return;
        std::string id = element.attribute("id").value();
        if (id.empty()) {
            id = fmt::format("touchline-text-{}", made_.texts.size() + 1);
            if (!insert_id(element, id)) return;
        }
        made_.texts.push_back({std::move(words), std::move(id)});
    }

    /// Inserts it behind the element's name, so that all else stays as written.
    bool insert_id(const pugi::xml_node& element, const std::string& id) {
        const std::string_view name = element.name();
        const auto at =
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(element.offset_debug(), 0));
        if (at < copied_ || at == 0 || at + name.size() > svg_.size()) return false;
        if (svg_[at - 1] != '<' || svg_.substr(at, name.size()) != name) return false;
        made_.svg.append(svg_.substr(copied_, at + name.size() - copied_));
        made_.svg += fmt::format(" id=\"{}\"", id);
        copied_ = at + name.size();
        return true;
    }

    std::string_view svg_;
    std::size_t copied_ = 0;
    SvgWithTexts made_;
};

}  // namespace

SvgWithTexts with_ids(std::string_view svg) {
    pugi::xml_document document;
    const pugi::xml_node root = document.load_buffer(svg.data(), svg.size())
                                    ? child_named(document, "svg")
                                    : pugi::xml_node();
    if (!root) return {std::string(svg), {}};
    return Collector(svg).collected(root);
}

std::optional<TextBox> box_of(RsvgHandle* handle, const SvgText& text,
                              const RsvgRectangle& viewport) {
    RsvgRectangle ink{};
    GError* problem = nullptr;
    const gboolean is_known = rsvg_handle_get_geometry_for_layer(
        handle, ("#" + text.id).c_str(), &viewport, &ink, nullptr, &problem);
    if (problem != nullptr) g_error_free(problem);
    if (is_known == 0 || !(ink.width > 0.0 && ink.height > 0.0)) return std::nullopt;
    return TextBox{ink.x, ink.y, ink.x + ink.width, ink.y + ink.height};
}

}  // namespace touchline::decode
