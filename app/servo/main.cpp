// touchline-servo: started by the kiosk, with its socket and the device that it is for.
#include "app/servo/servo_program.h"
#include "app/servo/usb_device.h"

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
    const auto device =
        touchline::device_of(std::span(arguments).subspan(arguments.empty() ? 0 : 1));
    if (socket < 0 || !device) {
        std::fprintf(stderr, "touchline-servo: the kiosk starts it by itself; use 'touchline'\n");
        return 2;
    }
    return touchline::run_servo_program(socket, [&device](const touchline::Opening& opening) {
        return touchline::open_usb_device(*device, opening);
    });
}
