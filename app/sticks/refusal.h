// The reasons why a file or a stick was not read, and the sentence for each.
// Threads: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace touchline {

/// In the order of touchline-import's exit statuses.
enum class StickRefusal : std::uint8_t {
    gone,  // it was pulled out
    no_such_file,
    no_file,  // a link, a folder, a device: nothing that holds a picture
    too_large,
    empty,
    unreadable,  // an error of the stick or its file system
    locked,      // for another user, as is possible on ext4 and NTFS
    out_of_time,
    not_started,  // the importing program is missing, or its sandbox fails
};

inline constexpr int stick_refusal_count = 9;

/// One sentence: file, why, what to do. `name` comes from names.h, in the form for the listener;
/// empty for the stick as a whole.
[[nodiscard]] std::string sentence_of(StickRefusal refusal, std::string_view name);

}  // namespace touchline
