// The board of a kiosk under the soak test: that of the servo's tests, in a file that the kiosk,
// the servo and the harness map, with a plug that can be pulled. The harness (soak/board.py) reads
// it at these offsets.
#pragma once

#include "tests/app/force/servo/fake_board.h"

#include <atomic>
#include <cstddef>

namespace touchline {

struct SoakBoard {
    FakeBoard board;  // is_pressed: the hand goes round, otherwise it rests
    std::atomic<int> is_unplugged{0};
};

static_assert(offsetof(FakeBoard, owner) == 8);
static_assert(offsetof(FakeBoard, reads) == 16);
static_assert(offsetof(FakeBoard, is_torque_on) == 24);
static_assert(offsetof(SoakBoard, is_unplugged) == 72 && sizeof(SoakBoard) == 80);

/// The environment variable that gives the kiosk the file's name.
inline constexpr const char* soak_board_variable = "TOUCHLINE_SOAK_BOARD";

}  // namespace touchline
