// What a captured worker might try.
#pragma once

#include <string_view>
#include <vector>

namespace touchline {

struct Act {
    std::string_view name;
    /// 0 or more: it worked. -1: refused, with errno.
    long (*run)();
    bool is_of_files = false;  // Landlock alone denies it too
};

[[nodiscard]] const std::vector<Act>& acts();

}  // namespace touchline
