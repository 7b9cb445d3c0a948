// The program touchline-unpack without its main(): handles one archive, one recording or one
// picture, then ends. Threads: one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// zip | sound | picture LANGUAGE... | layers LANGUAGE
[[nodiscard]] bool is_unpack_work(const std::vector<std::string>& words);

/// The answer, as unpack_answer.h; `words` as above. The bytes may be anything.
[[nodiscard]] std::vector<std::byte> unpack_work(const std::vector<std::string>& words,
                                                 std::span<const std::byte> bytes);

}  // namespace touchline
