// The memory that kiosk and servo share. It cannot be cut short under a reader.
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
