#include "app/decode/decode_program.h"

#include "app/process/descriptor.h"
#include "app/sandbox/sandbox.h"
#include "app/sandbox/worker.h"

#include <cstdio>
#include <new>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

Result<std::vector<std::byte>> read_input(const WorkerLimits& limits) {
    struct stat status {};

    if (::fstat(worker_input, &status) != 0 || !S_ISREG(status.st_mode))
        return failure("the file cannot be read");
    if (static_cast<std::size_t>(status.st_size) > limits.input_bytes)
        return failure("the file is larger than " + std::to_string(limits.input_bytes >> 20U) +
                       " MiB; save it smaller");
    std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t got = 0;
    while (got < bytes.size()) {
        const ssize_t read =
            ::pread(worker_input, bytes.data() + got, bytes.size() - got, static_cast<off_t>(got));
        if (read <= 0) return failure("the file cannot be read");
        got += static_cast<std::size_t>(read);
    }
    return bytes;
}

/// 0: answered.
int answer(const Decoder& decoder, const DecodeWork& work) {
    const auto page = read_input(limits_of(work.kind)).and_then([&](const auto& bytes) {
        return decoder.decode(bytes, work.order);
    });
    const auto bytes = answer_of(page);
    if (!bytes) return 1;
    const Descriptor output(worker_output);
    return write_all(output, *bytes) ? 0 : 1;
}

Result<void> shut_in(const Decoder& decoder, WorkerKind kind) {
    if (decoder.prepare == nullptr) return enter_sandbox(kind);
    return allow_only_reading_the_system().and_then([&decoder, kind] {
        decoder.prepare();
        return enter_sandbox(kind);
    });
}

}  // namespace

void run_decode_program(const Decoder& decoder, int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto work = work_in(arguments);
    if (!work) {
        std::fprintf(stderr, "%s: the kiosk starts it by itself; use 'touchline'\n", argv[0]);
        _exit(2);
    }
    try {
        if (!shut_in(decoder, work->kind)) _exit(worker_refused_to_start);
        _exit(answer(decoder, *work));  // no library's farewell, which may want what it may not
    } catch (const std::bad_alloc&) {
        _exit(worker_out_of_memory);
    }
}

}  // namespace touchline
