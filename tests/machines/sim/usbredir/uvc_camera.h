// A USB camera of the UVC class (1.1, bulk streaming): YUYV 640 x 480, and MJPEG without Huffman
// tables in two sizes; exposure can be held. It shows testing::scene(), the same in every frame.
// After USB Device Class Definition for Video Devices 1.1, with its MJPEG and uncompressed
// payloads.
#pragma once

#include "tests/machines/sim/usbredir/redirected_device.h"
#include "vision/camera/frame.h"

#include <array>
#include <vector>

namespace touchline {

class UvcCamera : public RedirectedFunction {
  public:
    /// The plug is pulled in the middle of the third frame after that many starts of the stream; 0:
    /// never.
    explicit UvcCamera(int unplug_after_starts);

    [[nodiscard]] std::uint8_t speed() const override { return usb_redir_speed_high; }

    [[nodiscard]] PacketBytes device() const override;
    [[nodiscard]] PacketBytes configuration() const override;
    [[nodiscard]] std::optional<PacketBytes> control(const UsbRequest& request,
                                                     std::span<const std::uint8_t> data) override;

    void listens(bool /*is_listening*/) override {}

    void sends(std::span<const std::uint8_t> /*data*/) override {}

    [[nodiscard]] std::optional<PacketBytes> take(std::size_t most_bytes) override;

    void advance_to(double now_s) override { now_s_ = now_s; }

    [[nodiscard]] bool is_plugged() const override { return is_plugged_; }

    [[nodiscard]] int starts() const { return starts_; }

    [[nodiscard]] int exposure_holds() const { return exposure_holds_; }

  private:
    struct Mode {
        std::uint8_t format;
        std::uint8_t frame;
        CameraFrame picture;
    };

    [[nodiscard]] const Mode& mode() const;
    [[nodiscard]] std::optional<PacketBytes> standard(const UsbRequest& request) const;
    [[nodiscard]] std::optional<PacketBytes> streaming(const UsbRequest& request,
                                                       std::span<const std::uint8_t> data);
    [[nodiscard]] std::optional<PacketBytes> exposure(const UsbRequest& request,
                                                      std::span<const std::uint8_t> data);
    [[nodiscard]] PacketBytes formats() const;

    std::vector<Mode> modes_;
    std::uint8_t format_ = 1;
    std::uint8_t frame_ = 1;
    std::uint8_t exposure_mode_ = 8;  // automatic, with a fixed aperture
    std::uint32_t exposure_100us_ = 200;
    int unplug_after_starts_;
    int starts_ = 0;
    int exposure_holds_ = 0;
    bool is_plugged_ = true;
    double now_s_ = 0.0;
    double next_frame_s_ = 0.0;
    std::size_t sent_bytes_ = 0;  // of the current frame
    std::uint8_t toggle_ = 0;     // changes with every frame
    int frames_ = 0;              // since the start
};

}  // namespace touchline
