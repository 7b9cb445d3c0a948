#include "haptics/curve/large_pages.h"

#include <cstdint>

#include <sys/mman.h>

namespace touchline {
namespace {

constexpr std::size_t page_bytes = 4096;
constexpr std::size_t least_bytes = std::size_t{4}
                                    << 20U;  // at least one whole large page lies in it

}  // namespace

void ask_for_large_pages(void* start, std::size_t bytes) {
    if (bytes < least_bytes) return;
    const auto first =
        (reinterpret_cast<std::uintptr_t>(start) + page_bytes - 1) & ~(page_bytes - 1);
    const std::size_t skipped = first - reinterpret_cast<std::uintptr_t>(start);
    (void)::madvise(static_cast<std::byte*>(start) + skipped, bytes - skipped, MADV_HUGEPAGE);
}

}  // namespace touchline
