// touchline-print: the kiosk starts it for one sheet, or to ask for a printer. It can write no file
// and start no program; of files it reads the system's alone, and it reaches CUPS by its socket
// alone, so that no other host is ever asked. It does not die with the kiosk: it ends by itself,
// and takes its job out of the spool first.
#include "app/isolation/process/descriptor.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/sandbox.h"
#include "app/printing/cups_job.h"
#include "app/printing/print_end.h"

#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include <sys/prctl.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int wrong_words = 2;

std::string cups_socket() {
    const std::string chosen = environment("CUPS_SERVER");
    return chosen.starts_with('/') ? chosen : "/run/cups/cups.sock";
}

/// `words`: `check QUEUE`, or `print QUEUE FORMAT` with the sheet in sealed memory.
int run(const std::vector<std::string>& words) {
    const bool is_check = words.size() == 2 && words[0] == "check";
    if (!is_check && !(words.size() == 3 && words[0] == "print")) return wrong_words;
    const Descriptor input(is_check ? -1 : worker_input);
    (void)prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL);  // no picture in a core dump
    (void)std::signal(SIGPIPE, SIG_IGN);
    if (!allow_only_reading_the_system()) return print_status_of(PrintEnd::not_started);
    const CupsQueue queue{cups_socket(), words[1]};
    if (is_check) return print_status_of(check_at_cups(queue, {}));
    const auto sheet = map_sealed(input, most_sheet_bytes);
    if (!sheet) return print_status_of(PrintEnd::not_started);
    return print_status_of(print_by_cups(queue, sheet->bytes(), words[2], {}));
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
