// What an input device says of its headphone switch, from the bytes that it gives.
// Threads: one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// Takes the bytes as they come, whole events or parts of them (struct input_event of
/// linux/input.h). O(bytes).
class SwitchStream {
  public:
    /// `are_in`: what the device said when it was asked; nothing where it did not say.
    explicit SwitchStream(std::optional<bool> are_in = std::nullopt) : are_in_(are_in) {}

    void add(std::span<const std::byte> bytes);

    /// By the last event of the switch SW_HEADPHONE_INSERT; all others are passed over.
    [[nodiscard]] std::optional<bool> are_in() const { return are_in_; }

    /// The device gave more than was read, and dropped some: it has to be asked again.
    [[nodiscard]] bool is_lost() const { return is_lost_; }

  private:
    void take_event(std::span<const std::byte> bytes);

    std::vector<std::byte> part_;  // of an event that is not whole yet
    std::optional<bool> are_in_;
    bool is_lost_ = false;
};

}  // namespace touchline
