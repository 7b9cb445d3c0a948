// Cuts the bytes that come over a link into lines. Threads: a plain value. No allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// Lines end in a carriage return, a new line or both. Empty lines are left out. A line of more
/// than 255 bytes is dropped whole and counted.
class LineReader {
  public:
    /// Takes bytes until a line is whole, and returns it without its end; valid until the next
    /// call. `bytes` then begins behind it. Returns nothing once all bytes are taken.
    [[nodiscard]] std::optional<std::string_view> next(std::span<const std::uint8_t>& bytes);

    /// Forgets the line that has begun, and all up to its end.
    void drop() { is_dropping_ = size_ > 0 || is_dropping_; }

    [[nodiscard]] std::uint64_t too_long() const { return too_long_; }

  private:
    static constexpr std::size_t most_bytes = 255;

    std::array<char, most_bytes> line_{};
    std::size_t size_ = 0;
    bool is_dropping_ = false;
    std::uint64_t too_long_ = 0;
};

}  // namespace touchline
