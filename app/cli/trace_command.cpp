#include "app/cli/commands.h"
#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/picture.h"
#include "app/documents/trace/page_views.h"

#include <fmt/format.h>

namespace touchline {
namespace {

GreyView view_of(const GreyPicture& picture) {
    return {picture.width, picture.height, picture.grey};
}

std::string json_of(const ThingBox& box) {
    return fmt::format(R"({{"left": {}, "top": {}, "right": {}, "bottom": {}}})",
                       json_number(box.left), json_number(box.top), json_number(box.right),
                       json_number(box.bottom));
}

std::string json_of(const NamedThing& thing) {
    return fmt::format(R"({{"name": "{}", "likelihood": {}, "place": {}}})", id_of(thing.name),
                       json_number(thing.likelihood), json_of(thing.box));
}

std::string json_of(const DrawnFace& face) {
    std::string parts;
    for (const Outline& outline : face.map.outlines)
        parts += (parts.empty() ? "" : ", ") + json_string(outline.label);
    return fmt::format(R"({{"parts": [{}], "place": {}}})", parts, json_of(face.part));
}

template <class Thing>
std::string json_list(const std::vector<Thing>& things) {
    std::string list;
    for (const Thing& thing : things) list += (list.empty() ? "" : ", ") + json_of(thing);
    return "[" + list + "]";
}

/// The report of the lines, and of the main things, the names and the faces found: their places as
/// shares of the picture's width and height, the largest first.
std::string report_of(const TracedMap& felt, const std::optional<MainThings>& things) {
    const std::string lines = felt.report.substr(0, felt.report.rfind("\n}"));
    if (!things) return lines + ",\n  \"figure\": null,\n  \"names\": [],\n  \"faces\": []\n}\n";
    return fmt::format(
        "{},\n  \"figure\": {{\"is_sure\": {}, \"area\": {}, \"contrast\": {}, \"things\": {}}},\n"
        "  \"names\": {},\n  \"faces\": {}\n}}\n",
        lines, things->is_sure, json_number(things->signs.area),
        json_number(things->signs.contrast), json_list(things->boxes), json_list(things->names),
        json_list(things->faces));
}

/// Both sentences, or the only one.
std::string told(const std::string& first, const std::string& second) {
    return first.empty() || second.empty() ? first + second : first + "; " + second;
}

}  // namespace

Result<std::string> run_trace(const TraceCommandOptions& options) {
    const auto seen = open_view(options.input, options.view, !options.figure.empty());
    if (!seen) return tl::unexpected(seen.error());
    if (is_own_map(seen->page) && !options.edges.empty())
        return failure(options.input +
                       ": its lines were drawn, not traced, and have no edges; choose "
                       "--view whole");
    const auto found = trace_view(*seen, {options.trace, !options.edges.empty()});
    if (!found) return tl::unexpected(found.error());
    Result<void> written = write_whole_file(options.output, format_map_svg(found->map));
    if (written && !options.report.empty()) {
        written = write_whole_file(options.report, report_of(*found, seen->things));
    }
    if (written && !options.edges.empty()) {
        written = write_png(options.edges, view_of(found->edges));
    }
    if (written && !options.figure.empty()) {
        written = write_png(options.figure, view_of(seen->things->mask));
    }
    return written.map([&] { return told(seen->note, found->warning); });
}

}  // namespace touchline
