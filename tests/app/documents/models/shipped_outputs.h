// What the shipped networks answer to three pictures, as numbers that can be written down.
// Threads: one, with OpenCV's own switched off.
#pragma once

#include <string>
#include <vector>

namespace touchline::testing {

struct OutputRow {
    std::string name;             // network, picture and shape: "facemesh,face,1x1404"
    std::vector<double> numbers;  // the greatest size, the mean, and 16 values of the output
};

/// Returns every output of every network for three pictures that are made here: shapes, a face, a
/// person. Throws std::runtime_error if a network cannot be read or run.
[[nodiscard]] std::vector<OutputRow> shipped_outputs();

}  // namespace touchline::testing
