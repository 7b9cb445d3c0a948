#include "tests/vision/figure/onnx_writer.h"

#include <algorithm>
#include <cstring>

namespace touchline::testing {
namespace {

std::string varint(std::uint64_t value) {
    std::string bytes;
    for (; value >= 0x80U; value >>= 7U) {
        bytes += static_cast<char>(value | 0x80U);
    }
    return bytes + static_cast<char>(value);
}

std::string number(unsigned field, std::int64_t value) {
    return varint(field << 3U) + varint(static_cast<std::uint64_t>(value));
}

std::string part(unsigned field, const std::string& bytes) {
    return varint(field << 3U | 2U) + varint(bytes.size()) + bytes;
}

std::string list_attribute(const std::string& name, const std::vector<std::int64_t>& values) {
    constexpr std::int64_t ints = 7;
    std::string bytes = part(1, name) + number(20, ints);
    for (const std::int64_t value : values) {
        bytes += number(8, value);
    }
    return bytes;
}

std::string node_bytes(const OnnxNode& node) {
    std::string bytes;
    for (const std::string& input : node.inputs) {
        bytes += part(1, input);
    }
    bytes += part(2, node.output) + part(3, node.output + "-node") + part(4, node.operation);
    if (!node.kernel.empty()) {
        const std::vector<std::int64_t> pads{node.kernel[0] / 2, node.kernel[1] / 2,
                                             node.kernel[0] / 2, node.kernel[1] / 2};
        bytes += part(5, list_attribute("kernel_shape", node.kernel));
        bytes += part(5, list_attribute("pads", pads));
        bytes += part(5, list_attribute("strides", {node.stride, node.stride}));
    }
    return bytes;
}

std::string constant_bytes(const OnnxConstant& constant) {
    constexpr std::int64_t float_type = 1;
    std::string bytes;
    for (const std::int64_t size : constant.shape) {
        bytes += number(1, size);
    }
    std::string raw(constant.values.size() * sizeof(float), '\0');
    std::memcpy(raw.data(), constant.values.data(), raw.size());
    return bytes + number(2, float_type) + part(8, constant.name) + part(9, raw);
}

std::string value_bytes(const OnnxValue& value) {
    constexpr std::int64_t float_type = 1;
    std::string shape;
    for (const std::int64_t size : value.shape) {
        shape += part(1, size > 0 ? number(1, size) : part(2, "any"));
    }
    return part(1, value.name) + part(2, part(1, number(1, float_type) + part(2, shape)));
}

}  // namespace

std::vector<std::byte> written(const OnnxGraph& graph) {
    std::string bytes;
    for (const OnnxNode& node : graph.nodes) {
        bytes += part(1, node_bytes(node));
    }
    bytes += part(2, "graph");
    for (const OnnxConstant& constant : graph.constants) {
        bytes += part(5, constant_bytes(constant));
    }
    for (const OnnxValue& value : graph.inputs) {
        bytes += part(11, value_bytes(value));
    }
    for (const OnnxValue& value : graph.outputs) {
        bytes += part(12, value_bytes(value));
    }
    const std::string model = number(1, 7) + part(7, bytes) + part(8, part(1, "") + number(2, 11));
    std::vector<std::byte> result(model.size());
    std::ranges::transform(model, result.begin(), [](char c) { return static_cast<std::byte>(c); });
    return result;
}

OnnxGraph red_network() {
    OnnxGraph graph;
    constexpr float gain = 40.0F;  // (v - 128) / 256: a difference of 1/2 is even odds
    graph.constants = {{"mix", {1, 3, 1, 1}, {gain, -0.5F * gain, -0.5F * gain}},
                       {"least", {1}, {-0.25F * gain}}};
    graph.inputs = {{"picture", {1, 3, 0, 0}}};
    graph.nodes = {{"Conv", {"picture", "mix", "least"}, "redder", {1, 1}},
                   {"Sigmoid", {"redder"}, "likelihood", {}}};
    graph.outputs = {{"likelihood", {1, 1, 0, 0}}};
    return graph;
}

}  // namespace touchline::testing
