#include "app/sticks/udisks_volumes.h"

#include <cstdint>

namespace touchline {
namespace {

const BusProperties* find(const BusInterfaces& interfaces, const std::string& name) {
    const auto found = interfaces.find("org.freedesktop.UDisks2." + name);
    return found == interfaces.end() ? nullptr : &found->second;
}

template <class T>
T get(const BusProperties& properties, const std::string& name) {
    const auto found = properties.find(name);
    if (found == properties.end() || !found->second.containsValueOfType<T>()) return {};
    return found->second.get<T>();
}

/// Paths come as bytes with a zero at their end.
std::vector<std::string> roots_of(const BusProperties& file_system) {
    std::vector<std::string> roots;
    for (const auto& bytes :
         get<std::vector<std::vector<std::uint8_t>>>(file_system, "MountPoints")) {
        std::string root(bytes.begin(), bytes.end());
        while (root.ends_with('\0')) root.pop_back();
        if (!root.empty()) roots.push_back(std::move(root));
    }
    return roots;
}

}  // namespace

std::vector<Volume> volumes_of(const BusObjects& objects) {
    std::vector<Volume> volumes;
    for (const auto& [path, interfaces] : objects) {
        const BusProperties* const block = find(interfaces, "Block");
        if (block == nullptr) continue;
        const auto drive_path = get<sdbus::ObjectPath>(*block, "Drive");
        const auto drive_object = objects.find(drive_path);
        if (drive_object == objects.end()) continue;
        const BusProperties* const drive = find(drive_object->second, "Drive");
        if (drive == nullptr) continue;
        Volume volume;
        volume.object = path;
        volume.drive = drive_path;
        volume.bus = get<std::string>(*drive, "ConnectionBus");
        volume.usage = get<std::string>(*block, "IdUsage");
        volume.file_system = get<std::string>(*block, "IdType");
        volume.detected_us = get<std::uint64_t>(*drive, "TimeMediaDetected");
        volume.bytes = get<std::uint64_t>(*block, "Size");
        volume.is_of_system = get<bool>(*block, "HintSystem");
        volume.is_ignored = get<bool>(*block, "HintIgnore");
        volume.is_partitioned = find(interfaces, "PartitionTable") != nullptr;
        if (const BusProperties* const files = find(interfaces, "Filesystem"); files != nullptr)
            volume.roots = roots_of(*files);
        volumes.push_back(std::move(volume));
    }
    return volumes;
}

}  // namespace touchline
