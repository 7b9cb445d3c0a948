#include "app/documents/decode/worker_program.h"

#include "app/isolation/process/descriptor.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/sandbox/sandbox.h"
#include "app/isolation/sandbox/worker.h"

#include <cstdio>
#include <new>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

/// Maps the memory that the kiosk sealed, so that a large picture is not copied again.
Result<Mapping> map_input(const WorkerLimits& limits) {
    FileStatus status{};
    if (::fstat(worker_input, &status) != 0 || !S_ISREG(status.st_mode))
        return failure("the file cannot be read");
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > limits.input_bytes)
        return failure("the file is larger than " + std::to_string(limits.input_bytes >> 20U) +
                       " MiB; save it smaller");
    if (size == 0) return Mapping(nullptr, 0);
    void* const start = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, worker_input, 0);
    if (start == MAP_FAILED) return failure("the file cannot be read");
    return Mapping(start, size);
}

/// Returns 0 if it answered.
int answer(const WorkerProgram& program) {
    auto bytes = map_input(limits_of(program.kind)).and_then([&program](const Mapping& input) {
        return program.work(input.bytes());
    });
    if (!bytes) bytes = answer_of(Result<Page>(failure(bytes.error().line)));
    if (!bytes) return 1;
    const Descriptor output(worker_output);
    return write_all(output, *bytes) ? 0 : 1;
}

Result<void> shut_in(const WorkerProgram& program) {
    if (!program.prepare) return enter_sandbox(program.kind);
    return allow_only_reading_the_system().and_then([&program] {
        program.prepare();
        return enter_sandbox(program.kind);
    });
}

}  // namespace

void run_worker_program(const WorkerProgram& program) {
    try {
        if (!shut_in(program)) _exit(worker_refused_to_start);
        _exit(answer(program));  // skips the exit code of libraries, which may want forbidden calls
    } catch (const std::bad_alloc&) {
        _exit(worker_out_of_memory);
    }
}

void refuse_to_run(const char* program) {
    std::fprintf(stderr, "%s: the kiosk starts it by itself; use 'touchline'\n", program);
    _exit(2);
}

void run_decode_program(const Decoder& decoder, int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto work = work_in(arguments);
    if (!work) refuse_to_run(argv[0]);
    run_worker_program({work->kind, decoder.prepare, [&](std::span<const std::byte> bytes) {
                            return answer_of(decoder.decode(bytes, work->order));
                        }});
}

}  // namespace touchline
