// What an ONNX file says about its input, without building the network: OpenCV's importer does not
// tell. Threads: pure function.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline {

struct OnnxInput {
    std::string name;
    std::vector<std::int64_t> shape;  // 0: any
};

/// The inputs of the model's graph that are no constants. Reads ModelProto, GraphProto and
/// ValueInfoProto of ONNX's protocol buffers and skips all else. Fails on bytes that are no such
/// message. O(bytes), allocates no more than the names.
[[nodiscard]] Result<std::vector<OnnxInput>> onnx_inputs(std::span<const std::byte> model);

}  // namespace touchline
