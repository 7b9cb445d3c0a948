// The result of something that the operator ordered. Threads: a plain value.
#pragma once

#include <string>

namespace touchline {

struct Outcome {
    std::string said;  // to the operator, in their language
    std::string line;  // for the log, with names of files; empty: it went well
};

}  // namespace touchline
