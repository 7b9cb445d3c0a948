// Memory that processes share, and how a process keeps its own small.
// Threads: values; each by one thread at a time.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "config/types/result.h"

#include <cstddef>
#include <span>
#include <utility>

namespace touchline {

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

/// New, empty memory without a name, which behaves like a file: it can be handed on, written and
/// sealed.
[[nodiscard]] Result<Descriptor> fresh_memory();

/// From now on nobody can write, grow or shrink it. Fails while it is mapped for writing.
[[nodiscard]] Result<void> seal(const Descriptor& memory);

/// Copies the bytes into sealed memory. At least one byte.
[[nodiscard]] Result<Descriptor> sealed_copy(std::span<const std::byte> bytes);

/// Maps it for reading. Fails for anything but sealed memory of 1 byte to `most_bytes`.
[[nodiscard]] Result<Mapping> map_sealed(const Descriptor& memory, std::size_t most_bytes);

/// The bytes of memory whose size nobody can change; 0 for anything else.
[[nodiscard]] std::size_t fixed_size(const Descriptor& memory);

/// Maps it for reading and writing. The size must be fixed, or a reader could die of a missing
/// page.
[[nodiscard]] Result<Mapping> map_shared(const Descriptor& memory);

/// New memory of this fixed size, all zero.
[[nodiscard]] Result<Descriptor> memory_of_size(std::size_t bytes);

/// Keeps a program that runs for months from growing by memory that glibc keeps for speed. Call it
/// at the start of main. Uses one arena for all threads, and maps large blocks singly, so that they
/// are given back when freed. With an arena per thread, and a threshold that grows with freed
/// blocks, pictures loaded on many short-lived threads left some megabytes an hour behind, in holes
/// that nobody filled.
void keep_memory_compact();

}  // namespace touchline
