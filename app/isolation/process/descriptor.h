// What is given back with its owner: a file descriptor, an object of a C library.
// Threads: values; each by one thread at a time; an object as its library says.
#pragma once

#include <cerrno>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

namespace touchline {

/// What fstat() tells.
using FileStatus = struct stat;

/// Closed with its owner.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) noexcept : number_(number) {}

    ~Descriptor() {
        if (is_open()) ::close(number_);
    }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }

    [[nodiscard]] int number() const noexcept { return number_; }

    [[nodiscard]] bool is_open() const noexcept { return number_ >= 0; }

    /// The descriptor must be open. Some file systems report a failed write only here.
    [[nodiscard]] bool close() noexcept { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

/// Writes all of it; false with the reason in errno. Waits.
[[nodiscard]] inline bool write_all(const Descriptor& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

/// True for a file or memory without bytes, or one whose size is unknown.
[[nodiscard]] inline bool is_empty(const Descriptor& file) {
    FileStatus status{};
    return ::fstat(file.number(), &status) != 0 || status.st_size <= 0;
}

/// Releases an object of a C library: calls one function of it, whatever it returns.
template <auto release>
struct ReleasedBy {
    void operator()(auto* object) const { (void)release(object); }
};

template <class T, auto release>
using Owned = std::unique_ptr<T, ReleasedBy<release>>;

}  // namespace touchline
