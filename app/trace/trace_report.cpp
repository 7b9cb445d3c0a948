#include "app/trace/trace_report.h"

#include "app/cli/json.h"

#include <fmt/core.h>

namespace touchline {
namespace {

std::string parts_json(const TactileMap& map) {
    std::string parts;
    for (const Outline& outline : map.outlines) {
        parts += (parts.empty() ? "" : ", ") + json_string(outline.label);
    }
    return parts;
}

}  // namespace

std::string report_json(const TactileMap& map, const TraceReport& report) {
    const PhotoLines& found = report.found;
    const SimplifyReport& simple = report.simplified;
    return fmt::format(
        "{{\n  \"class\": {}, \"reason\": {},\n  \"outlines\": {}, \"points\": {}, \"line_mm\": "
        "{}, \"complexity\": {},\n"
        "  \"left_out\": {}, \"breaks_closed\": {}, \"crossings_opened\": {}, "
        "\"frames_dropped\": {},\n"
        "  \"lines_found\": {}, \"gaps_closed\": {}, \"junctions\": {}, \"specks_dropped\": {},\n"
        "  \"working_scale\": {}, \"pixels_per_metre\": {},\n"
        "  \"noise\": {}, \"smoothing_px\": {}, \"threshold_low\": {}, \"threshold_high\": {},\n"
        "  \"parts\": [{}],\n  \"words\": {},\n  \"warning\": {}\n}}\n",
        json_string(name_of(report.decision.picture_class)), json_string(report.decision.reason),
        report.outlines, report.points, json_number(simple.line_mm),
        json_string(word_of(simple.complexity)), simple.left_out, simple.breaks_closed,
        simple.crossings_opened, simple.frames_dropped, found.lines_found, found.gaps_closed,
        found.junctions, found.specks_dropped, json_number(report.working_scale),
        json_number(report.pixels_per_metre), json_number(found.noise),
        json_number(found.smoothing_px), json_number(found.low), json_number(found.high),
        parts_json(map), json_string(simple.words), json_string(report.warning));
}

}  // namespace touchline
