#include "tests/haptics/call_counts.h"

#include <cstdlib>
#include <new>
#include <utility>

namespace {

thread_local bool is_counting = false;
thread_local touchline::CallCounts counts;

void count_allocation() {
    if (is_counting) ++counts.allocations;
}

}  // namespace

// Not inlined, or the compiler would pair malloc with operator delete and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
    count_allocation();
    if (void* const p = std::malloc(size)) return p;
    throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* p) noexcept {
    count_allocation();
    std::free(p);
}

[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
    operator delete(p);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <dlfcn.h>
#include <pthread.h>

namespace {

/// Returns the function that ours replaces.
template <class Function>
Function* original(Function* /*ours*/, const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void count_lock() {
    if (is_counting) ++counts.locks;
}

}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* p, std::size_t size);
void __libc_free(void* p);

void* malloc(std::size_t size) {
    count_allocation();
    return __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size) {
    count_allocation();
    return __libc_calloc(number, size);
}

void* realloc(void* p, std::size_t size) {
    count_allocation();
    return __libc_realloc(p, size);
}

void free(void* p) {
    count_allocation();
    __libc_free(p);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    static auto* const next = original(&pthread_mutex_lock, "pthread_mutex_lock");
    count_lock();
    return next(mutex);
}

int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
    static auto* const next = original(&pthread_mutex_trylock, "pthread_mutex_trylock");
    count_lock();
    return next(mutex);
}

int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
    static auto* const next = original(&pthread_rwlock_rdlock, "pthread_rwlock_rdlock");
    count_lock();
    return next(lock);
}

int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
    static auto* const next = original(&pthread_rwlock_wrlock, "pthread_rwlock_wrlock");
    count_lock();
    return next(lock);
}
}

#endif

namespace touchline {

CallCounter::CallCounter() {
    is_counting = true;
}

CallCounter::~CallCounter() {
    is_counting = false;
}

CallCounts take_call_counts() {
    return std::exchange(counts, {});
}

}  // namespace touchline
