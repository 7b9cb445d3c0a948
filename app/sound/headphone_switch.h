// Detects headphones by the sound chip's switch, a Linux input device.
// Threads: one.
#pragma once

#include "app/process/descriptor.h"
#include "app/sound/switch_stream.h"
#include "audio-cues/output/headphones.h"

#include <functional>
#include <optional>
#include <string>

namespace touchline {

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
