#include "app/trace/trace_program.h"

#include "app/decode/worker_program.h"
#include "app/trace/frame_bytes.h"
#include "app/trace/grey_bytes.h"
#include "app/trace/joined.h"
#include "app/trace/lines_bytes.h"
#include "app/trace/page_lines.h"
#include "app/trace/photo_page.h"
#include "app/trace/trace_report.h"
#include "app/trace/trace_work.h"
#include "app/trace/traced.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/utility.hpp>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

GreyPicture edges_of(const cv::Mat& strength) {
    return {strength.cols, strength.rows, {strength.data, strength.data + strength.total()}};
}

Result<TracedMap> traced(const Found& found, const TraceWork& work) {
    return trace_lines(found, work.options).map([&work](Trace trace) {
        TracedMap felt;
        felt.is_photo = trace.report.decision.picture_class == PictureClass::photo;
        felt.report = report_json(trace.map, trace.report);
        felt.warning = std::move(trace.report.warning);
        if (work.wants_edges) felt.edges = edges_of(trace.report.found.edge_strength);
        felt.map = std::move(trace.map);
        return felt;
    });
}

/// What a page's worker is handed: the page, and where they were found its main things.
struct PageInput {
    std::span<const std::byte> page;
    cv::Mat1b main_things;
};

Result<PageInput> page_input(std::span<const std::byte> input, const TraceWork& work) {
    if (!work.has_main_things) return PageInput{input, {}};
    const ThingsInBytes parts = parted(input, 2);
    if (parts.empty()) return failure("there is no page to find lines in");
    return grey_of(parts[0]).map([&parts](const GreyPicture& mask) {
        return PageInput{parts[1], cv::Mat1b(mask.grey, true).reshape(1, mask.height)};
    });
}

/// That there are no lines is an answer too.
Result<Bytes> lines_and_map(std::span<const std::byte> input, const TraceWork& work) {
    const auto found = page_input(input, work).and_then([&work](const PageInput& parts) {
        return find_lines_of_page(parts.page, work.options, parts.main_things);
    });
    if (!found) return bytes_of(tl::unexpected(found.error()), {});
    return bytes_of(traced(*found, work), bytes_of(*found));
}

Result<Bytes> map_of_lines(std::span<const std::byte> answer, const TraceWork& work) {
    return bytes_of(found_of(lines_in(answer)).and_then([&work](const Found& found) {
        return traced(found, work);
    }),
                    {});
}

Result<Bytes> page_of_photo(std::span<const std::byte> frame, const TraceWork& work) {
    return answer_of(frame_of(frame).and_then(
        [&work](const CameraFrame& seen) { return photo_page(seen, work.cut); }));
}

Result<Bytes> done(const TraceWork& work, std::span<const std::byte> input) {
    switch (work.step) {
        case TraceStep::photo:
            return page_of_photo(input, work);
        case TraceStep::lines:
            return lines_and_map(input, work);
        case TraceStep::map:
            return map_of_lines(input, work);
    }
    return failure("there is no such step");
}

}  // namespace

void run_trace_program(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto work = trace_work_in(arguments);
    if (!work) refuse_to_run(argv[0]);
    // Said before the worker is shut in: what TBB asks the system for its threads it asks here.
    cv::setNumThreads(cv::getNumberOfCPUs());
    run_worker_program({WorkerKind::trace, nullptr,
                        [&](std::span<const std::byte> bytes) { return done(*work, bytes); }});
}

}  // namespace touchline
