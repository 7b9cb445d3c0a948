// Why a file or a stick was not read, and the sentence for it.
// Threads: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace touchline {

/// In the order in which touchline-import tells them by its exit status.
enum class StickRefusal : std::uint8_t {
    gone,  // it was pulled out
    no_such_file,
    no_file,  // a link, a folder, a device: nothing that holds a picture
    too_large,
    empty,
    unreadable,  // an error of the stick or its file system
    locked,      // for another user, as ext4 and NTFS can
    out_of_time,
    not_started,  // the importing program is missing, or cannot be shut in
};

inline constexpr int stick_refusal_count = 9;

/// One sentence: file, why, what to do. `name` as names.h makes it for who gets the sentence; empty
/// for the stick as a whole.
[[nodiscard]] std::string sentence_of(StickRefusal refusal, std::string_view name);

}  // namespace touchline
