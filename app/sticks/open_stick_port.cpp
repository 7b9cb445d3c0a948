#include "app/sticks/open_stick_port.h"

#include "app/sticks/folder_port.h"
#include "app/sticks/udisks_port.h"

namespace touchline {

std::unique_ptr<StickPort> open_stick_port(const std::string& watched_folder) {
    if (!watched_folder.empty()) return std::make_unique<FolderPort>(watched_folder);
    return std::make_unique<UdisksPort>();
}

}  // namespace touchline
