// The few words that kiosk and servo exchange over their socket: whole packets of one size, with at
// most one descriptor. All that is quick goes through the shared region instead.
// Threads: any, each socket's side by one at a time.
#pragma once

#include "app/servo/scene_order.h"
#include "app/servo/shared_region.h"
#include "config/types/calibration.h"
#include "config/types/result.h"
#include "haptics/device/usb_node.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace touchline {

/// region: the memory to share, first of all. scene: a map to be felt, the line its file in the
/// gallery, if it is one. hold, keep, forget: the last minute stays in memory, becomes a file, is
/// overwritten. failed: why the servo ends. notice: a map that cannot be felt, a recording that was
/// kept. say: what the person at the handle is to do now. home: what homing found of this unit.
/// here: the servo's first, its own pidfd attached. word: one of those that name the device, to a
/// servo that has none on its command line; before the region. board: the node of the board that it
/// opened, attached, with its pipes and, as the line, its bus path. done: the servo's last, when it
/// ended as asked. That the servo runs shows in its beats.
enum class MessageKind : std::uint32_t {
    region,
    scene,
    hold,
    keep,
    forget,
    failed,
    notice,
    say,
    home,
    here,
    word,
    board,
    done
};

/// Of a Calibration, what lasts.
struct HomeFound {
    double scale = 1.0;
    double stop_off_1 = 0.0, stop_off_2 = 0.0;  // rad
    std::uint16_t encoders = 0, motors = 0;     // number_of()
    std::uint32_t has_all_counts = 0;           // 0 or 1
};

struct Message {
    MessageKind kind = MessageKind::region;
    std::uint32_t line_bytes = 0;
    SceneOrder scene;
    HomeFound home;
    SerialPipes pipes;
    char line[512] = {};  // not ended by a zero
};

[[nodiscard]] Message message_of(MessageKind kind, std::string_view line = {});

[[nodiscard]] Message message_of(const Calibration& found);

/// `before` with what the message tells; nothing where that is out of range.
[[nodiscard]] std::optional<Calibration> calibration_of(const Message& message,
                                                        const Calibration& before);

/// The line, control characters as blanks.
[[nodiscard]] std::string line_of(const Message& message);

[[nodiscard]] Message message_of(const UsbNode& node);

/// Two ends of one socket, closed on exec.
[[nodiscard]] Result<std::pair<Descriptor, Descriptor>> socket_pair();

/// Never waits; false when the other side is gone or takes nothing.
bool send(const Descriptor& socket, const Message& message, const Descriptor* attached = nullptr);

struct Arrival {
    Message message;
    Descriptor attached;
};

/// The node of the board that a servo drives, as its guard has it.
struct HeldBoard {
    Descriptor node;
    SerialPipes pipes;
    std::string bus_path;
};

/// What a message `board` brings, which loses its descriptor; nothing where it came without.
[[nodiscard]] std::optional<HeldBoard> held_board_of(Arrival& arrival);

/// gone: the other side has closed; what it sent that is no message counts as that too.
enum class ReceiveStatus : std::uint8_t { received, none, gone };

/// Never waits.
[[nodiscard]] ReceiveStatus receive(const Descriptor& socket, Arrival& arrival);

}  // namespace touchline
