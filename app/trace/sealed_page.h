// A page in sealed memory, for workers. Threads: any, each call by itself.
#pragma once

#include "app/decode/page.h"
#include "app/process/descriptor.h"
#include "app/trace/joined.h"
#include "config/types/result.h"

#include <memory>

namespace touchline {

using Sealed = std::shared_ptr<const Descriptor>;

/// The answer of the page's own worker, without a copy, if nothing has changed since.
[[nodiscard]] Result<Sealed> sealed(const Page& page);

/// The page after other things (joined.h): a copy of everything.
[[nodiscard]] Result<Sealed> sealed_behind(ThingsInBytes things, const Page& page);

}  // namespace touchline
