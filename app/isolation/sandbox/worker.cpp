#include "app/isolation/sandbox/worker.h"

#include "app/isolation/process/child.h"

#include <array>
#include <csignal>
#include <limits>
#include <optional>

namespace touchline {
namespace {

/// Nothing if it ended normally. SIGKILL that is not ours is the kernel's, which has no memory
/// left.
std::optional<WorkerEnd> trouble_of(const ChildEnd& end) {
    if (end.signal == SIGXCPU) return WorkerEnd::out_of_time;
    if (end.signal == SIGKILL) return WorkerEnd::out_of_memory;
    if (end.signal != 0) return WorkerEnd::crashed;
    if (end.status == worker_refused_to_start) return WorkerEnd::not_started;
    if (end.status == worker_out_of_memory) return WorkerEnd::out_of_memory;
    if (end.status != 0) return WorkerEnd::crashed;
    return std::nullopt;
}

// Variables that libraries read before `main`. Threads: a worker cannot have any. OpenMP would end
// the program for lack of them, and OpenBLAS, which OpenCV may bring along, would start its own
// before the sandbox closes. Memory: a worker lives for one picture, so it keeps freed memory, in
// large pages. Otherwise the kernel hands out a page at a time, which costs a fifth of a tracer's
// time.
constexpr std::array worker_environment{
    "OMP_THREAD_LIMIT=1", "OPENBLAS_NUM_THREADS=1",
    "GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.arena_max=1:"
    "glibc.malloc.mmap_threshold=1073741824:glibc.malloc.trim_threshold=1073741824:"
    "glibc.malloc.top_pad=33554432"};

}  // namespace

Result<Descriptor, WorkerEnd> run_worker(const WorkerOrder& order, const Descriptor& input) {
    auto output = fresh_memory();
    if (!output) return tl::unexpected(WorkerEnd::out_of_memory);
    const std::array<const Descriptor*, 2> handed{&input, &*output};
    auto child = Child::start(order.program, order.arguments, handed, StandardStreams::nothing,
                              {worker_environment.begin(), worker_environment.end()});
    if (!child) return tl::unexpected(WorkerEnd::not_started);
    const double deadline_s = limits_of(order.kind).deadline_s;
    const bool has_ended =
        child->ends_within(deadline_s > 0.0 ? deadline_s : std::numeric_limits<double>::infinity());
    if (!has_ended) child->kill();
    const ChildEnd how = child->reap();
    if (!has_ended) return tl::unexpected(WorkerEnd::out_of_time);
    if (const auto trouble = trouble_of(how)) return tl::unexpected(*trouble);
    // Only now: while the worker lived, it could have mapped the memory for writing.
    if (is_empty(*output) || !seal(*output)) return tl::unexpected(WorkerEnd::no_answer);
    return std::move(*output);
}

Result<Mapping, WorkerEnd> call_worker(const WorkerOrder& order, const Descriptor& input) {
    const auto output = run_worker(order, input);
    if (!output) return tl::unexpected(output.error());
    return map_sealed(*output, limits_of(order.kind).file_bytes).map_error([](const Error&) {
        return WorkerEnd::no_answer;
    });
}

}  // namespace touchline
