// touchline-trace: a picture's lines, and maps of them.
#include "app/trace/trace_program.h"

namespace {

touchline::Result<touchline::TraceInput> as_it_is(std::span<const std::byte> bytes) {
    return touchline::TraceInput{{}, bytes};
}

}  // namespace

int main(int argc, char** argv) {
    touchline::run_trace_program({touchline::WorkerKind::trace, as_it_is}, argc, argv);
}
