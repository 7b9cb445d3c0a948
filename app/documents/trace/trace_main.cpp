// touchline-trace: finds a picture's lines, and makes maps of them. The kiosk starts it for one
// step of one picture.
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/page.h"
#include "app/documents/decode/worker_program.h"
#include "app/documents/trace/page_lines.h"
#include "app/documents/trace/trace_work.h"
#include "app/documents/trace/traced.h"
#include "vision/camera/frame.h"
#include "vision/prepare/document.h"
#include "vision/simplify/trace.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <opencv2/core/utility.hpp>

namespace touchline {
namespace {

std::string parts_json(const TactileMap& map) {
    std::string parts;
    for (const Outline& outline : map.outlines) {
        parts += (parts.empty() ? "" : ", ") + json_string(outline.label);
    }
    return parts;
}

/// A JSON object of flat values, as lines of text. O(outlines).
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

constexpr std::int64_t photo_pixels = 2'000'000;  // more are averaged down

/// The page in the photograph, or the photograph if there is none.
Result<cv::Mat> what_lies_there(const cv::Mat& photo) {
    Document document = document_in(photo);
    if (!document.page.empty()) return std::move(document.page);
    if (document.trouble == CaptureTrouble::no_page) return photo;
    return failure(std::string(sentence(document.trouble)));
}

/// The page that was laid down, without the lamp's shade; the photograph as it is if no page is
/// found. Fails with one sentence that says what makes it unusable (too dark, a page that is cut
/// off). O(pixels).
Result<Page> photo_page(const CameraFrame& frame, const PhotoCut& cut) {
    const auto photo = to_bgr(frame, quick_size(frame.size, photo_pixels));
    if (!photo) return tl::unexpected(photo.error());
    const auto seen = what_lies_there(cut_off(*photo, cut));
    if (!seen) return tl::unexpected(seen.error());
    Page page;
    page.picture = picture_of(*seen);
    const double ratio = static_cast<double>(page.picture.height) / page.picture.width;
    page.told.area.height_m = page.told.area.width_m * ratio;
    return page;
}

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

/// The input of a page's worker: the page, and its main things if they were found.
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

/// A picture without lines is an answer too.
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
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto work = trace_work_in(arguments);
    if (!work) refuse_to_run(argv[0]);
    // Set before the sandbox closes: this is where TBB asks the system about its threads.
    cv::setNumThreads(cv::getNumberOfCPUs());
    run_worker_program({WorkerKind::trace, nullptr,
                        [&](std::span<const std::byte> bytes) { return done(*work, bytes); }});
}
