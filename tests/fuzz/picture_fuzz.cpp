// Fuzzes the whole path from a picture to a map: any small picture, of any class and detail, gives
// a sound map that keeps the rules of touch, or one clear line for a visitor. What the bytes mean:
// tests/vision/simplify/trace_task.h.
#include "tests/vision/simplify/trace_task.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline::testing;
    const TraceTask task = task_of(std::span(data, size));
    TraceTally tally;
    for (const std::string& fault : faults_of(task, tally)) {
        std::fprintf(stderr, "%s: %s\n", words_for(task).c_str(), fault.c_str());
        abort();
    }
    return 0;
}
