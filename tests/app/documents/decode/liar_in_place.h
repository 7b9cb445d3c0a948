// Puts the liar in place of the workers, and checks what it may not leave behind.
#pragma once

#include "config/types/pinned.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/wait.h>

namespace touchline {

[[nodiscard]] inline bool is_one_sentence(const std::string& line) {
    return line.size() > 10 && std::none_of(line.begin(), line.end(), [](char c) {
               return static_cast<unsigned char>(c) < 0x20;
           });
}

[[nodiscard]] inline int open_descriptors() {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
        ++count;
    return count;
}

[[nodiscard]] inline bool has_a_child() {
    return waitpid(-1, nullptr, WNOHANG) != -1;
}

[[nodiscard]] inline long resident_kB() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        long kB = 0;
        if (word == "VmRSS:" && status >> kB) return kB;
    }
    return 0;
}

/// The liar replaces the workers as long as this object lives.
class LiarInPlace : private Pinned {
  public:
    /// `folder`: the liar's folder.
    explicit LiarInPlace(const char* folder) { setenv("TOUCHLINE_PROGRAMS", folder, 1); }

    ~LiarInPlace() { setenv("TOUCHLINE_PROGRAMS", programs_.c_str(), 1); }

  private:
    std::string programs_ = std::getenv("TOUCHLINE_PROGRAMS");
};

}  // namespace touchline
