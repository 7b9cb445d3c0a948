// The largest of the recent values. Threads: plain values. No allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace touchline {

/// Holds the peaks of ten slots and of the running one: the window is ten to eleven slots long,
/// whatever the distance between values.
class PeakHold {
  public:
    static constexpr std::size_t slots = 10;

    /// slot > 0, in the unit of `advance` below.
    explicit PeakHold(double slot) : slot_(slot) {}

    /// Adds a value >= 0 that came `advance` > 0 after the one before. Returns the largest in the
    /// window; NaN is ignored.
    double step(double value, double advance) {
        age_ += advance;
        if (age_ >= slot_) begin_slots();
        peaks_[newest_] = std::max(peaks_[newest_], value);
        return std::max(older_, peaks_[newest_]);
    }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return newest_ < peaks_.size() && slot_ > 0.0; }

  private:
    /// A long advance may outlast several slots; each is emptied as it begins.
    void begin_slots() {
        for (std::size_t i = 0; age_ >= slot_ && i <= slots; ++i) {
            age_ -= slot_;
            newest_ = (newest_ + 1) % peaks_.size();
            peaks_[newest_] = 0.0;
        }
        age_ = std::min(age_, slot_);
        older_ = *std::max_element(peaks_.begin(), peaks_.end());
    }

    double slot_;
    double age_ = 0.0;                       // of the running slot
    std::array<double, slots + 1> peaks_{};  // of the running slot and the ten before it
    std::size_t newest_ = 0;
    double older_ = 0.0;  // largest of the ten
};

}  // namespace touchline
