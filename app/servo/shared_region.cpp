#include "app/servo/sealed_memory.h"

#include <cerrno>
#include <cstring>
#include <new>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int all_seals = F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
constexpr int size_seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
constexpr std::size_t most_bytes = std::size_t{64} << 20;

tl::unexpected<Error> memory_failure(const std::string& what) {
    return failure(what + ": " + std::strerror(errno));
}

bool write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

Result<Mapping> map(const Descriptor& descriptor, std::size_t size, int protection) {
    void* const start =
        ::mmap(nullptr, size, protection, MAP_SHARED | MAP_POPULATE, descriptor.number(), 0);
    if (start == MAP_FAILED) return memory_failure("shared memory cannot be mapped");
    return Mapping(start, size);
}

/// The size of memory that has these seals at least; 0 for anything else.
std::size_t sealed_size(const Descriptor& descriptor, int seals) {
    const int found = ::fcntl(descriptor.number(), F_GET_SEALS);

    struct stat status {};

    if (found < 0 || (found & seals) != seals || ::fstat(descriptor.number(), &status) != 0 ||
        status.st_size <= 0) {
        return 0;
    }
    return static_cast<std::size_t>(status.st_size);
}

}  // namespace

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

Mapping::~Mapping() {
    if (start_ != nullptr) ::munmap(start_, size_);
}

Result<Descriptor> seal(std::span<const std::byte> bytes) {
    Descriptor memory(::memfd_create("touchline-map", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!memory.is_open()) return memory_failure("no memory for the map");
    if (!write_all(memory.number(), bytes)) return memory_failure("no memory for the map");
    if (::fcntl(memory.number(), F_ADD_SEALS, all_seals) != 0) {
        return memory_failure("the map cannot be sealed");
    }
    return memory;
}

Result<Mapping> map_sealed(const Descriptor& descriptor) {
    const std::size_t size = sealed_size(descriptor, all_seals);
    if (size == 0 || size > most_bytes) return failure("the map came in memory that is not sealed");
    return map(descriptor, size, PROT_READ);
}

Result<SharedRegion> SharedRegion::create() {
    Descriptor memory(::memfd_create("touchline-servo", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!memory.is_open() || ::ftruncate(memory.number(), sizeof(ServoRegion)) != 0 ||
        ::fcntl(memory.number(), F_ADD_SEALS, size_seals) != 0) {
        return memory_failure("no memory to share with the servo");
    }
    auto mapping = map(memory, sizeof(ServoRegion), PROT_READ | PROT_WRITE);
    if (!mapping) return tl::unexpected(mapping.error());
    new (mapping->start()) ServoRegion;
    return SharedRegion(std::move(memory), std::move(*mapping));
}

Result<SharedRegion> SharedRegion::open(const Descriptor& descriptor) {
    if (sealed_size(descriptor, size_seals) != sizeof(ServoRegion)) {
        return failure("the memory shared with the kiosk is not what this servo knows");
    }
    auto mapping = map(descriptor, sizeof(ServoRegion), PROT_READ | PROT_WRITE);
    if (!mapping) return tl::unexpected(mapping.error());
    const auto& region = *static_cast<const ServoRegion*>(mapping->start());
    if (region.mark != ServoRegion::known_mark || region.bytes != sizeof(ServoRegion)) {
        return failure("the memory shared with the kiosk is not what this servo knows");
    }
    return SharedRegion(Descriptor{}, std::move(*mapping));
}

ServoChannel& SharedRegion::channel() const {
    return static_cast<ServoRegion*>(mapping_.start())->channel;
}

}  // namespace touchline
