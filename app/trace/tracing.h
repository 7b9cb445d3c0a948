// A page that was opened becomes the map that is felt, by workers that can do nothing else: no
// pixel of an untrusted picture and no line of it meets an algorithm in the process of the kiosk.
// Threads: any, each call by itself; a call waits for its worker, at most its deadline.
#pragma once

#include "app/decode/page.h"
#include "app/trace/photo_cut.h"
#include "app/trace/traced.h"
#include "config/types/result.h"
#include "vision/camera/frame.h"
#include "vision/simplify/trace.h"

#include <cstddef>
#include <memory>
#include <span>

namespace touchline {

/// Lines that a worker found, for every detail and zoom: sealed memory that only workers look into.
struct FoundLines {
    std::shared_ptr<const Descriptor> memory;
    std::size_t bytes = 0;
};

struct FirstTrace {
    FoundLines lines;
    Result<TracedMap> map;  // at the detail and zoom that were asked for
};

struct TraceRequest {
    TraceOptions options = {};
    bool wants_edges = false;  // with the first map
};

/// The lines of the page's pixels, its words left out, and a first map of them. Fails, with one
/// line, where there are none, and where the worker does.
[[nodiscard]] Result<FirstTrace> find_page_lines(const Page& page, const TraceRequest& request);

/// The map at another detail and zoom. Fails likewise.
[[nodiscard]] Result<TracedMap> trace_page_lines(const Page& page, const FoundLines& lines,
                                                 const TraceOptions& options);

/// The first map alone.
[[nodiscard]] Result<TracedMap> trace_page(const Page& page, const TraceRequest& request);

/// A photograph of what lies under the camera as a page.
[[nodiscard]] Result<Page> page_of_photo(const CameraFrame& frame, const PhotoCut& cut);

}  // namespace touchline
