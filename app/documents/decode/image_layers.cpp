
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/svg_nodes.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace touchline {
namespace decode {
namespace {

constexpr const char* layer_mark = "data-image-layer";

std::string saved(const pugi::xml_document& document) {
    std::ostringstream made;
    document.save(made, "", pugi::format_raw);
    return made.str();
}

using Texts = std::map<std::string, std::string>;

/// The texts that aria-labelledby and aria-describedby can name.
Texts texts_by_id(const pugi::xml_node& root) {
    Texts texts;
    for_each_element(root, [&texts](const pugi::xml_node& element) {
        const std::string_view name = local_name(element);
        const std::string id = element.attribute("id").value();
        if (id.empty() || (name != "desc" && name != "title" && name != "text")) return;
        std::string words;
        append_words(words, element.child_value());
        texts.emplace(id, words);
    });
    return texts;
}

/// Reads an attribute that holds the text, or one that holds ids of texts, joined by blanks.
std::string words_by(const pugi::xml_node& element, const char* own, const char* named,
                     const Texts& texts) {
    std::string words;
    append_words(words, element.attribute(own).value());
    if (!words.empty()) return words;
    std::istringstream ids(element.attribute(named).value());
    for (std::string id; ids >> id;)
        if (const auto found = texts.find(id); found != texts.end())
            append_words(words, found->second);
    return words;
}

std::string name_of(const pugi::xml_node& element, const Texts& texts) {
    return words_by(element, "aria-label", "aria-labelledby", texts);
}

std::string long_words_of(const pugi::xml_node& element, const Texts& texts) {
    return words_by(element, "aria-description", "aria-describedby", texts);
}

/// The name of the nearest layer around it; empty if none has one.
std::string layer_name_around(const pugi::xml_node& shape, const Texts& texts) {
    int depth = 0;
    for (pugi::xml_node at = shape.parent(); at && depth <= max_nesting;
         at = at.parent(), ++depth) {
        if (at.attribute(layer_mark)) return name_of(at, texts);
    }
    return {};
}

void add_text(pugi::xml_node parent, const char* name, const std::string& text) {
    parent.prepend_child(name).text().set(text.c_str());
}

void name_shapes(pugi::xml_node root, const Texts& texts) {
    std::vector<pugi::xml_node> shapes;
    for_each_element(root, [&shapes](const pugi::xml_node& element) {
        if (is_shape(local_name(element))) shapes.push_back(element);
    });
    for (pugi::xml_node& shape : shapes) {
        if (!words_of_shape(shape, {}).empty()) continue;
        std::string name = name_of(shape, texts);
        if (name.empty()) name = layer_name_around(shape, texts);
        if (!name.empty()) add_text(shape, "title", name);
    }
}

/// "People: in the middle. Trees."
void describe_by_layers(pugi::xml_node root, const Texts& texts) {
    if (!words_in(root, "desc", {}).empty()) return;
    std::string all = long_words_of(root, texts);
    for_each_element(root, [&](const pugi::xml_node& element) {
        if (!element.attribute(layer_mark)) return;
        std::string sentence = name_of(element, texts);
        const std::string more = long_words_of(element, texts);
        if (!sentence.empty() && !more.empty()) sentence += ": ";
        sentence += more;
        if (sentence.empty()) return;
        if (!sentence.ends_with('.')) sentence += '.';
        append_words(all, sentence);
    });
    if (!all.empty()) add_text(root, "desc", all);
}

struct Box {
    double x0 = 0.0;
    double y0 = 0.0;
    double width = 0.0;
    double height = 0.0;
};

std::optional<Box> box_of(const pugi::xml_node& root) {
    Box box;
    if (const auto attribute = root.attribute("viewBox")) {
        SvgScanner scanner(attribute.value());
        scanner.skip_space();
        for (double* side : {&box.x0, &box.y0, &box.width, &box.height}) {
            const auto number = scanner.take_number();
            if (!number) return std::nullopt;
            *side = *number;
        }
    } else {
        box.width = parse_svg_length(root.attribute("width").value()).value_or(0.0);
        box.height = parse_svg_length(root.attribute("height").value()).value_or(0.0);
    }
    const bool has_size = box.width > 0.0 && box.height > 0.0;
    return has_size ? std::optional(box) : std::nullopt;
}

void set(pugi::xml_node element, const char* name, const std::string& value) {
    pugi::xml_attribute attribute = element.attribute(name);
    if (!attribute) attribute = element.append_attribute(name);
    attribute.set_value(value.c_str());
}

/// Puts everything drawn into one group, scaled and moved.
void fit(pugi::xml_node root, const Box& box, const Area& area) {
    const double width_mm = 1000.0 * area.width_m;
    const double height_mm = 1000.0 * area.height_m;
    const double scale = std::min(width_mm / box.width, height_mm / box.height);
    const double dx = (width_mm - scale * box.width) / 2.0 - scale * box.x0;
    const double dy = (height_mm - scale * box.height) / 2.0 - scale * box.y0;
    std::vector<pugi::xml_node> drawn;
    for (const pugi::xml_node& child : root.children()) {
        const std::string_view name = local_name(child);
        if (child.type() == pugi::node_element && name != "title" && name != "desc")
            drawn.push_back(child);
    }
    pugi::xml_node group = root.append_child("g");
    set(group, "transform", fmt::format("matrix({} 0 0 {} {} {})", scale, scale, dx, dy));
    for (const pugi::xml_node& child : drawn) group.append_move(child);
    set(root, "width", svg_number(width_mm) + "mm");
    set(root, "height", svg_number(height_mm) + "mm");
    set(root, "viewBox", fmt::format("0 0 {} {}", svg_number(width_mm), svg_number(height_mm)));
}

/// Replaces the element's children of this name by one text, or by none.
void say_once(pugi::xml_node element, const char* name, const std::string& text) {
    std::vector<pugi::xml_node> old;
    for (const pugi::xml_node& child : element.children())
        if (child.type() == pugi::node_element && local_name(child) == name) old.push_back(child);
    for (const pugi::xml_node& child : old) element.remove_child(child);
    if (!text.empty()) add_text(element, name, text);
}

constexpr std::array<const char*, 5> layer_names{"Silhouette", "Large parts", "Parts",
                                                 "Small parts", "Details"};

bool has_shapes(const pugi::xml_node& element) {
    return std::any_of(element.begin(), element.end(),
                       [](const pugi::xml_node& child) { return is_shape(local_name(child)); });
}

int detail_of(const pugi::xml_node& shape) {
    return std::clamp(shape.attribute("data-detail").as_int(1), 1, 5);
}

/// Moves the shapes of one group into a group per detail. Later groups continue the numbers of a
/// layer's name, because each layer is one element.
void group_by_detail(pugi::xml_node parent, std::map<int, int>& uses) {
    std::map<int, std::vector<pugi::xml_node>> by_detail;
    for (const pugi::xml_node& child : parent.children())
        if (child.type() == pugi::node_element && is_shape(local_name(child)))
            by_detail[detail_of(child)].push_back(child);
    for (const auto& [detail, shapes] : by_detail) {
        const int use = ++uses[detail];
        const std::string suffix = use == 1 ? "" : fmt::format("-{}", use);
        pugi::xml_node layer = parent.append_child("g");
        set(layer, layer_mark, fmt::format("detail-{}{}", detail, suffix));
        set(layer, "aria-label", layer_names[static_cast<std::size_t>(detail - 1)]);
        for (const pugi::xml_node& shape : shapes) layer.append_move(shape);
    }
}

}  // namespace
}  // namespace decode

bool has_image_layers(std::string_view text) {
    using namespace decode;
    pugi::xml_document document;
    const pugi::xml_node root = svg_root_in(text, document);
    bool found = false;
    for_each_element(root, [&found](const pugi::xml_node& element) {
        const bool is_named =
            element.attribute("aria-label") || element.attribute("aria-labelledby");
        found = found || element.attribute(layer_mark) ||
                (is_named && is_shape(local_name(element)) && words_of_shape(element, {}).empty());
    });
    return found;
}

Result<std::string> map_svg_of_image_layers(std::string_view text, const Area& area) {
    using namespace decode;
    pugi::xml_document document;
    const pugi::xml_node root = svg_root_in(text, document);
    if (!root) return failure("the picture is no SVG; save it again as SVG");
    const auto box = box_of(root);
    if (!box)
        return failure("the picture has no size; write viewBox=\"0 0 WIDTH HEIGHT\" in <svg>");
    const Texts texts = texts_by_id(root);
    name_shapes(root, texts);
    describe_by_layers(root, texts);
    if (!is_in_millimetres(root, box->width, box->height, area)) fit(root, *box, area);
    return saved(document);
}

Result<std::string> image_layers_of_map_svg(std::string_view text, const LanguageTag& language) {
    using namespace decode;
    pugi::xml_document document;
    const pugi::xml_node root = svg_root_in(text, document);
    if (!root) return failure("the picture is no SVG; save it again as SVG");
    std::vector<pugi::xml_node> shapes;
    std::vector<pugi::xml_node> groups;
    std::vector<pugi::xml_node> labels;
    for_each_element(root, [&](const pugi::xml_node& element) {
        const std::string_view name = local_name(element);
        if (is_shape(name)) shapes.push_back(element);
        if (name == "text") labels.push_back(element);
        if ((name == "g" || name == "a" || name == "svg") && has_shapes(element) &&
            !element.attribute(layer_mark))
            groups.push_back(element);
    });
    const auto words = [&](const char* name) { return words_in(root, name, language); };
    const std::string title = words("title");
    const std::string description = words("desc");
    say_once(root, "desc", description);
    say_once(root, "title", title);
    for (pugi::xml_node& label : labels) {
        const std::string said = words_of_text(label, language);
        label.remove_children();
        label.text().set(said.c_str());
    }
    for (pugi::xml_node& shape : shapes) {
        const std::string name = words_of_shape(shape, language);
        say_once(shape, "title", "");
        shape.remove_attribute("data-label");
        if (!name.empty()) set(shape, "aria-label", name);
    }
    std::map<int, int> uses;
    // The root itself is not visited above.
    if (has_shapes(root)) groups.insert(groups.begin(), root);
    for (const pugi::xml_node& group : groups) group_by_detail(group, uses);
    return saved(document);
}

}  // namespace touchline
