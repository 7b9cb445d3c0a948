// The pictures of sticks as files of the list. touchline-import reads their bytes.
// Threads: any; one at a time reads, the others wait for it.
#pragma once

#include "app/loading/stages.h"
#include "app/process/memory.h"
#include "app/sticks/import.h"
#include "app/sticks/listing.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The bytes of a file, and of the text file beside it if there is one.
struct StickBytes {
    std::string root;
    StickEntry entry;
    Mapping document;
    std::optional<Mapping> side_car;
    std::uint64_t stick = 0;  // the number of its stick
};

/// One reader serves all sticks in turn, so that a process held up by a stick can be reaped later.
/// The last file read stays in memory: all pages of a document come from one reading.
class StickReader {
  public:
    explicit StickReader(const std::string& import_program) : import_(import_program) {}

    [[nodiscard]] Result<StickListing, StickRefusal> list(const std::string& root);

    [[nodiscard]] Result<std::shared_ptr<const StickBytes>, StickRefusal> read(
        const std::string& root, const StickEntry& entry);

    /// Called when a stick, or its visitor, comes or goes. From now on no file of the one before is
    /// given. Never waits for a read under way.
    void forget();

  private:
    [[nodiscard]] std::shared_ptr<const StickBytes> last_of(const std::string& root,
                                                            const StickEntry& entry) const;
    void keep(const std::shared_ptr<const StickBytes>& bytes);
    std::optional<Mapping> side_car(const std::string& root, const StickEntry& entry);

    std::mutex mutex_;  // for import_; held while a file is read
    StickImport import_;
    std::atomic<std::uint64_t> stick_{0};
    mutable std::mutex last_mutex_;  // for last_; held only to copy or set it
    std::shared_ptr<const StickBytes> last_;
};

/// Returns one file per entry, in the same order. Office files are among them: opening one says
/// what to do.
[[nodiscard]] std::vector<FilePtr> files_of_stick(const std::shared_ptr<StickReader>& reader,
                                                  const std::string& root,
                                                  const StickListing& listing);

}  // namespace touchline
