// What happens at one simulated site, all of it from a seed: which faults, when, and how soon the
// motors must then be without torque. Threads: values and pure functions.
#pragma once

#include "tests/machines/sim/board/emulated_link.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// Random numbers from a seed, the same with every compiler and library; the standard library's
/// distributions are not.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    /// Returns separate dice for each purpose: what one purpose draws changes nothing for the
    /// others.
    [[nodiscard]] static Dice of(std::uint64_t seed, std::uint64_t purpose) {
        Dice dice(seed ^ (purpose * 0x9e3779b97f4a7c15ULL));
        return Dice(dice.next());
    }

    /// SplitMix64 (Steele, Lea and Flood, 2014).
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t mixed = state_;
        mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebULL;
        return mixed ^ (mixed >> 31U);
    }

    /// Returns a number from 0 to below 1, with 53 random bits.
    double share() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

    double between(double low, double high) { return low + (high - low) * share(); }

    /// Returns 0 to count - 1; count > 0.
    std::uint64_t below(std::uint64_t count) { return next() % count; }

    bool is_hit(double chance) { return share() < chance; }

  private:
    std::uint64_t state_;
};

/// What can go wrong at a simulated site. The order is that of sim_fault_kinds().
enum class SimFault : std::uint8_t {
    short_send,
    late_send,
    lost_send,
    stalled_send,
    late_reply,
    lost_reply,
    garbled_reply,
    cut_reply,
    duplicate_reply,
    empty_packet,
    stalled_reply,
    failed_reply,
    reset_board,
    unplugged_before,
    unplugged_after,
    lost_counts,
    angle_not_a_number,
    servo_late,
    machine_stands_still,
    kiosk_frozen,
    kiosk_hangs,
    screen_starved,
    kiosk_killed,
    servo_killed,
    servo_frozen,
    emergency_stop,
    hand_off,
    handle_thrown,
    decoder_hangs,
    decoder_crashes,
    decoder_lies,
    decoder_slow,
    stick_yanked,
    camera_lost,
    disk_full,
    clock_step,
    settings_corrupt,
    sound_lost,
    headphones_out,
};

inline constexpr std::size_t sim_fault_count = 39;

struct SimFaultKind {
    std::string_view name;
    LinkFault link = LinkFault::none;  // fault of the board's link
    double shortest_s = 0.0;           // of its duration, or of its delay
    double longest_s = 0.0;
    /// The most time from when it can be seen to zero torque; none: the force may go on. The bars
    /// are those of tests/machines/sim/loop: 1 ms for what a tick sees, 5 ms for what is stale, 20
    /// ms for a lost peer, and 10 ms for a send that hangs, which blocks the zero too. `wire_s` is
    /// added.
    std::optional<double> zero_s;
};

/// The time from the host's send to the board's motors.
inline constexpr double wire_s = 3e-4;

[[nodiscard]] std::span<const SimFaultKind> sim_fault_kinds();

[[nodiscard]] const SimFaultKind& kind_of(SimFault fault);

/// Returns nothing if no fault has this name.
[[nodiscard]] std::optional<SimFault> fault_named(std::string_view name);

/// All kinds, one bit each.
inline constexpr std::uint64_t all_faults = (std::uint64_t{1} << sim_fault_count) - 1;

[[nodiscard]] constexpr std::uint64_t bit_of(SimFault fault) {
    return std::uint64_t{1} << static_cast<unsigned>(fault);
}

struct PlannedVisit {
    double at_s = 0.0;
    double length_s = 0.0;  // then the visitor says goodbye, or walks away
    std::uint64_t seed = 0;
    // Where the site offers it:
    bool draws = false;   // somebody draws for the visitor
    bool prints = false;  // wants a sheet to take home
    bool reads = false;   // by the braille display
};

struct PlannedCause {
    double at_s = 0.0;
    SimFault fault = SimFault::short_send;
    double span_s = 0.0;  // how long it lasts, or how late it is
    std::uint64_t seed = 0;
};

/// What a site has beside.
struct SiteOffers {
    bool drawing = false;
    bool printer = false;
    bool braille = false;
};

struct PlanOptions {
    std::uint64_t seed = 1;
    double span_s = 3600.0;             // site time
    std::uint64_t faults = all_faults;  // kinds that may occur
    double until_s = 1e9;               // no fault begins later; narrows down which ones matter
    bool is_plain = false;              // nothing of SiteOffers, as all sites were at first
};

struct Plan {
    PlanOptions options;
    SiteOffers offers;
    std::vector<PlannedVisit> visits;  // by time, far enough apart
    std::vector<PlannedCause> causes;  // by time
};

/// Each kind of fault has its own dice: leaving one out changes nothing for the others. Each seed
/// leaves some kinds out altogether, and one seed in eight leaves all out. The same holds for what
/// a site offers: where it offers nothing, all is as if it were plain.
[[nodiscard]] Plan make_plan(const PlanOptions& options);

/// Returns the plan for people, one event a line.
[[nodiscard]] std::string text_of(const Plan& plan);

}  // namespace touchline
