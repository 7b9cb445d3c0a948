// A worker that lies as its input says, as a captured decoder, reader or tracer could. It replaces
// touchline-decode, touchline-read or touchline-trace (TOUCHLINE_PROGRAMS) and runs in the same
// sandbox.
#include "app/documents/decode/found_words.h"
#include "app/documents/trace/traced.h"
#include "app/isolation/process/descriptor.h"
#include "app/isolation/sandbox/sandbox.h"
#include "app/isolation/sandbox/worker.h"

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <sys/socket.h>
#include <unistd.h>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

Page honest_page() {
    Page page;
    page.picture = {2, 1, {1, 2, 3, 4, 5, 6}, 1.0};
    page.told.title = "honest";
    return page;
}

/// Words in the picture that the test hands to a reader.
FoundWords honest_words() {
    return {20, 1, {{0, 0, 2, 1}}, {0.002, 0.0001}, {{"honest", {0.0, 0.0}}}};
}

FoundWords words_elsewhere() {
    FoundWords words = honest_words();
    words.width = 21;
    return words;
}

TracedMap honest_trace() {
    TracedMap traced;
    traced.map.title = "honest";
    traced.map.outlines = {{{{0.0, 0.0}, {0.01, 0.0}}, false, "1", "a line"}};
    traced.report = "{}\n";
    return traced;
}

/// Returns the honest answer of the worker that it replaces.
Bytes honest_answer(WorkerKind kind) {
    switch (kind) {
        case WorkerKind::ocr:
            return answer_of(Result<FoundWords>(honest_words())).value();
        case WorkerKind::trace:
            return bytes_of(honest_trace(), Bytes(8)).value();
        default:
            return answer_of(Result<Page>(honest_page())).value();
    }
}

/// The end of the program's name tells its kind.
WorkerKind kind_of(std::string_view program) {
    if (program.ends_with("read")) return WorkerKind::ocr;
    return program.ends_with("trace") ? WorkerKind::trace : WorkerKind::raster;
}

void put(const Bytes& bytes) {
    const Descriptor output(worker_output);
    (void)write_all(output, bytes);
    _exit(0);
}

/// Returns the text after "liar ", which makes the input a file of no format; a reader and a tracer
/// get it as pixels.
std::string lie() {
    std::array<char, 128> text{};
    const ssize_t size = pread(worker_input, text.data(), text.size() - 1, 0);
    if (size < 0) _exit(9);
    const std::string whole(text.begin(), text.end());
    const auto start = whole.find("liar ");
    if (start == std::string::npos) _exit(9);
    return {whole.c_str() + start + 5};
}

void tell_lie(const std::string& lie, WorkerKind kind) {
    const Bytes page = honest_answer(WorkerKind::raster);
    Bytes answer = honest_answer(kind);
    if (lie == "honest") put(answer);
    if (lie == "a page") put(page);
    if (lie == "elsewhere") put(answer_of(Result<FoundWords>(words_elsewhere())).value());
    if (lie == "wrong magic") answer[0] ^= std::byte{1}, put(answer);
    if (lie == "wrong size") answer[24] ^= std::byte{1}, put(answer);
    if (lie == "huge header") answer[10] = answer[14] = std::byte{0x20}, put(answer);
    if (lie == "short") answer.pop_back(), put(answer);
    if (lie == "long") answer.resize(answer.size() + 1), put(answer);
    if (lie == "second header")
        answer.insert(answer.end(), answer.begin(), answer.end()), put(answer);
    if (lie == "header alone") answer.resize(28), put(answer);
    if (lie == "half a header") answer.resize(16), put(answer);
    if (lie == "noise") put(Bytes(1000, std::byte{0xa5}));
    if (lie == "hole") _exit(ftruncate(worker_output, 100'000'000) == 0 ? 0 : 1);
    if (lie == "nothing") _exit(0);
    if (lie == "status") _exit(3);
    if (lie == "abort") raise(SIGSEGV);
    if (lie == "crash") {
        const volatile std::uintptr_t nowhere = 8;
        *reinterpret_cast<volatile int*>(nowhere) = 1;
    }
    if (lie == "no lines") put(bytes_of(honest_trace(), {}).value());
    if (lie == "empty map") put(bytes_of(TracedMap{}, Bytes(8)).value());
    if (lie == "escapes") {
        TracedMap traced = honest_trace();
        traced.report = "\x1b[2J";
        put(bytes_of(traced, Bytes(8)).value());
    }
    if (lie == "figure outside") {
        Page with_figure = honest_page();
        with_figure.figures.push_back({{0, 0, 3, 1}, "beyond the edge"});
        put(answer_of(with_figure).value());
    }
    if (lie == "fork") _exit(fork() == 0 ? 0 : 1);
    if (lie == "connect") _exit(socket(AF_INET, SOCK_STREAM, 0));
    if (lie == "shout") {
        const std::string line(1U << 20U, '!');
        for (int i = 0; i < 1000; ++i) (void)!write(2, line.data(), line.size());
        put(answer);
    }
    if (lie == "fill") {
        const Bytes block(std::size_t{1} << 20U);
        const Descriptor output(worker_output);
        for (int i = 0; i < 1000; ++i) (void)write_all(output, block);
        _exit(0);
    }
    if (lie == "eat") {
        std::vector<Bytes> eaten;
        for (;;) eaten.emplace_back(std::size_t{64} << 20U, std::byte{1});
    }
    if (lie == "spin")
        for (volatile bool goes_on = true; goes_on;) {
        }
    if (lie == "sleep")
        for (;;) pause();
    _exit(8);
}

}  // namespace
}  // namespace touchline

int main(int /*argc*/, char** argv) {
    using namespace touchline;
    const WorkerKind kind = kind_of(argv[0]);
    try {
        if (!enter_sandbox(kind)) _exit(worker_refused_to_start);
        tell_lie(lie(), kind);
    } catch (const std::bad_alloc&) {
        _exit(worker_out_of_memory);
    }
}
