// A picture to be traced, and what is asked of the tracer, out of any bytes; and what is wrong with
// the answer. Threads: pure functions.
#pragma once

#include "tests/vision/pictures/odd_pictures.h"
#include "vision/simplify/trace.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline::testing {

struct TraceTask {
    TraceOptions options;
    std::vector<int> details;  // one, or all
    cv::Mat picture;
};

/// How many bytes of a task come before those of its picture.
inline constexpr int kTaskBytes = 6;

/// The task that these bytes mean: any class or none, any detail or all, four areas, zooms.
[[nodiscard]] TraceTask task_of(std::span<const std::uint8_t> bytes);

/// In a few words, to know a task by.
[[nodiscard]] std::string words_for(const TraceTask& task);

/// What came of some tasks.
struct TraceTally {
    int tasks = 0;
    int maps = 0;
    int lines = 0;  // instead of a map
};

/// Traces the picture and judges what comes: a sound map at each detail that keeps the rules of
/// touch (touch_rules.h), lies within its area and crosses to another process and back, or one
/// clear line for a visitor. One text a fault; empty: nothing is wrong.
[[nodiscard]] std::vector<std::string> faults_of(const TraceTask& task, TraceTally& tally);

}  // namespace touchline::testing
