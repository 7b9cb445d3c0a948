#include "app/printing/printing.h"

#include "app/isolation/process/child.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/sandbox/worker.h"
#include "config/types/map_bytes.h"
#include "config/types/steady_clock.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace touchline {
namespace {

/// Longer than touchline-print takes at its slowest: only a program that hangs is killed.
constexpr double print_deadline_s = 240.0;
constexpr double slice_s = 0.1;

/// As both programs take it.
std::string word_of(SheetKind kind) {
    return std::to_string(static_cast<int>(kind));
}

PrintEnd end_of_program(const std::string& program, const std::vector<std::string>& words,
                        std::span<const Descriptor* const> handed, const std::stop_token& stop) {
    auto child = Child::start(program, words, handed, StandardStreams::nothing);
    if (!child) return PrintEnd::not_started;
    const std::int64_t begin_ns = steady_now_ns();
    while (!child->ends_within(slice_s)) {
        if (stop.stop_requested()) return PrintEnd::out_of_time;
        if (1e-9 * static_cast<double>(steady_now_ns() - begin_ns) < print_deadline_s) continue;
        child->kill();
        (void)child->reap();
        return PrintEnd::no_answer;
    }
    const ChildEnd end = child->reap();
    if (end.signal != 0) return PrintEnd::no_answer;
    return print_end_of(end.status).value_or(PrintEnd::not_started);
}

}  // namespace

Result<Descriptor, PrintEnd> sheet_of(const TactileMap& map, const PrintOrder& order,
                                      const PrintPrograms& programs) {
    const auto bytes = bytes_of(map);
    if (!bytes) return tl::unexpected(PrintEnd::no_sheet);
    const auto input = sealed_copy(*bytes);
    if (!input) return tl::unexpected(PrintEnd::not_started);
    auto sheet = run_worker({programs.sheet,
                             {word_of(order.kind), order.language, programs.words_folder},
                             WorkerKind::document},
                            *input);
    if (sheet) return std::move(*sheet);
    return tl::unexpected(sheet.error() == WorkerEnd::not_started ? PrintEnd::not_started
                                                                  : PrintEnd::no_sheet);
}

PrintEnd print_map(const TactileMap& map, const PrintOrder& order, const PrintPrograms& programs,
                   const std::stop_token& stop) {
    const auto sheet = sheet_of(map, order, programs);
    if (!sheet) return sheet.error();
    if (stop.stop_requested()) return PrintEnd::out_of_time;
    const std::array<const Descriptor*, 1> handed{&*sheet};
    return end_of_program(programs.print, {"print", order.queue, word_of(order.kind)}, handed,
                          stop);
}

PrintEnd check_printer(const std::string& queue, const PrintPrograms& programs,
                       const std::stop_token& stop) {
    return end_of_program(programs.print, {"check", queue}, {}, stop);
}

}  // namespace touchline
