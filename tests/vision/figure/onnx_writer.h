// Tiny networks as ONNX files, written by hand: protocol buffers, opset 11.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace touchline::testing {

/// An input or output of a graph; 0 means any size.
struct OnnxValue {
    std::string name;
    std::vector<std::int64_t> shape;
};

struct OnnxConstant {
    std::string name;
    std::vector<std::int64_t> shape;
    std::vector<float> values;
};

struct OnnxNode {
    std::string operation;
    std::vector<std::string> inputs;
    std::string output;
    std::vector<std::int64_t> kernel;  // a Conv's, padded to keep the size. Empty: none
    std::int64_t stride = 1;           // of a Conv
};

struct OnnxGraph {
    std::vector<OnnxNode> nodes;
    std::vector<OnnxConstant> constants;
    std::vector<OnnxValue> inputs;
    std::vector<OnnxValue> outputs;
};

[[nodiscard]] std::vector<std::byte> written(const OnnxGraph& graph);

/// Takes red for the main thing: a network of the figure's kind without its weights.
[[nodiscard]] OnnxGraph red_network();

}  // namespace touchline::testing
