// Headphones by the switch of the sound chip, which Linux has as an input device.
// Threads: one.
#pragma once

#include "app/process/descriptor.h"
#include "app/sound/switch_stream.h"
#include "audio-cues/output/headphones.h"

#include <functional>
#include <optional>
#include <string>

namespace touchline {

/// An input device that has the switch, open for reading without waiting.
struct SwitchDevice {
    Descriptor file;
    std::optional<bool> are_in;  // as it says now
};

/// Nothing for a file that is no such device, or may not be read.
[[nodiscard]] std::optional<SwitchDevice> open_switch(const std::string& path);

/// Looks for one every `retry_s` while there is none: a sound card may come later, or go.
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
    std::string path_;  // of the device that is open
    Descriptor file_;
    SwitchStream stream_;
    double looked_s_ = -retry_s;
};

}  // namespace touchline
