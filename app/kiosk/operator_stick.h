// Picture packs and networks on the operator's stick: touchline-import lists and reads them, on a
// thread beside the screen's. Threads: one; no call waits.
#pragma once

#include "app/process/memory.h"
#include "app/sticks/import.h"
#include "app/sticks/listing.h"

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace touchline {

class OperatorStick {
  public:
    /// `import_program`: the path of touchline-import.
    explicit OperatorStick(const std::string& import_program);

    /// Sets the stick that is plugged in; empty: none, and forgets the list. Does not ask again for
    /// a stick that is listed already.
    void look_at(const std::string& root);

    /// Takes over a list that has been read. Returns one sentence if it could not be read; else
    /// empty.
    [[nodiscard]] std::string poll();

    /// The files' names for the screen, in the order of their numbers.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

    /// The number must be below names().size().
    [[nodiscard]] StickFileKind kind_of(std::size_t file) const { return files_.at(file).kind; }

    /// A function that reads the file, on any thread, and waits for the stick: its bytes in sealed
    /// memory. The number must be below names().size().
    [[nodiscard]] std::function<Result<Mapping, StickRefusal>()> reader_of(std::size_t file) const;

  private:
    /// One thread at a time uses it.
    struct Import {
        explicit Import(const std::string& program) : import(program) {}

        std::mutex mutex;
        StickImport import;
    };

    struct Listed {
        std::string root;
        Result<StickListing, StickRefusal> listing;
    };

    [[nodiscard]] static Listed list(const std::shared_ptr<Import>& import,
                                     const std::string& root);
    [[nodiscard]] std::string take(Listed listed);

    std::shared_ptr<Import> import_;
    std::string root_;
    bool is_due_ = false;  // root_ is to be listed once the list before it has ended
    std::vector<StickEntry> files_;
    std::vector<std::string> names_;
    std::future<Listed> listing_;
};

}  // namespace touchline
