// What came of one run of a fault, whichever way the board is reached. The tests judge the runs and
// tell them here; tests/sim/faults makes its table of what they told. Threads: one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// left_out: umockdev opens sockets of its own, and closes them when it likes.
enum class Sockets : std::uint8_t { counted, left_out };

/// What is held: descriptors of a process, bytes of a thread.
struct Holdings {
    int descriptors = 0;
    std::int64_t bytes = 0;

    /// Here. Under a sanitizer the bytes are 0: it looks for leaks itself.
    [[nodiscard]] static Holdings now(Sockets sockets = Sockets::counted);

    friend Holdings operator-(const Holdings& a, const Holdings& b) {
        return {a.descriptors - b.descriptors, a.bytes - b.bytes};
    }
};

/// Of any process of this user; 0 where there is none.
[[nodiscard]] int open_descriptors(int pid, Sockets sockets = Sockets::counted);

struct FaultLine {
    std::string_view way;    // driver, servo, libusb, processes
    std::string_view fault;  // what happened
    std::uint64_t seed = 0;
    std::optional<double>
        zero_s;         // from when it could be seen to zero torque; none: torque went on
    std::string state;  // the worst of the run, and what was said
    std::optional<double> back_s;  // until torque was there again; none: not yet when the run ended
    bool is_back_by_itself = false;
    Holdings left;  // more than before the run
};

/// A fault's name as GoogleTest takes one.
[[nodiscard]] std::string test_name(std::string_view fault);

/// Adds a line to the file that TOUCHLINE_FAULT_LINES names, if it does.
void tell(const FaultLine& line);

/// How many seeds a kind of fault is run with: so many, or with TOUCHLINE_EXHAUSTIVE set, `all`.
[[nodiscard]] std::uint64_t fault_runs(std::uint64_t everyday, std::uint64_t all = 100);

}  // namespace touchline
