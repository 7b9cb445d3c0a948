// touchline-print: the kiosk starts it for one sheet, or to ask for a printer. It can write no file
// and start no program; of files it reads the system's alone, and it reaches CUPS by its socket
// alone, so that no other host is ever asked. It does not die with the kiosk: it ends by itself. A
// service that is stopped ends it too, by a signal; then it takes its job back within some seconds.
#include "app/isolation/process/descriptor.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/sandbox.h"
#include "app/printing/cups_job.h"
#include "app/printing/print_end.h"
#include "config/types/choices.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int wrong_words = 2;

std::string cups_socket() {
    const std::string chosen = environment("CUPS_SERVER");
    return chosen.starts_with('/') ? chosen : "/run/cups/cups.sock";
}

/// What a service, a terminal and a desktop end programs with.
constexpr std::array ending_signals{SIGTERM, SIGINT, SIGHUP};

/// They wait until they are asked for: none can come between a job and its removal.
void hold_ending_signals() {
    sigset_t held;
    sigemptyset(&held);
    for (const int each : ending_signals) sigaddset(&held, each);
    (void)sigprocmask(SIG_BLOCK, &held, nullptr);
}

bool is_asked_to_end() {
    sigset_t come;
    return sigpending(&come) == 0 && std::ranges::any_of(ending_signals, [&come](int each) {
               return sigismember(&come, each) == 1;
           });
}

/// `words`: `check QUEUE`, or `print QUEUE KIND` with the sheet in sealed memory. KIND: a
/// SheetKind.
int run(const std::vector<std::string>& words) {
    const bool is_check = words.size() == 2 && words[0] == "check";
    const auto kind = words.size() == 3 && words[0] == "print"
                          ? number_in(words[2], 0, sheet_kind_count - 1)
                          : std::nullopt;
    if (!is_check && !kind) return wrong_words;
    hold_ending_signals();
    const Descriptor input(is_check ? -1 : worker_input);
    (void)prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL);  // no picture in a core dump
    (void)signal(SIGPIPE, SIG_IGN);
    if (!allow_only_reading_the_system()) return print_status_of(PrintEnd::not_started);
    const CupsQueue queue{cups_socket(), words[1]};
    const PrintPatience patience{.has_to_end = is_asked_to_end};
    if (is_check) return print_status_of(check_at_cups(queue, patience));
    const auto sheet = map_sealed(input, most_sheet_bytes);
    if (!sheet) return print_status_of(PrintEnd::not_started);
    return print_status_of(
        print_by_cups(queue, sheet->bytes(), static_cast<SheetKind>(*kind), patience));
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    const int status = touchline::run({argv + 1, argv + argc});
    if (status == touchline::wrong_words)
        (void)std::fprintf(stderr,
                           "touchline-print: the kiosk starts it by itself; use 'touchline'\n");
    return status;
}
