// Counts what this program and its libraries allocate. malloc's own statistics count freed blocks
// that a thread keeps for later as used, and do not tell threads apart.
#include "tests/machines/sim/allocated_bytes.h"

#include <cerrno>
#include <cstddef>

#include <malloc.h>

namespace {

thread_local std::int64_t bytes = 0;

}  // namespace

std::int64_t touchline::allocated_bytes() {
    return bytes;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

void* counted(void* block) {
    bytes += static_cast<std::int64_t>(malloc_usable_size(block));
    return block;
}

void forget(void* block) {
    bytes -= static_cast<std::int64_t>(malloc_usable_size(block));
}

}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
    return counted(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) {
    return counted(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) {
    forget(block);
    return counted(__libc_realloc(block, size));
}

void* memalign(std::size_t alignment, std::size_t size) {
    return counted(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return counted(__libc_memalign(alignment, size));
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
    *block = counted(__libc_memalign(alignment, size));
    return *block == nullptr ? ENOMEM : 0;
}

void free(void* block) {
    forget(block);
    __libc_free(block);
}
}

#endif
