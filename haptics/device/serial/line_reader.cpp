#include "haptics/device/serial/line_reader.h"

#include <utility>

namespace touchline {

std::optional<std::string_view> LineReader::next(std::span<const std::uint8_t>& bytes) {
    while (!bytes.empty()) {
        const char byte = static_cast<char>(bytes.front());
        bytes = bytes.subspan(1);
        if (byte == '\n' || byte == '\r') {
            const std::size_t size = std::exchange(size_, 0);
            if (!std::exchange(is_dropping_, false) && size > 0)
                return std::string_view(line_.data(), size);
        } else if (size_ < line_.size()) {
            line_[size_++] = byte;
        } else if (!std::exchange(is_dropping_, true)) {
            ++too_long_;
        }
    }
    return std::nullopt;
}

}  // namespace touchline
