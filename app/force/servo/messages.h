// What kiosk and servo exchange: a few messages over their socket, whole packets of one size with
// at most one descriptor; and the memory that they share, for everything fast, which nobody can
// truncate under a reader. Threads: values; a socket's side and a region by one thread at a time.
#pragma once

#include "app/force/servo/scene_order.h"
#include "app/isolation/process/memory.h"
#include "config/types/calibration.h"
#include "config/types/result.h"
#include "haptics/collision/scene.h"
#include "haptics/device/board/usb_boards.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/recording.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace touchline {

/// What kiosk and servo share for as long as one servo process lives.
struct ServoRegion {
    static constexpr std::uint64_t known_mark = 0x31'6f'76'72'65'73'6c'74;  // "tlservo1"

    std::uint64_t mark = known_mark;
    std::uint64_t bytes = sizeof(ServoRegion);  // differs in a program built from other sources
    ServoChannel channel;
};

/// One side's view of the region.
class SharedRegion {
  public:
    /// Creates a region: the kiosk's side.
    [[nodiscard]] static Result<SharedRegion> create();
    /// Opens the servo's side. Fails for anything that create() did not make.
    [[nodiscard]] static Result<SharedRegion> open(const Descriptor& descriptor);

    [[nodiscard]] ServoChannel& channel() const;

    [[nodiscard]] const Descriptor& descriptor() const { return descriptor_; }

  private:
    SharedRegion(Descriptor descriptor, Mapping mapping)
        : descriptor_(std::move(descriptor)), mapping_(std::move(mapping)) {}

    Descriptor descriptor_;  // only on the side that created it
    Mapping mapping_;
};

/// Where homing found the handle. It holds as long as the board counts and the machine is awake.
struct HandlePlace {
    JointAngles offset;         // Calibration::offset, rad, finite
    std::int64_t slept_ns = 0;  // slept_ns() when it was found
};

/// What a servo needs to go on where one that died left the board.
struct Handover {
    HandlePlace place;
    JointAngles last;          // rad, in the last tick of the dead one
    std::int64_t seen_ns = 0;  // when that was, on the steady clock
    double motor_heat = 0.0;   // ServoChannel::motor_heat then
    std::string bus_path;      // of the board
};

/// Returns whether every number is finite and in its range.
[[nodiscard]] bool is_sound(const Handover& handover);

/// region: the memory to share; comes before everything but words. scene: a map to be felt; the
/// line is its file in the gallery, if it has one. hold, keep, forget: the last minute stays in
/// memory, becomes a file, or is overwritten. failed: why the servo ends. notice: a map that cannot
/// be felt, or a recording that was kept. say: what the person at the handle has to do now. home:
/// what homing found out about this unit. here: the servo's first message, with its own pidfd
/// attached. word: one of the words that name the device, for a servo without them on its command
/// line; comes before the region. board: the node of the board that it opened, attached, with its
/// pipes and, as the line, its bus path. place: where the handle is, from here on. done: the
/// servo's last message, when it ended as asked. The servo's beats show that it runs.
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
    place,
    done
};

/// The lasting part of a Calibration.
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
    HandlePlace place;
    char line[512] = {};  // not always ended by a zero
};

[[nodiscard]] Message message_of(MessageKind kind, std::string_view line = {});

[[nodiscard]] Message message_of(const Calibration& found);

/// Returns `before` with the message's values; nothing if they are out of range.
[[nodiscard]] std::optional<Calibration> calibration_of(const Message& message,
                                                        const Calibration& before);

[[nodiscard]] Message message_of(const HandlePlace& place);

/// The place of a message `place`; nothing if it is another message or out of range.
[[nodiscard]] std::optional<HandlePlace> place_of(const Message& message);

/// The line, with blanks for control characters.
[[nodiscard]] std::string line_of(const Message& message);

[[nodiscard]] Message message_of(const UsbNode& node);

/// The two ends of one socket, closed on exec.
[[nodiscard]] Result<std::pair<Descriptor, Descriptor>> socket_pair();

/// Never waits. False if the other side is gone or takes nothing.
bool send(const Descriptor& socket, const Message& message, const Descriptor* attached = nullptr);

struct Arrival {
    Message message;
    Descriptor attached;
};

/// The node of the board that a servo drives, as held by its guard.
struct HeldBoard {
    Descriptor node;
    SerialPipes pipes;
    std::string bus_path;
};

/// Takes the descriptor out of a message `board`; nothing if it came without one.
[[nodiscard]] std::optional<HeldBoard> held_board_of(Arrival& arrival);

/// gone: the other side has closed, or sent something that is no message.
enum class ReceiveStatus : std::uint8_t { received, none, gone };

/// Never waits.
[[nodiscard]] ReceiveStatus receive(const Descriptor& socket, Arrival& arrival);

struct BuiltScene {
    std::shared_ptr<const Scene> scene;
    RecordedMap recorded;
};

/// Builds the scene of a message of the kind scene. Fails with one line if its memory is not
/// sealed, is over 64 MiB, or holds no map that can be felt. O(N log N).
[[nodiscard]] Result<BuiltScene> scene_of(const Arrival& arrival);

}  // namespace touchline
