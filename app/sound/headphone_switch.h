// Detects headphones by the sound chip's switch, a Linux input device.
// Threads: one.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "audio-cues/output/outputs.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
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

/// An input device that has the switch, open for non-blocking reading.
struct SwitchDevice {
    Descriptor file;
    std::optional<bool> are_in;  // the device's present state
};

/// Nothing if the file is no such device, or may not be read.
[[nodiscard]] std::optional<SwitchDevice> open_switch(const std::string& path);

/// Looks for a device every `retry_s` while there is none: a sound card may come later, or go.
class HeadphoneSwitch final : public HeadphonePresence {
  public:
    using Open = std::function<std::optional<SwitchDevice>(const std::string& path)>;

    explicit HeadphoneSwitch(std::string folder = "/dev/input", Open open = open_switch)
        : folder_(std::move(folder)), open_(std::move(open)) {}

    [[nodiscard]] std::optional<bool> are_in(double now_s) override;

    static constexpr double retry_s = 2.0;

  private:
    void look_for_one(double now_s);
    bool read_events();

    std::string folder_;
    Open open_;
    std::string path_;  // of the open device
    Descriptor file_;
    SwitchStream stream_;
    double looked_s_ = -retry_s;
};

}  // namespace touchline
