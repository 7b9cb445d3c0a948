// A stick as the kiosk reads it: by touchline-import, which can be left behind where a broken stick
// holds it for ever. The kiosk itself touches no path of a stick.
// Threads: one at a time. A call's process dies with the thread that called.
#pragma once

#include "app/process/child.h"
#include "app/process/descriptor.h"
#include "app/sticks/listing.h"
#include "app/sticks/refusal.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// Largest file of a kind that is read: what its decoder takes (app/sandbox/limits.h).
[[nodiscard]] std::size_t most_bytes_of(StickFileKind kind);

inline constexpr std::size_t most_side_car_bytes = std::size_t{64} << 10U;

/// On the wall. A list ends by itself before.
struct ImportDeadlines {
    double list_s = 4.0;
    double read_s = 20.0;
};

class StickImport {
  public:
    /// `program`: the path of touchline-import.
    explicit StickImport(std::string program, ImportDeadlines deadlines = {});

    /// What the stick with this root offers. Waits at most list_s and a moment.
    [[nodiscard]] Result<StickListing, StickRefusal> list(const std::string& root);

    /// What its root has for the operator: packs of pictures, networks.
    [[nodiscard]] Result<StickListing, StickRefusal> list_operator_files(const std::string& root);

    /// All bytes of a file, in sealed memory. Waits at most read_s and a moment.
    [[nodiscard]] Result<Descriptor, StickRefusal> read(const std::string& root,
                                                        const StickEntry& entry);

    /// The same of the text that describes it (side_car_of()); no_such_file for most.
    [[nodiscard]] Result<Descriptor, StickRefusal> read_side_car(const std::string& root,
                                                                 const StickEntry& entry);

    /// Processes that could not be ended yet. Every call looks for those that are dead by now.
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
