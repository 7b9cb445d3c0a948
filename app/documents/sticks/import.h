// The kiosk reads a stick through touchline-import, a process that can be left behind if a broken
// stick blocks it forever. The kiosk itself touches no path of a stick.
// Threads: one at a time. A call's process dies with the thread that called.
#pragma once

#include "app/documents/sticks/listing.h"
#include "app/isolation/process/child.h"
#include "app/isolation/process/descriptor.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// The largest file of a kind that is read: the limit of its decoder
/// (app/isolation/sandbox/limits.h).
[[nodiscard]] std::size_t most_bytes_of(StickFileKind kind);

/// By the wall clock. Listing ends by itself before.
struct ImportDeadlines {
    double list_s = 4.0;
    double read_s = 20.0;
};

class StickImport {
  public:
    /// `program`: the path of touchline-import.
    explicit StickImport(std::string program, ImportDeadlines deadlines = {});

    /// Lists what the stick with this root offers. Waits at most a moment longer than list_s.
    [[nodiscard]] Result<StickListing, StickRefusal> list(const std::string& root);

    /// Lists what its root holds for the operator: packs of pictures, networks.
    [[nodiscard]] Result<StickListing, StickRefusal> list_operator_files(const std::string& root);

    /// Reads all bytes of a file into sealed memory. Waits at most a moment longer than read_s.
    [[nodiscard]] Result<Descriptor, StickRefusal> read(const std::string& root,
                                                        const StickEntry& entry);

    /// The same for the text that describes it (app/documents/decode/opening.h); no_such_file for
    /// most files.
    [[nodiscard]] Result<Descriptor, StickRefusal> read_side_car(const std::string& root,
                                                                 const StickEntry& entry);

    /// The processes that could not be ended yet. Every call reaps those that have died since.
    [[nodiscard]] std::size_t left_behind() const { return left_behind_.size(); }

  private:
    Result<StickListing, StickRefusal> listed(const std::vector<std::string>& words);
    Result<Descriptor, StickRefusal> run(const std::vector<std::string>& words, double deadline_s);
    Result<Descriptor, StickRefusal> copy(const std::string& root, const StickEntry& entry,
                                          const std::string& name, std::size_t most_bytes);
    void reap_dead();

    std::string program_;
    ImportDeadlines deadlines_;
    std::vector<Child> left_behind_;
};

}  // namespace touchline
