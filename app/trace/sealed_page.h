// A page as workers are handed it: sealed memory. Threads: any, each call by itself.
#pragma once

#include "app/decode/page.h"
#include "app/process/descriptor.h"
#include "app/trace/joined.h"
#include "config/types/result.h"

#include <memory>

namespace touchline {

using Sealed = std::shared_ptr<const Descriptor>;

/// As its own worker answered it, without a copy, where nothing was changed in it since.
[[nodiscard]] Result<Sealed> sealed(const Page& page);

/// The same behind other things (joined.h): a copy of all.
[[nodiscard]] Result<Sealed> sealed_behind(ThingsInBytes things, const Page& page);

}  // namespace touchline
