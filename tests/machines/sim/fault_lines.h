// The outcome of one run of a fault, for every way to reach the board. The tests judge the runs and
// report them here; tests/machines/sim/faults makes its table from the reports. Threads: one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// left_out: umockdev opens its own sockets and closes them at any time.
enum class Sockets : std::uint8_t { counted, left_out };

/// Held resources: descriptors of a process, bytes of a thread.
struct Holdings {
    int descriptors = 0;
    std::int64_t bytes = 0;

    /// Returns what this thread and process hold now. Under a sanitizer, which looks for leaks
    /// itself, the bytes are 0.
    [[nodiscard]] static Holdings now(Sockets sockets = Sockets::counted);

    friend Holdings operator-(const Holdings& a, const Holdings& b) {
        return {a.descriptors - b.descriptors, a.bytes - b.bytes};
    }
};

/// Returns the count for any process of this user; 0 if there is no such process.
[[nodiscard]] int open_descriptors(int pid, Sockets sockets = Sockets::counted);

struct FaultLine {
    std::string_view way;    // driver, servo, libusb, processes
    std::string_view fault;  // what happened
    std::uint64_t seed = 0;
    std::optional<double>
        zero_s;         // from when it could be seen to zero torque; none: torque went on
    std::string state;  // the worst of the run, and what was said
    std::optional<double> back_s;  // until torque was back; none: not before the run ended
    bool is_back_by_itself = false;
    Holdings left;  // more than before the run
};

/// Returns a fault's name in a form that GoogleTest accepts.
[[nodiscard]] std::string test_name(std::string_view fault);

/// Adds a line to the file that TOUCHLINE_FAULT_LINES names, if it is set.
void tell(const FaultLine& line);

/// Returns the number of seeds for each kind of fault: `everyday`, or `all` if TOUCHLINE_EXHAUSTIVE
/// is set.
[[nodiscard]] std::uint64_t fault_runs(std::uint64_t everyday, std::uint64_t all = 100);

}  // namespace touchline
