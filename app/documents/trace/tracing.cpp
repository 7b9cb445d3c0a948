#include "app/documents/trace/tracing.h"

#include "app/documents/decode/opening.h"
#include "app/documents/trace/page_views.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/limits.h"
#include "app/isolation/sandbox/worker.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace touchline {
namespace {

constexpr SaidOfEnds<const char*> said_of_outlines{
    "the part of Touchline that finds outlines cannot be started safely here; have it installed "
    "anew",
    "finding its outlines takes too long; choose a simpler picture",
    "finding its outlines needs too much memory; save it smaller",
    "its outlines could not be found safely; choose another picture"};

/// The input for finding a page's lines: the mask of its main things, if it has one, and the page.
Result<Sealed> input_of(const Page& page) {
    if (page.main_things.grey.empty()) return sealed(page);
    const std::vector<std::byte> mask = bytes_of(page.main_things);
    return sealed_behind({mask}, page);
}

Result<Sealed> worked(const TraceWork& work, const Descriptor& input) {
    auto answer =
        run_worker({companion("touchline-trace"), arguments_of(work), WorkerKind::trace}, input);
    if (!answer) return failure(said_of_outlines[answer.error()]);
    return std::make_shared<const Descriptor>(std::move(*answer));
}

/// Moves labels from the page's area to the map's; the picture is fitted in it, centred.
std::vector<Label> placed(std::vector<Label> labels, const Area& from, const Area& to) {
    const double scale = std::min(to.width_m / from.width_m, to.height_m / from.height_m);
    for (Label& label : labels) label.place = {scale * label.place.x, scale * label.place.y};
    return labels;
}

void tell(const Page& page, const TraceOptions& options, TactileMap& map) {
    map.title = page.told.title;
    map.description = page.told.description;
    map.labels = enlarged(placed(page.told.labels, page.told.area, options.area), options.area,
                          options.zoom);
}

struct Answer {
    FoundLines memory;
    Traced traced;
};

Result<Answer> traced_by(const TraceWork& work, const Descriptor& input, const Page& page) {
    const auto answer = worked(work, input);
    if (!answer) return tl::unexpected(answer.error());
    const auto mapped = map_sealed(**answer, limits_of(WorkerKind::trace).file_bytes);
    if (!mapped) return failure(said_of_outlines.unsafe);
    auto traced = traced_of(mapped->bytes());
    if (!traced) return tl::unexpected(traced.error());
    if (traced->map) tell(page, work.options, traced->map->map);
    return Answer{{*answer, mapped->bytes().size()}, std::move(*traced)};
}

Result<Sealed> shared(Result<Descriptor> memory) {
    if (!memory) return tl::unexpected(memory.error());
    return std::make_shared<const Descriptor>(std::move(*memory));
}

}  // namespace

Result<FirstTrace> find_page_lines(const Page& page, const TraceRequest& request) {
    const auto input = input_of(page);
    if (!input) return tl::unexpected(input.error());
    TraceWork work;
    work.options = request.options;
    work.wants_edges = request.wants_edges;
    work.has_main_things = !page.main_things.grey.empty();
    auto answer = traced_by(work, **input, page);
    if (!answer) return tl::unexpected(answer.error());
    Traced& traced = answer->traced;
    if (!traced.has_lines)
        return failure(traced.map ? said_of_outlines.unsafe : traced.map.error().line);
    return FirstTrace{std::move(answer->memory), std::move(traced.map)};
}

Result<TracedMap> trace_page_lines(const Page& page, const FoundLines& lines,
                                   const TraceOptions& options) {
    TraceWork work;
    work.step = TraceStep::map;
    work.options = options;
    return traced_by(work, *lines.memory, page).and_then([](Answer answer) {
        return std::move(answer.traced.map);
    });
}

Result<TracedMap> trace_page(const Page& page, const TraceRequest& request) {
    return find_page_lines(page, request).and_then([](FirstTrace first) {
        return std::move(first.map);
    });
}

Result<Page> page_of_photo(const CameraFrame& frame, const PhotoCut& cut) {
    const auto input = sealed_copy(bytes_of(frame));
    if (!input) return tl::unexpected(input.error());
    TraceWork work;
    work.step = TraceStep::photo;
    work.cut = cut;
    const auto answer = worked(work, *input);
    if (!answer) return tl::unexpected(answer.error());
    return page_in(*answer);
}

Result<Sealed> sealed(const Page& page) {
    if (page.answer) return page.answer;
    return shared(answer_of(page).and_then(
        [](const std::vector<std::byte>& bytes) { return sealed_copy(bytes); }));
}

Result<Sealed> sealed_behind(ThingsInBytes things, const Page& page) {
    const auto answer = sealed(page);
    if (!answer) return answer;
    const auto bytes = map_sealed(**answer, limits_of(WorkerKind::trace).input_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    things.push_back(bytes->bytes());
    return shared(sealed_copy(joined(things)));
}

}  // namespace touchline
