// For libFuzzer: tests/fuzz/run.
#include "tests/fuzz/reply_fuzz.h"

#include <cstddef>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    touchline::feed_packets({data, size});
    return 0;
}
