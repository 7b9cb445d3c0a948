// touchline-import: the kiosk starts it for one list or one file of a stick. It closes its sandbox,
// and only then reads the first name.
#include "app/documents/sticks/stick_reading.h"
#include "config/types/steady_clock.h"
#include "config/types/utf8.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int import_output = 3;

/// A listing that takes longer is sent as far as it got: visitors hear the first page within two
/// seconds.
constexpr std::int64_t list_time_ns = 1'500'000'000;

constexpr int wrong_words = 2;

int status_of(StickRefusal refusal) {
    return first_refusal_status + static_cast<int>(refusal);
}

int list(const Descriptor& root, const Descriptor& output, StickSearch search) {
    const NaturalOrder order;
    if (!shut_in(root, most_listing_bytes)) return status_of(StickRefusal::not_started);
    ScanLimits limits;
    limits.is_time_up = [end_ns = steady_now_ns() + list_time_ns] {
        return steady_now_ns() > end_ns;
    };
    const auto listing = scan_stick(root, order, limits, search);
    if (!listing) return status_of(listing.error());
    return write_all(output, bytes_of(*listing)) ? 0 : status_of(StickRefusal::unreadable);
}

int read(const Descriptor& root, const Descriptor& output, const std::vector<std::string>& words) {
    const auto most_bytes = number_in<std::size_t>(words[4]);
    if (!most_bytes) return wrong_words;
    if (!shut_in(root, *most_bytes)) return status_of(StickRefusal::not_started);
    const auto copied = copy_from_stick(root, words[2], words[3], output, {*most_bytes});
    return copied ? 0 : status_of(copied.error());
}

/// `words`: `list ROOT`, `operator ROOT` or `read ROOT FOLDER NAME MOST_BYTES`. Closes the sandbox,
/// reads, and writes the listing (listing.h) or the file's bytes to import_output. Returns the exit
/// status; the process must end with it at once.
int run_import(const std::vector<std::string>& words) {
    const bool is_list = words.size() == 2 && (words[0] == "list" || words[0] == "operator");
    const bool is_read = words.size() == 5 && words[0] == "read";
    if (!is_list && !is_read) return wrong_words;
    const Descriptor output(import_output);
    const Descriptor root(::open(words[1].c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!root.is_open()) return status_of(errno == ENOENT ? StickRefusal::gone : refusal_of(errno));
    if (is_read) return read(root, output, words);
    const bool is_operators = words[0] == "operator";
    return list(root, output, is_operators ? StickSearch::operator_files : StickSearch::pictures);
}

/// The C++ library would end by a forbidden signal.
[[noreturn]] void end_at_once() {
    _exit(status_of(StickRefusal::unreadable));
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    std::set_terminate(end_at_once);
    const int status = run_import({argv + 1, argv + argc});
    if (status == wrong_words)
        (void)std::fprintf(stderr,
                           "touchline-import: the kiosk starts it by itself; use 'touchline'\n");
    _exit(status);  // skips the exit code of libraries, which may want forbidden calls
}
