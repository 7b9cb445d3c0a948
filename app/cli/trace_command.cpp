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

std::string report_json(const TraceReport& report) {
    return fmt::format(
        "{{\n  \"outlines\": {}, \"points\": {},\n"
        "  \"lines_found\": {}, \"gaps_closed\": {}, \"junctions\": {},\n"
        "  \"specks_dropped\": {}, \"over_budget\": {}, \"over_detail\": {},\n"
        "  \"working_scale\": {}, \"pixels_per_metre\": {},\n"
        "  \"noise\": {}, \"smoothing_px\": {}, \"threshold_low\": {}, \"threshold_high\": {},\n"
        "  \"warning\": {}\n}}\n",
        report.outlines, report.points, report.lines_found, report.gaps_closed, report.junctions,
        report.specks_dropped, report.over_budget, report.over_detail,
        json_number(report.working_scale), json_number(report.pixels_per_metre),
        json_number(report.noise), json_number(report.smoothing_px), json_number(report.low),
        json_number(report.high), json_string(report.warning));
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
        written = write_whole_file(options.report, report_json(found->report));
    }
    if (written && !options.edges.empty()) {
        written = write_png(options.edges, view_of(found->edge_strength));
    }
    return written.map([&found] { return found->report.warning; });
}

}  // namespace touchline
