// What a stick offers, as sticks come and go: to visitors, by the interface that the kiosk uses and
// by the real sticks, and to the operator. touchline-import lists them and reads their bytes.
// Threads: one; no call waits. A thread beside it lists a stick; any thread may open its files.
#pragma once

#include "app/documents/sticks/listing.h"
#include "app/documents/sticks/stick_port.h"
#include "app/isolation/process/memory.h"
#include "app/kiosk/loading/stages.h"
#include "config/types/pinned.h"
#include "config/types/result.h"

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The files that a stick offers now. None: it was removed, or offers nothing.
struct FilesChange {
    std::vector<FilePtr> files;  // in the order of sort_by_name()
    std::string sentence;        // why there are no files, for the person; may be empty
    StickRest rest = {};         // what the stick holds beside the files
    bool is_read = false;  // the search for files has ended; if there are none, the stick has none
};

/// The pictures at these paths, in the order of a list; of a folder, what a stick with these
/// contents would offer. `problems` gets a line for each path that offers none. Waits for
/// touchline-import.
[[nodiscard]] std::vector<FilePtr> files_at(const std::vector<std::string>& paths,
                                            const std::string& import_program,
                                            std::vector<std::string>& problems);

class FileSource : public Interface {
  public:
    /// Returns the latest change. Called several times a second; `now_ns` is of the monotonic
    /// clock.
    [[nodiscard]] virtual std::optional<FilesChange> poll(std::int64_t now_ns) = 0;

    /// True while a stick's files are being listed.
    [[nodiscard]] virtual bool is_listing() const = 0;

    /// See StickPort.
    virtual void allow(FileSystems allowed) = 0;

    /// The visitor is done. See StickPort.
    virtual void end_session() = 0;

    /// The root of the plugged-in stick; empty: none.
    [[nodiscard]] virtual const std::string& root() const = 0;

    /// False while sticks could come unnoticed.
    [[nodiscard]] virtual bool is_watching() const = 0;
};

class StickReader;  // stick_source.cpp

/// What the sticks of a port offer. Its destructor waits for a listing that is under way.
class StickSource final : public FileSource {
  public:
    /// `import_program`: the path of touchline-import.
    StickSource(std::unique_ptr<StickPort> port, const std::string& import_program);

    [[nodiscard]] std::optional<FilesChange> poll(std::int64_t now_ns) override;

    [[nodiscard]] bool is_listing() const override { return is_due_ || listing_.valid(); }

    void allow(FileSystems allowed) override { port_->allow(allowed); }

    void end_session() override;

    [[nodiscard]] const std::string& root() const override { return root_; }

    [[nodiscard]] bool is_watching() const override { return port_->is_watching(); }

  private:
    using Listed = Result<StickListing, StickRefusal>;

    std::optional<FilesChange> take(const StickEvent& event);
    [[nodiscard]] FilesChange change_of(const Listed& listed) const;

    std::unique_ptr<StickPort> port_;
    std::shared_ptr<StickReader> reader_;
    std::string root_;     // root of the plugged-in stick; empty: none
    bool is_due_ = false;  // root_ is to be listed once the listing before it has ended
    std::future<Listed> listing_;
};

/// Picture packs and networks on the operator's stick, listed on a thread beside the screen's.
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
    struct Listed {
        std::string root;
        Result<StickListing, StickRefusal> listing;
    };

    [[nodiscard]] std::string take(Listed listed);

    std::shared_ptr<StickReader> reader_;
    std::string root_;
    bool is_due_ = false;  // root_ is to be listed once the list before it has ended
    std::vector<StickEntry> files_;
    std::vector<std::string> names_;
    std::future<Listed> listing_;
};

}  // namespace touchline
