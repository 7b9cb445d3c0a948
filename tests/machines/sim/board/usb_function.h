// What the emulated board says about itself on the USB and how it answers control requests, the
// same for every way to reach it. Threads: as BoardEmulator.
#pragma once

#include "tests/machines/sim/board/board_emulator.h"

#include <cstdint>
#include <optional>
#include <span>

namespace touchline {

inline constexpr std::uint8_t board_out_endpoint = 0x02;
inline constexpr std::uint8_t board_in_endpoint = 0x83;

/// The eight bytes of a control request.
struct UsbRequest {
    std::uint8_t type = 0;
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    std::uint16_t length = 0;
};

/// Parses the wire form of at least 8 bytes.
[[nodiscard]] UsbRequest request_of(std::span<const std::uint8_t> bytes);

[[nodiscard]] PacketBytes device_descriptor(const BoardEmulator& board);
[[nodiscard]] PacketBytes configuration_descriptor(const BoardEmulator& board);

/// Returns the board's answer, cut to the requested length; nothing if it stalls. `data`: sent with
/// a request to the board.
[[nodiscard]] std::optional<PacketBytes> answer(BoardEmulator& board, const UsbRequest& request,
                                                std::span<const std::uint8_t> data);

}  // namespace touchline
