#include "app/isolation/process/memory.h"

#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int size_seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
constexpr int all_seals = F_SEAL_WRITE | size_seals;

tl::unexpected<Error> memory_failure(const std::string& what) {
    return failure(what + ": " + std::strerror(errno));
}

/// The size of memory that has at least these seals; 0 for anything else.
std::size_t sealed_size(const Descriptor& memory, int seals) {
    const int found = ::fcntl(memory.number(), F_GET_SEALS);
    FileStatus status{};
    if (found < 0 || (found & seals) != seals || ::fstat(memory.number(), &status) != 0 ||
        status.st_size <= 0) {
        return 0;
    }
    return static_cast<std::size_t>(status.st_size);
}

Result<Mapping> map(const Descriptor& memory, std::size_t size, int protection) {
    void* const start =
        ::mmap(nullptr, size, protection, MAP_SHARED | MAP_POPULATE, memory.number(), 0);
    if (start == MAP_FAILED) return memory_failure("shared memory cannot be mapped");
    return Mapping(start, size);
}

}  // namespace

Mapping::~Mapping() {
    if (start_ != nullptr) ::munmap(start_, size_);
}

Result<Descriptor> fresh_memory() {
    Descriptor memory(::memfd_create("touchline", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!memory.is_open()) return memory_failure("there is no memory to share");
    return memory;
}

Result<void> seal(const Descriptor& memory) {
    if (::fcntl(memory.number(), F_ADD_SEALS, all_seals) != 0)
        return memory_failure("memory cannot be sealed");
    return {};
}

Result<Descriptor> sealed_copy(std::span<const std::byte> bytes) {
    auto memory = fresh_memory();
    if (!memory) return memory;
    if (!write_all(*memory, bytes)) return memory_failure("there is no memory to share");
    if (const auto sealed = seal(*memory); !sealed) return tl::unexpected(sealed.error());
    return memory;
}

Result<Mapping> map_sealed(const Descriptor& memory, std::size_t most_bytes) {
    const std::size_t size = sealed_size(memory, all_seals);
    if (size == 0 || size > most_bytes) return failure("what came is no sealed memory");
    return map(memory, size, PROT_READ);
}

std::size_t fixed_size(const Descriptor& memory) {
    return sealed_size(memory, size_seals);
}

Result<Mapping> map_shared(const Descriptor& memory) {
    const std::size_t size = fixed_size(memory);
    if (size == 0) return failure("what came is no shared memory of a fixed size");
    return map(memory, size, PROT_READ | PROT_WRITE);
}

Result<Descriptor> memory_of_size(std::size_t bytes) {
    auto memory = fresh_memory();
    if (!memory) return memory;
    if (::ftruncate(memory->number(), static_cast<off_t>(bytes)) != 0 ||
        ::fcntl(memory->number(), F_ADD_SEALS, size_seals) != 0) {
        return memory_failure("there is no memory to share");
    }
    return memory;
}

void keep_memory_compact() {
    constexpr int large_bytes = 128 * 1024;
    (void)mallopt(M_ARENA_MAX, 1);
    (void)mallopt(M_MMAP_THRESHOLD, large_bytes);
}

}  // namespace touchline
