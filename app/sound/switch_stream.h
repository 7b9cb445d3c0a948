// Reads the state of the headphone switch from an input device's bytes.
// Threads: one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// Takes the bytes as they come, whole events or parts (struct input_event of linux/input.h).
/// O(bytes).
class SwitchStream {
  public:
    /// `are_in`: the state that the device reported when asked; nothing if it reported none.
    explicit SwitchStream(std::optional<bool> are_in = std::nullopt) : are_in_(are_in) {}

    void add(std::span<const std::byte> bytes);

    /// The state by the last event of the switch SW_HEADPHONE_INSERT; ignores all other events.
    [[nodiscard]] std::optional<bool> are_in() const { return are_in_; }

    /// True if the device dropped events because they were not read in time; ask it again.
    [[nodiscard]] bool is_lost() const { return is_lost_; }

  private:
    void take_event(std::span<const std::byte> bytes);

    std::vector<std::byte> part_;  // of an incomplete event
    std::optional<bool> are_in_;
    bool is_lost_ = false;
};

}  // namespace touchline
