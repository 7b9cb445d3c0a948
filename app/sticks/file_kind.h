// Which files of a stick are offered, by name alone. What a file really is, its first bytes tell
// the process that opens it.
// Threads: pure functions. O(n).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// picture: one image. document: pages or vectors. office: listed so that one sentence can ask for
/// a PDF of it; it is not opened. For the operator alone: pack, of pictures; network, of those that
/// Touchline knows (app/models).
enum class StickFileKind : std::uint8_t { picture, document, office, pack, network };

inline constexpr int stick_file_kind_count = 5;

/// The ending decides, of any case; none for what is not offered. What is for the operator alone is
/// never among it.
[[nodiscard]] std::optional<StickFileKind> kind_of_name(std::string_view name);

/// The same of what the operator is offered.
[[nodiscard]] std::optional<StickFileKind> operator_kind_of_name(std::string_view name);

/// Hidden files and folders, and those that systems put on sticks for themselves.
[[nodiscard]] bool is_left_out(std::string_view name);

/// A text that describes a file lies beside it: "boat.txt" for "boat.jpg".
[[nodiscard]] std::string side_car_of(std::string_view name);

/// What to do with an office file: one sentence for screen and voice.
[[nodiscard]] std::string_view office_sentence();

}  // namespace touchline
