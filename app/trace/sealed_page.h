// A page as workers are handed it: sealed memory. Threads: any, each call by itself.
#pragma once

#include "app/decode/page.h"
#include "app/process/descriptor.h"
#include "config/types/result.h"

#include <cstddef>
#include <memory>
#include <span>

namespace touchline {

using Sealed = std::shared_ptr<const Descriptor>;

/// As its own worker answered it, without a copy, where nothing was changed in it since.
[[nodiscard]] Result<Sealed> sealed(const Page& page);

/// The same behind something else (two_parts.h): a copy of both.
[[nodiscard]] Result<Sealed> sealed_behind(std::span<const std::byte> first, const Page& page);

}  // namespace touchline
