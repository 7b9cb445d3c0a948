// A file system in a file, mounted for as long as its owner lives. Only root can do this.
// Threads: one.
#pragma once

#include "config/types/pinned.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

namespace touchline {

/// Returns true for root, to whom the kernel gives loop devices and mounts.
[[nodiscard]] inline bool may_mount() {
    return ::geteuid() == 0 && ::access("/dev/loop-control", W_OK) == 0;
}

/// Runs a command; returns true if it succeeded.
[[nodiscard]] inline bool does(const std::string& command) {
    return std::system(("{ " + command + "; } >/dev/null 2>&1").c_str()) ==
           0;  // NOLINT(cert-env33-c)
}

[[nodiscard]] inline std::string bytes_of_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Mounts the file `image` on the folder `where`.
class MountedImage : private Pinned {
  public:
    /// The device below stays writable, whatever the options say, like a stick's.
    MountedImage(const std::filesystem::path& image, std::filesystem::path where,
                 const std::string& options)
        : where_(std::move(where)),
          is_mounted_(does("device=$(losetup -f --show " + image.string() + ") && mount -o " +
                           options + " $device " + where_.string() +
                           "; status=$?; losetup -d $device; exit $status")) {}

    ~MountedImage() {
        if (is_mounted_) (void)does("umount -l " + where_.string());
    }

    [[nodiscard]] bool is_mounted() const { return is_mounted_; }

  private:
    std::filesystem::path where_;
    bool is_mounted_;
};

}  // namespace touchline
