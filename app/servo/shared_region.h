// The memory that kiosk and servo share. Nobody can truncate it under a reader.
// Threads: values; each by one thread at a time.
#pragma once

#include "app/process/memory.h"
#include "config/types/result.h"
#include "haptics/servo/exchange.h"

#include <cstdint>
#include <utility>

namespace touchline {

/// What kiosk and servo share for as long as one servo process lives.
struct ServoRegion {
    static constexpr std::uint64_t known_mark = 0x31'6f'76'72'65'73'6c'74;  // "tlservo1"

    std::uint64_t mark = known_mark;
    std::uint64_t bytes = sizeof(ServoRegion);  // differs in a program built from other sources
    ServoChannel channel;
};

/// One side's view of the region.
class SharedRegion {
  public:
    /// Creates a region: the kiosk's side.
    [[nodiscard]] static Result<SharedRegion> create();
    /// Opens the servo's side. Fails for anything that create() did not make.
    [[nodiscard]] static Result<SharedRegion> open(const Descriptor& descriptor);

    [[nodiscard]] ServoChannel& channel() const;

    [[nodiscard]] const Descriptor& descriptor() const { return descriptor_; }

  private:
    SharedRegion(Descriptor descriptor, Mapping mapping)
        : descriptor_(std::move(descriptor)), mapping_(std::move(mapping)) {}

    Descriptor descriptor_;  // only on the side that created it
    Mapping mapping_;
};

}  // namespace touchline
