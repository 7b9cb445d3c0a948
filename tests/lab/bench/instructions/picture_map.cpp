// The work that valgrind --tool=callgrind counts: the way from pixels to a map, once for a drawing
// of one megapixel and once for a photo. Each dump is named after its contents. Without valgrind
// the requests do nothing, and nothing is written.
#include "tests/lab/bench/instructions/pictures.h"
#include "vision/simplify/trace.h"

#include <cstdio>
#include <cstdlib>

#include <valgrind/callgrind.h>

/// The counted function: neither inlined nor cloned, with an unmangled name.
extern "C" [[gnu::noipa]] void touchline_picture_map(const cv::Mat& picture,
                                                     touchline::TactileMap& map) {
    map = touchline::trace_outlines(picture, {.area = {}, .detail = 5}).value().map;
}

namespace {

void count(const cv::Mat& picture, const char* name) {
    touchline::TactileMap map;
    touchline_picture_map(picture, map);  // builds once what is built only once, uncounted
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    touchline_picture_map(picture, map);
    CALLGRIND_DUMP_STATS_AT(name);
    CALLGRIND_STOP_INSTRUMENTATION;
    if (map.outlines.size() < 12) {
        std::fputs("what is counted is no work: hardly any lines were found\n", stderr);
        std::exit(EXIT_FAILURE);
    }
}

}  // namespace

int main() {
    cv::setNumThreads(1);
    count(touchline::bench::drawing(), "drawing 1MP 1");
    count(touchline::bench::photo(), "photo 1MP 1");
}
