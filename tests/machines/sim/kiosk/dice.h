// Random numbers from a seed, the same with every compiler and library; the standard library's
// distributions are not. Threads: a plain value.
#pragma once

#include <cstdint>

namespace touchline {

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

}  // namespace touchline
