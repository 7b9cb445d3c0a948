#include "app/servo/shared_region.h"

#include <new>

namespace touchline {

Result<SharedRegion> SharedRegion::create() {
    auto memory = memory_of_size(sizeof(ServoRegion));
    if (!memory) return tl::unexpected(memory.error());
    auto mapping = map_shared(*memory);
    if (!mapping) return tl::unexpected(mapping.error());
    new (mapping->start()) ServoRegion;
    return SharedRegion(std::move(*memory), std::move(*mapping));
}

Result<SharedRegion> SharedRegion::open(const Descriptor& descriptor) {
    if (fixed_size(descriptor) != sizeof(ServoRegion)) {
        return failure("the memory shared with the kiosk is not what this servo knows");
    }
    auto mapping = map_shared(descriptor);
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
