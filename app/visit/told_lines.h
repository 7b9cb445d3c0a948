// What went wrong, as visitors and staff hear it. Rewords English lines of other parts of the kiosk
// (a Result's, the servo's): in their language, without names of a format's parts and numbers of
// bytes, and with something that can be done here. Every text is in the catalogue, context
// "trouble"; the device's sentences are in "device". Threads: constant data and pure functions.
#pragma once

#include "app/printing/print_end.h"
#include "audio-cues/words/language.h"
#include "config/types/hand_state.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

enum class ToldTo : std::uint8_t { visitor, staff };

/// `part` recognizes a line; `told` is said for it. "*" stands for anything.
struct LineRow {
    std::string_view part;
    std::string_view told;
    std::string_view staff_told{};  // if `told` sends a visitor to the staff; empty: the same
};

/// The first row that fits counts.
[[nodiscard]] std::span<const LineRow> file_lines();
[[nodiscard]] std::span<const LineRow> device_lines();

inline constexpr std::string_view picture_trouble =
    "This picture cannot be felt. Choose another one.";
inline constexpr std::string_view stick_trouble =
    "The USB stick cannot be read. Put it in again, or try another one.";
inline constexpr std::string_view crowded_picture =
    "The picture has more lines than can be felt. Only the strongest are kept.";
inline constexpr std::string_view device_trouble =
    "The handle does not work now. Please call the staff.";
inline constexpr std::string_view staffs_device_trouble =
    "The handle does not work now. Check its cable. The log says why.";

/// Why a picture, a file or a stick cannot be felt. Leaves out the file's name in `line`, which may
/// hold anything. `general` is said for a line that no row knows. Empty for an empty line.
[[nodiscard]] std::string told_of_file(const std::string& line, std::string_view general,
                                       const Language& language, ToldTo to = ToldTo::visitor);

/// What the device reports: the sentences of app/force/device/device_words.h, one by one, with
/// their numbers; or why there is no force. Empty for an empty line.
[[nodiscard]] std::string told_of_device(const std::string& line, const Language& language,
                                         ToldTo to = ToldTo::visitor);

/// Why a sheet was not printed, or what its printer lacks. Not for `printed`.
[[nodiscard]] std::string told_of_print(PrintEnd end, const Language& language,
                                        ToldTo to = ToldTo::visitor);

/// Whole sentences in English for a person who may not see the screen. A visitor has no key that
/// brings the force back; only the staff can end a fault.
struct FaultWords {
    std::string_view why;
    std::string_view visitor_does;
    std::string_view staff_does;
};

/// Returns the words of any fault but none.
[[nodiscard]] FaultWords words_of(Fault fault);

/// Says that the force is off, why, what the visitor can do, and that exploring goes on. Empty for
/// none.
[[nodiscard]] std::string spoken_fault(Fault fault, const Language& language);

/// The same for the staff: adds what they do, and the item of their menu that ends the fault if it
/// does not end by itself.
[[nodiscard]] std::string staffs_fault(Fault fault, const Language& language);

}  // namespace touchline
