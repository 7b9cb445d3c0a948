// What a test tells the emulated board and the hand at it while it serves: lines on stdin.
//
//     hear WORDS     the hand does what homing says
//     go X Y         the hand goes there, in W, millimetres
//     unplug, plug   the cable
//     tell           a line on stdout: the largest torque told since the last one, and where the
//                    handle is
#pragma once

#include "tests/app/device/person.h"
#include "tests/sim/board/board_emulator.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace touchline {

class BoardOrders {
  public:
    BoardOrders(BoardEmulator& board, std::shared_ptr<Person> person)
        : board_(board), person_(std::move(person)) {}

    /// Those that have come; waits for none.
    void follow();

    /// Until `plug` comes; false: nobody is left who could say it.
    [[nodiscard]] bool wait_for_plug();

  private:
    void follow(const std::string& line);
    void tell();

    BoardEmulator& board_;
    std::shared_ptr<Person> person_;
    std::string rest_;  // of a line
    std::size_t told_ = 0;
    bool has_ended_ = false;  // stdin
};

}  // namespace touchline
