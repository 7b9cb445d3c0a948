// Private to app/documents/decode: texts by programs and cameras in places meant for a person's
// words. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>

namespace touchline::decode {

/// True for texts such as "OLYMPUS DIGITAL CAMERA", "oznor", "filter: 0; jpegRotation: 0;",
/// "Created with Sketch.", "untitled", "Microsoft Word - Doc1.docx", "Slice 1". Nobody is told
/// them, because a file's own name says more. O(text).
[[nodiscard]] bool is_of_a_machine(std::string_view text);

/// The text; empty if a machine wrote it.
[[nodiscard]] inline std::string of_a_person(std::string text) {
    return is_of_a_machine(text) ? std::string() : text;
}

}  // namespace touchline::decode
