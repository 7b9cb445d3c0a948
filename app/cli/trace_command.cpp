#include "app/cli/trace_command.h"

#include "app/cli/json.h"
#include "app/cli/load.h"
#include "app/decode/files.h"
#include "app/decode/map_svg.h"
#include "app/decode/png_writer.h"

#include <optional>
#include <utility>
#include <vector>

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

Result<EdgeModel> read_edge_model(const std::string& path) {
    return read_file(path).and_then([&path](const std::vector<std::byte>& bytes) {
        return EdgeModel::from_onnx(bytes).map_error(
            [&path](const Error& error) { return Error{path + ": " + error.line}; });
    });
}

GreyView view_of(const cv::Mat& grey) {
    return {grey.cols, grey.rows, {grey.data, grey.total()}};
}

}  // namespace

Result<std::string> run_trace(const TraceCommandOptions& options) {
    std::optional<EdgeModel> model;
    TraceOptions trace = options.trace;
    if (!options.edge_model.empty()) {
        Result<EdgeModel> read = read_edge_model(options.edge_model);
        if (!read) return tl::unexpected(read.error());
        trace.edge_model = &model.emplace(std::move(*read));
    }
    const Result<Trace> found = trace_picture(options.input, trace);
    if (!found) return tl::unexpected(found.error());
    Result<void> written = write_whole_file(options.output, format_map_svg(found->map));
    if (written && !options.report.empty()) {
        written = write_whole_file(options.report, report_json(found->map, found->report));
    }
    if (written && !options.edges.empty()) {
        written = write_png(options.edges, view_of(found->report.found.edge_strength));
    }
    return written.map([&found] { return found->report.warning; });
}

}  // namespace touchline
