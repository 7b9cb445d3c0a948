// touchline-servo. The kiosk starts it with its socket and device; or systemd does, for a kiosk
// that asks at its socket and names the device there.
#include "app/force/backends/servo_backends.h"
#include "app/force/servo/servo_program.h"

#include <charconv>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    int socket = -1;
    if (!arguments.empty()) {
        const std::string& text = arguments.front();
        (void)std::from_chars(text.data(), text.data() + text.size(), socket);
    }
    const auto words = std::span(arguments).subspan(arguments.empty() ? 0 : 1);
    if (socket < 0 || (!words.empty() && !touchline::names_device(words))) {
        std::fprintf(stderr, "touchline-servo: the kiosk starts it by itself; use 'touchline'\n");
        return 2;
    }
    return touchline::run_servo_program(socket, [words](const touchline::Opening& opening) {
        return touchline::open_named_device(words.empty() ? opening.words : words, opening);
    });
}
