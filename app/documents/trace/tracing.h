// Turns an opened page into the map that is felt, in workers that can do nothing else. No algorithm
// in the kiosk's process touches a pixel of an untrusted picture or a line in it.
// Threads: any, each call by itself; a call waits for its worker, at most its deadline.
#pragma once

#include "app/documents/decode/page.h"
#include "app/documents/trace/trace_work.h"
#include "app/documents/trace/traced.h"
#include "app/isolation/process/descriptor.h"
#include "config/types/result.h"
#include "vision/camera/frame.h"
#include "vision/simplify/trace.h"

#include <cstddef>
#include <memory>

namespace touchline {

/// Lines that a worker found, for every detail and zoom, in sealed memory that only workers look
/// into.
struct FoundLines {
    std::shared_ptr<const Descriptor> memory;
    std::size_t bytes = 0;
};

struct FirstTrace {
    FoundLines lines;
    Result<TracedMap> map;  // at the requested detail and zoom
};

struct TraceRequest {
    TraceOptions options = {};
    bool wants_edges = false;  // with the first map
};

/// Finds the lines of the page's pixels, without its words, and makes a first map of them. Fails
/// with one line if there are none, or if the worker fails.
[[nodiscard]] Result<FirstTrace> find_page_lines(const Page& page, const TraceRequest& request);

/// The map at another detail and zoom. Fails likewise.
[[nodiscard]] Result<TracedMap> trace_page_lines(const Page& page, const FoundLines& lines,
                                                 const TraceOptions& options);

/// Only the first map.
[[nodiscard]] Result<TracedMap> trace_page(const Page& page, const TraceRequest& request);

/// The page in a photograph of what lies under the camera.
[[nodiscard]] Result<Page> page_of_photo(const CameraFrame& frame, const PhotoCut& cut);

using Sealed = std::shared_ptr<const Descriptor>;

/// The answer of the page's own worker, without a copy, if nothing has changed since.
[[nodiscard]] Result<Sealed> sealed(const Page& page);

/// The page after other things (traced.h): a copy of everything.
[[nodiscard]] Result<Sealed> sealed_behind(ThingsInBytes things, const Page& page);

}  // namespace touchline
