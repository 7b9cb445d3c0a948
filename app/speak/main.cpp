// touchline-speak: started by the kiosk, with its socket and the voice that it is for.
#include "app/speak/speak_program.h"

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "touchline-speak: the kiosk starts it by itself; use 'touchline'\n");
        return 2;
    }
    return touchline::run_speak_program(argv[1]);
}
