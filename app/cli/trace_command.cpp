#include "app/cli/trace_command.h"

#include "app/cli/load.h"
#include "app/decode/files.h"
#include "app/decode/map_svg.h"
#include "app/decode/png_writer.h"

namespace touchline {
namespace {

GreyView view_of(const GreyPicture& picture) {
    return {picture.width, picture.height, picture.grey};
}

}  // namespace

Result<std::string> run_trace(const TraceCommandOptions& options) {
    const auto found =
        trace_picture(options.input, {options.trace, !options.edges.empty()}, options.view);
    if (!found) return tl::unexpected(found.error());
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
