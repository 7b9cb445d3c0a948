#include "app/cli/trace_command.h"

#include "app/cli/load.h"
#include "app/decode/files.h"
#include "app/decode/map_svg.h"
#include "app/decode/png_writer.h"
#include "vision/contour/edge_model.h"

#include <vector>

namespace touchline {
namespace {

GreyView view_of(const EdgePicture& edges) {
    return {edges.width, edges.height, edges.grey};
}

Result<std::vector<std::byte>> network_of(const std::string& path) {
    if (path.empty()) return std::vector<std::byte>();
    auto bytes = read_file(path);
    if (bytes && bytes->empty())
        return failure(path + ": " + std::string(unusable_edge_model) + ", because it is empty");
    return bytes;
}

/// The line begins with that of the two files which it is about.
Error about_file(const Error& error, const std::string& edge_model) {
    const auto at = error.line.find(unusable_edge_model);
    if (edge_model.empty() || at == std::string::npos) return error;
    return {edge_model + ": " + error.line.substr(at)};
}

}  // namespace

Result<std::string> run_trace(const TraceCommandOptions& options) {
    const auto network = network_of(options.edge_model);
    if (!network) return tl::unexpected(network.error());
    const auto found = trace_picture(
        options.input, {options.trace, !options.edges.empty(), *network}, options.view);
    if (!found) return tl::unexpected(about_file(found.error(), options.edge_model));
    Result<void> written = write_whole_file(options.output, format_map_svg(found->map));
    if (written && !options.report.empty()) {
        written = write_whole_file(options.report, found->report);
    }
    if (written && !options.edges.empty()) {
        written = write_png(options.edges, view_of(found->edges));
    }
    return written.map([&found] { return found->warning; });
}

}  // namespace touchline
