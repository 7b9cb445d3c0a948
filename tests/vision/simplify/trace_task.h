// A tracing task made from any bytes, a picture and its options, and what is wrong with the answer.
// Threads: pure functions.
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

/// The number of bytes in a task before those of its picture.
inline constexpr int task_bytes = 6;

/// Returns the task that these bytes mean: any class or none, any detail or all, four areas, zooms.
[[nodiscard]] TraceTask task_of(std::span<const std::uint8_t> bytes);

/// Returns a few words that identify a task.
[[nodiscard]] std::string words_for(const TraceTask& task);

/// The results of some tasks.
struct TraceTally {
    int tasks = 0;
    int maps = 0;
    int lines = 0;  // instead of a map
};

/// Traces the picture and judges the result: a sound map at each detail that keeps the rules of
/// touch (touch_rules.h), lies within its area and survives the way to another process and back, or
/// one clear line for a visitor. Returns one text per fault; empty if nothing is wrong.
[[nodiscard]] std::vector<std::string> faults_of(const TraceTask& task, TraceTally& tally);

}  // namespace touchline::testing
