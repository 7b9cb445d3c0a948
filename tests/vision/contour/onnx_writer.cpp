#include "tests/vision/contour/onnx_writer.h"

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
    constexpr std::int64_t kInts = 7;
    std::string bytes = part(1, name) + number(20, kInts);
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
    }
    return bytes;
}

std::string constant_bytes(const OnnxConstant& constant) {
    constexpr std::int64_t kFloat = 1;
    std::string bytes;
    for (const std::int64_t size : constant.shape) {
        bytes += number(1, size);
    }
    std::string raw(constant.values.size() * sizeof(float), '\0');
    std::memcpy(raw.data(), constant.values.data(), raw.size());
    return bytes + number(2, kFloat) + part(8, constant.name) + part(9, raw);
}

std::string value_bytes(const OnnxValue& value) {
    constexpr std::int64_t kFloat = 1;
    std::string shape;
    for (const std::int64_t size : value.shape) {
        shape += part(1, size > 0 ? number(1, size) : part(2, "any"));
    }
    return part(1, value.name) + part(2, part(1, number(1, kFloat) + part(2, shape)));
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

OnnxGraph contrast_network(float contrast, std::int64_t height, std::int64_t width) {
    std::vector<float> across;
    for (const bool is_down : {false, true}) {
        for (int colour = 0; colour < 3; ++colour) {
            for (int y = -1; y <= 1; ++y) {
                for (int x = -1; x <= 1; ++x) {
                    across.push_back(static_cast<float>(is_down ? y : x) / 18.0F);
                }
            }
        }
    }
    constexpr float kGain = 20.0F;
    OnnxGraph graph;
    graph.constants = {{"across", {2, 3, 3, 3}, across},
                       {"sum", {1, 2, 1, 1}, {kGain, kGain}},
                       {"least", {1}, {-kGain * contrast}}};
    graph.inputs = {{"picture", {1, 3, height, width}}};
    graph.nodes = {{"Conv", {"picture", "across"}, "slopes", {3, 3}},
                   {"Abs", {"slopes"}, "sizes", {}},
                   {"Conv", {"sizes", "sum", "least"}, "logits", {1, 1}}};
    graph.outputs = {{"logits", {1, 1, height, width}}};
    return graph;
}

}  // namespace touchline::testing
