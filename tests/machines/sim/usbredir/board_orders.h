// What a test tells the emulated board and the hand at it while it serves: lines on stdin.
//
//     hear WORDS     the hand does what homing says
//     go X Y         the hand goes there, in W, millimetres
//     unplug, plug   the cable
//     tell           a line on stdout: the largest torque told since the last one, and where the
//                    handle is
#pragma once

#include "tests/app/device/person.h"
#include "tests/machines/sim/board/board_emulator.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace touchline {

class BoardOrders {
  public:
    BoardOrders(BoardEmulator& board, std::shared_ptr<Person> person)
        : board_(board), person_(std::move(person)) {}

    /// Follows the orders that have come; does not wait.
    void follow();

    /// Waits until `plug` comes; returns false if nobody is left to send it.
    [[nodiscard]] bool wait_for_plug();

  private:
    void follow(const std::string& line);
    void tell();

    BoardEmulator& board_;
    std::shared_ptr<Person> person_;
    std::string rest_;  // incomplete line
    std::size_t told_ = 0;
    bool has_ended_ = false;  // stdin has ended
};

}  // namespace touchline
