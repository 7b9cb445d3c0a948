// What udisks2 tells of block devices, as volumes. What is missing or of another type than it
// should be counts as not there. Threads: pure functions.
#pragma once

#include "app/sticks/stick_rules.h"

#include <map>
#include <string>
#include <vector>

#include <sdbus-c++/Types.h>

namespace touchline {

using BusProperties = std::map<std::string, sdbus::Variant>;
using BusInterfaces = std::map<std::string, BusProperties>;
/// As org.freedesktop.DBus.ObjectManager.GetManagedObjects answers.
using BusObjects = std::map<sdbus::ObjectPath, BusInterfaces>;

/// Every block device that is on a drive. O(n log n).
[[nodiscard]] std::vector<Volume> volumes_of(const BusObjects& objects);

}  // namespace touchline
