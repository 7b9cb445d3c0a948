// Random numbers, the same for the same seed. Threads: one object, one thread.
#pragma once

#include <random>

namespace touchline::testing {

class Chance {
  public:
    explicit Chance(int seed) : engine_(static_cast<unsigned>(seed)) {}

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }

    /// Returns 0 ... n - 1.
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }

    bool coin() { return below(2) == 0; }

  private:
    std::mt19937 engine_;
};

}  // namespace touchline::testing
