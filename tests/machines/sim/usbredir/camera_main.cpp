// redirected_camera SOCKET [UNPLUG_AFTER_STARTS]: an emulated USB camera for QEMU's usb-redir
// device, which connects to the unix socket. After that many starts of the stream the plug is
// pulled, once, and put back when QEMU connects again. Ends when QEMU has gone; prints what it was
// asked for.
#include "tests/machines/sim/usbredir/redirected_device.h"
#include "tests/vision/camera/frames.h"
#include "vision/camera/frame.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <sys/socket.h>

namespace touchline {
namespace {

/// A USB camera of the UVC class (1.1, bulk streaming): YUYV 640 x 480, and MJPEG without Huffman
/// tables in two sizes; exposure can be held. It shows testing::scene(), the same in every frame.
/// After USB Device Class Definition for Video Devices 1.1, with its MJPEG and uncompressed
/// payloads.
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

constexpr std::uint32_t frames_per_s = 10;
constexpr std::uint32_t interval_100ns = 10'000'000 / frames_per_s;
constexpr std::uint32_t most_payload = 16384;  // the kernel takes this much as one transfer
constexpr std::uint8_t header_bytes = 2;
constexpr std::uint32_t clock_Hz = 48'000'000;
constexpr std::uint8_t streaming_interface = 1;
constexpr std::uint16_t camera_terminal = 0x0100;  // entity 1 of interface 0
constexpr std::uint8_t class_interface = 0x24;     // CS_INTERFACE
constexpr std::uint8_t mjpeg_format = 1;
constexpr std::uint8_t yuyv_format = 2;

constexpr std::uint8_t set_current = 0x01;
constexpr std::uint8_t get_current = 0x81;
constexpr std::uint8_t get_resolution = 0x84;
constexpr std::uint8_t get_length = 0x85;
constexpr std::uint8_t get_info = 0x86;

/// Writes little-endian, as all of USB does.
void put(PacketBytes& bytes, std::uint32_t value, int count) {
    for (; count > 0; --count, value >>= 8U)
        bytes.push_back(static_cast<std::uint8_t>(value & 0xffU));
}

void put(PacketBytes& bytes, const PacketBytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Puts the length before the body.
PacketBytes descriptor(const PacketBytes& body) {
    PacketBytes bytes{static_cast<std::uint8_t>(body.size() + 1)};
    put(bytes, body);
    return bytes;
}

PacketBytes frame_descriptor(std::uint8_t kind, std::uint8_t index, cv::Size size) {
    const auto pixels = static_cast<std::uint32_t>(size.area());
    PacketBytes body{class_interface, kind, index, 0};
    put(body, static_cast<std::uint32_t>(size.width), 2);
    put(body, static_cast<std::uint32_t>(size.height), 2);
    put(body, pixels * 16 * frames_per_s, 4);
    put(body, pixels * 16 * frames_per_s, 4);
    put(body, pixels * 2, 4);
    put(body, interval_100ns, 4);
    body.push_back(1);
    put(body, interval_100ns, 4);
    return descriptor(body);
}

PacketBytes text_descriptor(std::string_view text) {
    PacketBytes body{3};
    for (const char letter : text) put(body, static_cast<std::uint8_t>(letter), 2);
    return descriptor(body);
}

PacketBytes number(std::uint32_t value, int count) {
    PacketBytes bytes;
    put(bytes, value, count);
    return bytes;
}

UvcCamera::UvcCamera(int unplug_after_starts) : unplug_after_starts_(unplug_after_starts) {
    const auto jpeg = [](cv::Size size) {
        return testing::without_tables(testing::mjpeg_frame(testing::scene(size)));
    };
    modes_.push_back({mjpeg_format, 1, jpeg({640, 480})});
    modes_.push_back({mjpeg_format, 2, jpeg({2048, 1536})});
    modes_.push_back({yuyv_format, 1, testing::yuyv_frame(testing::scene({640, 480}))});
}

PacketBytes UvcCamera::device() const {
    return {18, 1, 0x00, 0x02, 0xef, 2, 1, 64, 0xfe, 0xca, 0x01, 0x00, 0x00, 0x01, 1, 2, 3, 1};
}

PacketBytes UvcCamera::formats() const {
    PacketBytes all = descriptor({class_interface, 6, mjpeg_format, 2, 1, 1, 0, 0, 0, 0});
    put(all, frame_descriptor(7, 1, modes_[0].picture.size));
    put(all, frame_descriptor(7, 2, modes_[1].picture.size));
    put(all, descriptor({class_interface,
                         4,
                         yuyv_format,
                         1,
                         'Y',
                         'U',
                         'Y',
                         '2',
                         0,
                         0,
                         0x10,
                         0,
                         0x80,
                         0,
                         0,
                         0xaa,
                         0,
                         0x38,
                         0x9b,
                         0x71,
                         16,
                         1,
                         0,
                         0,
                         0,
                         0}));
    put(all, frame_descriptor(5, 1, modes_[2].picture.size));
    put(all, descriptor({class_interface, 13, 1, 1, 4}));
    return all;
}

PacketBytes UvcCamera::configuration() const {
    // The lens and sensor (with exposure mode and time), and the output.
    PacketBytes units =
        descriptor({class_interface, 2, 1, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0x0a, 0, 0});
    put(units, descriptor({class_interface, 3, 3, 1, 1, 0, 1, 0}));
    PacketBytes control_body{class_interface, 1, 0x10, 0x01};
    put(control_body, static_cast<std::uint32_t>(13 + units.size()), 2);
    put(control_body, clock_Hz, 4);
    put(control_body, {1, streaming_interface});
    PacketBytes stream_body{class_interface, 1, 2};
    put(stream_body, static_cast<std::uint32_t>(15 + formats().size()), 2);
    put(stream_body, {0x81, 0, 3, 0, 0, 0, 1, 0, 0});
    PacketBytes body = descriptor({11, 0, 2, 14, 3, 0, 2});
    put(body, descriptor({4, 0, 0, 0, 14, 1, 0, 2}));
    put(body, descriptor(control_body));
    put(body, units);
    put(body, descriptor({4, streaming_interface, 0, 1, 14, 2, 0, 0}));
    put(body, descriptor(stream_body));
    put(body, formats());
    put(body, descriptor({5, 0x81, 2, 0, 2, 0}));
    PacketBytes whole{9, 2};
    put(whole, static_cast<std::uint32_t>(9 + body.size()), 2);
    put(whole, {2, 1, 0, 0x80, 250});
    put(whole, body);
    return whole;
}

std::optional<PacketBytes> UvcCamera::control(const UsbRequest& request,
                                              std::span<const std::uint8_t> data) {
    const bool is_standard = (request.type & 0x60) == 0;
    std::optional<PacketBytes> said = is_standard                        ? standard(request)
                                      : request.index == camera_terminal ? exposure(request, data)
                                                                         : streaming(request, data);
    if (said && said->size() > request.length) said->resize(request.length);
    return said;
}

std::optional<PacketBytes> UvcCamera::standard(const UsbRequest& request) const {
    if (request.request == 0) return PacketBytes{0, 0};
    if (request.request == 8) return PacketBytes{1};
    if (request.request == 10) return PacketBytes{0};
    if (request.request != 6) return PacketBytes{};
    const int index = request.value & 0xff;
    switch (request.value >> 8) {
        case 1:
            return device();
        case 2:
            return configuration();
        case 3:
            break;
        default:
            return std::nullopt;
    }
    if (index == 0) return PacketBytes{4, 3, 9, 4};
    return text_descriptor(index == 1 ? "Touchline" : index == 2 ? "Emulated camera" : "0001");
}

/// Probe and commit: the host proposes a mode and is told what it gets.
std::optional<PacketBytes> UvcCamera::streaming(const UsbRequest& request,
                                                std::span<const std::uint8_t> data) {
    const int selector = request.value >> 8;
    constexpr int commit = 2;
    if ((request.index & 0xff) != streaming_interface || selector < 1 || selector > commit)
        return std::nullopt;
    if (request.request == set_current) {
        if (data.size() < 4) return std::nullopt;
        format_ = data[2];
        frame_ = data[3];
        if (selector == commit) {
            ++starts_;
            frames_ = 0;
            sent_bytes_ = 0;
            next_frame_s_ = now_s_;
        }
        return PacketBytes{};
    }
    if (request.request == get_length) return number(34, 2);
    if (request.request == get_info) return PacketBytes{3};
    PacketBytes told{1, 0, format_, frame_};
    put(told, interval_100ns, 4);
    put(told, PacketBytes(10, 0));
    put(told, static_cast<std::uint32_t>(2 * mode().picture.size.area()), 4);
    put(told, most_payload, 4);
    put(told, clock_Hz, 4);
    put(told, PacketBytes(4, 0));
    return told;
}

/// Handles the exposure's mode (selector 2, one byte) and time (selector 4, four bytes).
std::optional<PacketBytes> UvcCamera::exposure(const UsbRequest& request,
                                               std::span<const std::uint8_t> data) {
    constexpr std::uint8_t held = 1;
    constexpr std::uint8_t both = 8 | held;
    const bool is_mode = request.value >> 8 == 2;
    const int size = is_mode ? 1 : 4;
    if (request.request == set_current) {
        if (is_mode && !data.empty()) {
            exposure_mode_ = data[0];
            exposure_holds_ += exposure_mode_ == held ? 1 : 0;
        }
        return PacketBytes{};
    }
    if (request.request == get_info) return PacketBytes{3};
    if (request.request == get_length) return number(static_cast<std::uint32_t>(size), 2);
    if (is_mode)
        return PacketBytes{request.request == get_resolution ? both
                           : request.request == get_current  ? exposure_mode_
                                                             : std::uint8_t{8}};
    const bool is_least = request.request == 0x82 || request.request == get_resolution;
    return number(is_least ? 1 : request.request == 0x83 ? 10000 : exposure_100us_, 4);
}

const UvcCamera::Mode& UvcCamera::mode() const {
    const auto found = std::find_if(modes_.begin(), modes_.end(), [&](const Mode& one) {
        return one.format == format_ && one.frame == frame_;
    });
    return found == modes_.end() ? modes_.front() : *found;
}

/// Returns a part of a frame with its header. It is shorter than the read, so each read holds one
/// part.
std::optional<PacketBytes> UvcCamera::take(std::size_t most_bytes) {
    if (starts_ == 0 || now_s_ < next_frame_s_) return std::nullopt;
    const auto& bytes = mode().picture.bytes;
    if (sent_bytes_ == 0) toggle_ ^= 1U;
    const std::size_t room = std::min<std::size_t>(most_bytes, most_payload) - header_bytes - 1;
    const std::size_t count = std::min(bytes.size() - sent_bytes_, room);
    const bool is_last = sent_bytes_ + count == bytes.size();
    PacketBytes part{header_bytes,
                     static_cast<std::uint8_t>(0x80U | toggle_ | (is_last ? 2U : 0U))};
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(sent_bytes_);
    part.insert(part.end(), from, from + static_cast<std::ptrdiff_t>(count));
    sent_bytes_ += count;
    if (starts_ == unplug_after_starts_ && frames_ >= 2) is_plugged_ = false;
    if (is_last) {
        sent_bytes_ = 0;
        ++frames_;
        next_frame_s_ = now_s_ + 1.0 / frames_per_s;
    }
    return part;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: redirected_camera SOCKET [UNPLUG_AFTER_STARTS]\n", stderr);
        return 2;
    }
    const int listener = touchline::listen_at(argv[1]);
    if (listener < 0) {
        std::perror("redirected_camera");
        return 1;
    }
    int unplug_after = argc > 2 ? std::atoi(argv[2]) : 0;
    for (;;) {
        touchline::UvcCamera camera(unplug_after);
        touchline::RedirectedDevice(camera, accept(listener, nullptr, nullptr)).serve();
        std::printf("the stream was started %d times, exposure held %d times%s\n", camera.starts(),
                    camera.exposure_holds(), camera.is_plugged() ? "" : "; unplugged");
        if (camera.is_plugged()) return 0;
        unplug_after = 0;
    }
}
