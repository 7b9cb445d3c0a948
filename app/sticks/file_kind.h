// Decides by name alone which files of a stick are offered. The process that opens a file learns
// from its first bytes what it really is.
// Threads: pure functions. O(n).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// picture: one image. document: pages or vectors. office: listed so that one sentence can ask for
/// a PDF of it; it is not opened. Only for the operator: pack, of pictures; network, one that
/// Touchline knows (app/models).
enum class StickFileKind : std::uint8_t { picture, document, office, pack, network };

inline constexpr int stick_file_kind_count = 5;

/// Decides by the ending, in any case. Nothing for a file that is not offered, or that is only for
/// the operator.
[[nodiscard]] std::optional<StickFileKind> kind_of_name(std::string_view name);

/// The same for what the operator is offered.
[[nodiscard]] std::optional<StickFileKind> operator_kind_of_name(std::string_view name);

/// True for hidden files and folders, and for those that systems put on sticks for themselves.
[[nodiscard]] bool is_left_out(std::string_view name);

/// The name of the text that describes a file and lies beside it: "boat.txt" for "boat.jpg".
[[nodiscard]] std::string side_car_of(std::string_view name);

/// What to do with an office file: one sentence for screen and voice.
[[nodiscard]] std::string_view office_sentence();

}  // namespace touchline
