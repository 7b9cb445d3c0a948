// The whole of the program that traces: started by the kiosk for one step of one picture.
// Threads: the only one of its process.
#pragma once

namespace touchline {

/// Its main(). Does not return.
[[noreturn]] void run_trace_program(int argc, char** argv);

}  // namespace touchline
