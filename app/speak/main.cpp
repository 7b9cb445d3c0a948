// touchline-speak: started by the kiosk, with its socket and the voice that it is for.
#include "app/speak/speak_program.h"

#include <charconv>
#include <cstdio>
#include <string>

int main(int argc, char** argv) {
    int socket = -1;
    if (argc == 3) {
        const std::string text = argv[1];
        (void)std::from_chars(text.data(), text.data() + text.size(), socket);
    }
    if (socket < 0) {
        std::fprintf(stderr, "touchline-speak: the kiosk starts it by itself; use 'touchline'\n");
        return 2;
    }
    return touchline::run_speak_program(socket, argv[2]);
}
