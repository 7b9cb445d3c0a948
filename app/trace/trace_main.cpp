// touchline-trace: a picture's lines, and maps of them.
#include "app/trace/trace_program.h"

int main(int argc, char** argv) {
    touchline::run_trace_program(argc, argv);
}
