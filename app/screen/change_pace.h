// Limits how often an area of the screen changes: two changes a second, so at most one flash a
// second (accessibility VI-4). Threads: a plain value.
#pragma once

#include <cstdint>
#include <optional>

namespace touchline {

class ChangePace {
  public:
    /// True if a change may be shown now. A single change is shown at once; a third within a second
    /// waits until the first is a second old. `now_ns` never goes back.
    [[nodiscard]] bool may_change(std::int64_t now_ns) const {
        constexpr std::int64_t second_ns = 1'000'000'000;
        return !before_last_ns_ || now_ns - *before_last_ns_ >= second_ns;
    }

    /// True if there was any change at all.
    [[nodiscard]] bool has_changed() const { return last_ns_.has_value(); }

    void changed(std::int64_t now_ns) {
        before_last_ns_ = last_ns_;
        last_ns_ = now_ns;
    }

  private:
    std::optional<std::int64_t> last_ns_;
    std::optional<std::int64_t> before_last_ns_;
};

}  // namespace touchline
