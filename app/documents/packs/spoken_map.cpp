#include "app/documents/packs/spoken_map.h"

#include "app/documents/decode/map_svg.h"
#include "config/types/map_frame.h"

#include <cstddef>
#include <string_view>

#include <fmt/core.h>

namespace touchline {
namespace {

std::string escaped(std::string_view text) {
    std::string made;
    for (const char c : text) {
        switch (c) {
            case '&':
                made += "&amp;";
                break;
            case '<':
                made += "&lt;";
                break;
            case '>':
                made += "&gt;";
                break;
            case '"':
                made += "&quot;";
                break;
            default:
                made += c;
        }
    }
    return made;
}

/// A <title> or <desc> for each language that has the text; `of`: a text of MapWords.
template <class Of>
std::string in_languages(const char* element, const std::vector<MapWords>& words, Of of) {
    std::string made;
    for (const MapWords& each : words) {
        const std::string text = of(each);
        if (text.empty()) continue;
        const std::string language =
            &each == &words.front() ? "" : fmt::format(" xml:lang=\"{}\"", escaped(each.language));
        made += fmt::format("<{0}{1}>{2}</{0}>", element, language, escaped(text));
    }
    return made;
}

std::string outline_as_svg(const TactileMap& map, std::size_t i,
                           const std::vector<MapWords>& words) {
    const Outline& outline = map.outlines[i];
    const std::string id = outline.id.empty() ? "" : fmt::format(" id=\"{}\"", escaped(outline.id));
    return fmt::format(
        "    <path{} data-weight=\"{}\" data-detail=\"{}\" d=\"{}\">{}</path>\n", id,
        svg_number(outline.weight), outline.detail,
        path_data(outline.points, outline.is_closed, view_box_of(map.area)),
        in_languages("title", words, [i](const MapWords& each) { return each.parts[i]; }));
}

std::string label_as_svg(const TactileMap& map, std::size_t i, const std::vector<MapWords>& words) {
    const ViewBoxPoint place = to_view_box(map.labels[i].place, view_box_of(map.area));
    const std::vector<MapWords> others(words.begin() + 1, words.end());
    std::string titles;
    for (const MapWords& each : others)
        if (!each.labels[i].empty())
            titles += fmt::format("<title xml:lang=\"{}\">{}</title>", escaped(each.language),
                                  escaped(each.labels[i]));
    return fmt::format("    <text data-label=\"1\" x=\"{}\" y=\"{}\">{}{}</text>\n",
                       svg_number(place.u_mm), svg_number(place.v_mm),
                       escaped(words.front().labels[i]), titles);
}

}  // namespace

std::string spoken_map_svg(const TactileMap& map, const std::vector<MapWords>& words) {
    const ViewBox box = view_box_of(map.area);
    const std::string width = svg_number(box.width_mm);
    const std::string height = svg_number(box.height_mm);
    std::string made = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
        "viewBox=\"0 0 {0} {1}\">\n",
        width, height);
    made +=
        "  " + in_languages("title", words, [](const MapWords& each) { return each.title; }) + '\n';
    made += "  " +
            in_languages("desc", words, [](const MapWords& each) { return each.description; }) +
            '\n';
    made +=
        "  <g fill=\"none\" stroke=\"black\" stroke-width=\"0.6\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < map.outlines.size(); ++i) made += outline_as_svg(map, i, words);
    made += "  </g>\n  <g font-family=\"sans-serif\" font-size=\"4\">\n";
    for (std::size_t i = 0; i < map.labels.size(); ++i) made += label_as_svg(map, i, words);
    return made + "  </g>\n</svg>\n";
}

}  // namespace touchline
