// Whoever reads the braille display of a simulated site: plugs it in and out, turns pages, presses
// its keys. Threads: one.
#pragma once

#include "tests/app/kiosk/read_line.h"
#include "tests/machines/sim/kiosk/plan.h"

#include <array>
#include <cstdint>

namespace touchline {

class SimReader {
  public:
    explicit SimReader(std::uint64_t seed) : dice_(seed) {}

    /// Acts for one frame. Returns true if a page was turned.
    bool act(ReadLine& line, double now_s) {
        if (now_s < next_s_) return false;
        next_s_ = now_s + dice_.between(0.3, 5.0);
        // In most visits it stays in.
        if (!line.is_plugged_in || dice_.is_hit(0.02)) {
            line.is_plugged_in = !line.is_plugged_in;
            return false;
        }
        constexpr std::array turns{LineTurn::on,   LineTurn::on,       LineTurn::on,
                                   LineTurn::back, LineTurn::to_first, LineTurn::to_last};
        line.turn(turns.at(dice_.below(turns.size())));
        ++turned_;
        return true;
    }

    /// Whether a key is pressed on the display, and not on the keypad.
    [[nodiscard]] bool takes_key(const ReadLine& line) {
        return line.is_plugged_in && dice_.is_hit(0.5);
    }

    [[nodiscard]] std::uint64_t turned() const { return turned_; }

  private:
    Dice dice_;
    double next_s_ = 0.0;
    std::uint64_t turned_ = 0;
};

}  // namespace touchline
