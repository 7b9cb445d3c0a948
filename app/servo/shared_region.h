// Memory that crosses between processes: a map that nobody can change any more, and the region that
// kiosk and servo share. Neither can be cut short under a reader.
// Threads: values; each by one thread at a time.
#pragma once

#include "config/types/result.h"
#include "haptics/servo/exchange.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace touchline {

/// A file descriptor, closed with its owner.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}

    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }

    [[nodiscard]] int number() const { return number_; }

    [[nodiscard]] bool is_open() const { return number_ >= 0; }

  private:
    int number_;
};

/// A copy of the bytes in memory that nobody can write, grow or shrink. At least one byte.
[[nodiscard]] Result<Descriptor> seal(std::span<const std::byte> bytes);

/// A mapped file, unmapped with its owner.
class Mapping {
  public:
    Mapping(void* start, std::size_t size) : start_(start), size_(size) {}

    ~Mapping();
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    Mapping(Mapping&& other) noexcept
        : start_(std::exchange(other.start_, nullptr)), size_(other.size_) {}

    Mapping& operator=(Mapping&&) = delete;

    [[nodiscard]] void* start() const { return start_; }

    [[nodiscard]] std::span<const std::byte> bytes() const {
        return {static_cast<const std::byte*>(start_), size_};
    }

  private:
    void* start_;
    std::size_t size_;
};

/// Fails for anything but memory sealed against writing, growing, shrinking and further seals, of 1
/// byte to 64 MiB.
[[nodiscard]] Result<Mapping> map_sealed(const Descriptor& descriptor);

/// What kiosk and servo share for as long as one servo process lives.
struct ServoRegion {
    static constexpr std::uint64_t known_mark = 0x31'6f'76'72'65'73'6c'74;  // "tlservo1"

    std::uint64_t mark = known_mark;
    std::uint64_t bytes = sizeof(ServoRegion);  // of a program built from other lines: not ours
    ServoChannel channel;
};

/// The region on one side.
class SharedRegion {
  public:
    /// A fresh one: the kiosk's side.
    [[nodiscard]] static Result<SharedRegion> create();
    /// The servo's side. Fails for anything that create() did not make.
    [[nodiscard]] static Result<SharedRegion> open(const Descriptor& descriptor);

    [[nodiscard]] ServoChannel& channel() const;

    [[nodiscard]] const Descriptor& descriptor() const { return descriptor_; }

  private:
    SharedRegion(Descriptor descriptor, Mapping mapping)
        : descriptor_(std::move(descriptor)), mapping_(std::move(mapping)) {}

    Descriptor descriptor_;  // only where it was created
    Mapping mapping_;
};

}  // namespace touchline
