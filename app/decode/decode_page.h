// What a worker makes of a document: one page of it. Only the program touchline-decode calls this,
// shut in (app/sandbox).
// Threads: any; no state is kept.
#pragma once

#include "app/decode/page.h"
#include "app/decode/page_order.h"

#include <cstddef>
#include <span>

namespace touchline {

/// Loads what the libraries of this kind read from files at their first use, fonts above all: shut
/// in they could not.
void prepare_libraries(WorkerKind kind);

/// Fails with one line for anything that is no document, damaged, too large, or has no such page.
[[nodiscard]] Result<Page> decode_page(std::span<const std::byte> bytes, const PageOrder& order);

}  // namespace touchline
