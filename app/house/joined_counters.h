// The counts of several kiosks in one table. Threads: pure functions.
#pragma once

#include "app/operator/counters.h"
#include "config/types/result.h"

#include <string>
#include <vector>

namespace touchline {

struct KioskCounts {
    std::string kiosk;  // its name in the table
    CountedDays days;
};

/// The name of a kiosk by the file that came from it: the file's, without its ending; the folder's
/// for a file that is called as a kiosk calls its own.
[[nodiscard]] std::string kiosk_of_file(const std::string& path);

/// A line of names, then a line for each kiosk and day, sorted by both: "hall,2026-03-01,12,...".
/// Fails with one line if two kiosks have one name, or if a spreadsheet could take a name for
/// anything else. O(n log n).
[[nodiscard]] Result<std::string> joined_counters_csv(std::vector<KioskCounts> kiosks);

}  // namespace touchline
