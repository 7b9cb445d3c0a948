#include "vision/contour/onnx_input.h"

#include <algorithm>
#include <optional>

namespace touchline {
namespace {

using Bytes = std::span<const std::byte>;

/// Field numbers of onnx.proto3.
constexpr std::uint64_t kModelGraph = 7;
constexpr std::uint64_t kGraphConstant = 5;
constexpr std::uint64_t kGraphInput = 11;
constexpr std::uint64_t kConstantName = 8;
constexpr std::uint64_t kValueName = 1;
constexpr std::uint64_t kValueType = 2;
constexpr std::uint64_t kTypeTensor = 1;
constexpr std::uint64_t kTensorShape = 2;
constexpr std::uint64_t kShapeDimension = 1;
constexpr std::uint64_t kDimensionValue = 1;

struct Field {
    std::uint64_t number = 0;
    std::uint64_t value = 0;  // of a varint
    Bytes bytes;              // of a length-delimited field
};

/// The fields of one message, one after the other.
class Message {
  public:
    explicit Message(Bytes bytes) : left_(bytes) {}

    /// Nothing at the end, and where the bytes make no sense: then is_broken().
    std::optional<Field> next() {
        if (left_.empty() || is_broken_) {
            return std::nullopt;
        }
        const std::uint64_t key = varint();
        Field field{key >> 3U, 0, {}};
        switch (key & 7U) {
            case 0:
                field.value = varint();
                break;
            case 1:
                take(8);
                break;
            case 2:
                field.bytes = take(varint());
                break;
            case 5:
                take(4);
                break;
            default:
                is_broken_ = true;
        }
        return is_broken_ ? std::nullopt : std::optional(field);
    }

    bool is_broken() const { return is_broken_; }

  private:
    std::uint64_t varint() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64 && !left_.empty(); shift += 7) {
            const auto byte = std::to_integer<std::uint64_t>(left_.front());
            left_ = left_.subspan(1);
            value |= (byte & 0x7FU) << shift;
            if (byte < 0x80U) {
                return value;
            }
        }
        is_broken_ = true;
        return 0;
    }

    Bytes take(std::uint64_t count) {
        if (count > left_.size()) {
            is_broken_ = true;
            return {};
        }
        const Bytes taken = left_.first(count);
        left_ = left_.subspan(count);
        return taken;
    }

    Bytes left_;
    bool is_broken_ = false;
};

/// Calls visit(field) for all of a message; false if it is broken, or a visit says so.
template <class Visit>
bool read(Bytes bytes, Visit&& visit) {
    Message message(bytes);
    while (const std::optional<Field> field = message.next()) {
        if (!visit(*field)) {
            return false;
        }
    }
    return !message.is_broken();
}

std::string text(Bytes bytes) {
    std::string text(bytes.size(), '\0');
    std::ranges::transform(bytes, text.begin(),
                           [](std::byte b) { return std::to_integer<char>(b); });
    return text;
}

bool read_dimension(Bytes bytes, std::vector<std::int64_t>& shape) {
    shape.push_back(0);
    return read(bytes, [&](const Field& field) {
        if (field.number == kDimensionValue) {
            shape.back() = static_cast<std::int64_t>(field.value);
        }
        return true;
    });
}

/// TypeProto, its tensor, the tensor's shape: each is one message in the next.
bool read_shape(Bytes type, std::vector<std::int64_t>& shape) {
    return read(type, [&](const Field& tensor) {
        return tensor.number != kTypeTensor || read(tensor.bytes, [&](const Field& dimensions) {
                   return dimensions.number != kTensorShape ||
                          read(dimensions.bytes, [&](const Field& dimension) {
                              return dimension.number != kShapeDimension ||
                                     read_dimension(dimension.bytes, shape);
                          });
               });
    });
}

bool read_input(Bytes bytes, std::vector<OnnxInput>& inputs) {
    OnnxInput& input = inputs.emplace_back();
    return read(bytes, [&](const Field& field) {
        if (field.number == kValueName) {
            input.name = text(field.bytes);
        }
        return field.number != kValueType || read_shape(field.bytes, input.shape);
    });
}

bool read_constant(Bytes bytes, std::vector<std::string>& names) {
    return read(bytes, [&](const Field& field) {
        if (field.number == kConstantName) {
            names.push_back(text(field.bytes));
        }
        return true;
    });
}

}  // namespace

Result<std::vector<OnnxInput>> onnx_inputs(std::span<const std::byte> model) {
    std::vector<OnnxInput> inputs;
    std::vector<std::string> constants;
    bool has_graph = false;
    const auto read_graph = [&](const Field& field) {
        switch (field.number) {
            case kGraphInput:
                return read_input(field.bytes, inputs);
            case kGraphConstant:
                return read_constant(field.bytes, constants);
            default:
                return true;
        }
    };
    const bool is_whole = read(model, [&](const Field& field) {
        has_graph = has_graph || field.number == kModelGraph;
        return field.number != kModelGraph || read(field.bytes, read_graph);
    });
    if (!is_whole || !has_graph) {
        return failure("it is no ONNX network");
    }
    std::erase_if(inputs, [&](const OnnxInput& input) {
        return std::ranges::find(constants, input.name) != constants.end();
    });
    return inputs;
}

}  // namespace touchline
