#include "app/process/free_memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace touchline {

std::uint64_t free_memory_bytes() {
    std::ifstream file("/proc/meminfo");
    for (std::string name; file >> name;) {
        std::uint64_t kibibytes = 0;
        if (name == "MemAvailable:" && file >> kibibytes) return kibibytes << 10U;
        file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::numeric_limits<std::uint64_t>::max();
}

}  // namespace touchline
