// The kiosk as `touchline --window` runs it, with the board of soak_board.h instead of one on USB.
#include "app/cli/options.h"
#include "app/force/servo/servo_process.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/main/kiosk_window.h"
#include "tests/app/force/servo/mapped_file.h"
#include "tests/machines/system/soak/soak_board.h"

#include <memory>
#include <string>

namespace touchline {
namespace {

/// Like a real board, it is free only once its last holder is dead, and while it is plugged in.
Result<ZeroedBoard> zero_by_guard(SoakBoard& soak) {
    if (!soak.board.is_free()) return failure("the board is busy");
    if (soak.is_unplugged != 0) return failure("the board is not plugged in");
    soak.board.put({});
    ++soak.board.zeroed_by_guard;
    return ZeroedBoard::unknown;
}

Result<KioskServo> start_soaked_servo(const std::shared_ptr<MouseHand>& /*hand*/,
                                      const Settings& /*settings*/) {
    const std::string path = environment(soak_board_variable);
    SoakBoard& soak = mapped<SoakBoard>(path);
    KioskServo servo;
    servo.client = std::make_unique<ServoProcess>(ServoProcessOptions{
        (own_folder() / "soak_servo").string(), {path}, [&soak](const std::string&) {
            return zero_by_guard(soak);
        }});
    servo.hand_words = "a hand that goes round, and a board in a file";
    return servo;
}

}  // namespace
}  // namespace touchline

int main() {
    touchline::forbid_core_dumps();
    touchline::keep_memory_compact();
    touchline::KioskArguments arguments;
    arguments.in_window = true;
    return touchline::run_kiosk(arguments, touchline::start_soaked_servo);
}
