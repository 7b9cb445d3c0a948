// Reads a stick in touchline-import: opens paths so that nothing leads out of it (no link, no "..",
// no other file system), copies a file, and finds the files in its root and its folders, down to
// deepest_folder. Memory does not grow with the stick: it keeps only names that may be listed.
// Threads: any, each call by itself; a call waits for the stick.
#pragma once

#include "app/documents/sticks/listing.h"
#include "app/documents/sticks/names.h"
#include "app/isolation/process/descriptor.h"
#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace touchline {

/// Closes the sandbox before the first name is read. After that the process can read below `root`,
/// make its output grow to `most_bytes`, and nothing else (app/isolation/sandbox). If this fails,
/// the process must end at once.
[[nodiscard]] Result<void> shut_in(const Descriptor& root, std::size_t most_bytes);

/// Opens `name` in the open folder for reading; -1 with the reason in errno. Never waits for a
/// FIFO's writer. Does not change the file's access time if the file system allows that. `flags`:
/// O_DIRECTORY, or O_PATH to examine the file only.
[[nodiscard]] Descriptor open_beneath(const Descriptor& folder, const std::string& name, int flags);

/// The meaning of a stick's errno for a visitor.
[[nodiscard]] StickRefusal refusal_of(int error);

struct CopyLimits {
    std::size_t most_bytes = 0;
    std::function<bool()> is_time_up = [] { return false; };  // called before every block
};

/// Copies `name` (in `folder` of the stick, as in StickEntry) to the end of `output`. Reads only a
/// regular file: follows no link on the way, and reads not a byte of anything else. Refuses a file
/// that grows or shrinks meanwhile. After a refusal `output` may hold a part. O(bytes).
[[nodiscard]] Result<void, StickRefusal> copy_from_stick(const Descriptor& root,
                                                         const std::string& folder,
                                                         const std::string& name,
                                                         const Descriptor& output,
                                                         const CopyLimits& limits);

/// pictures: what visitors are offered, in the root and all folders. operator_files: what the
/// operator is offered, only in the root.
enum class StickSearch : std::uint8_t { pictures, operator_files };

/// The limits of a scan. If it exceeds one, the listing says that it was cut short.
struct ScanLimits {
    /// The first folders in natural order, one by one; at most most_listed_folders.
    std::size_t most_folders = most_listed_folders;
    std::size_t most_names = 200'000;  // in all folders together, listed or not
    std::function<bool()> is_time_up = [] { return false; };  // called every few hundred names
};

/// Finds regular files of known endings. Skips links, FIFOs, sockets, devices, hidden files and
/// what systems leave behind. Also skips a folder that cannot be read, and the listing says so.
/// Fails only if the root itself cannot be read, with errno's words. O(n log k) for n names and k
/// listed.
[[nodiscard]] Result<StickListing, StickRefusal> scan_stick(const Descriptor& root,
                                                            const NaturalOrder& order,
                                                            const ScanLimits& limits,
                                                            StickSearch search);

}  // namespace touchline
