// What the stick that is there offers, as it comes and goes.
// Threads: one; no call waits. It lists on a thread of its own, which the end waits for.
#pragma once

#include "app/kiosk/stick_files.h"
#include "app/loading/stages.h"
#include "app/sticks/stick_port.h"

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The files that a stick offers now; none: it went, or offers nothing.
struct ShelfChange {
    std::vector<FilePtr> files;
    std::string sentence;  // for the person; may be empty
};

class StickShelf {
  public:
    /// `import_program`: the path of touchline-import.
    StickShelf(std::unique_ptr<StickPort> port, const std::string& import_program);

    /// The last thing that changed. Several times a second; `now_ns` of the monotonic clock.
    [[nodiscard]] std::optional<ShelfChange> poll(std::int64_t now_ns);

    /// Files of a stick are being looked for.
    [[nodiscard]] bool is_listing() const { return is_due_ || listing_.valid(); }

    /// The visitor is done: see StickPort.
    void end_session() {
        port_->end_session();
        reader_->forget();
    }

    /// Of the stick that is there; empty: none.
    [[nodiscard]] const std::string& root() const { return root_; }

    /// False while sticks could come and nobody would tell.
    [[nodiscard]] bool is_watching() const { return port_->is_watching(); }

  private:
    using Listed = Result<StickListing, StickRefusal>;

    std::optional<ShelfChange> take(const StickEvent& event);
    [[nodiscard]] ShelfChange shelved(const Listed& listed) const;

    std::unique_ptr<StickPort> port_;
    std::shared_ptr<StickReader> reader_;
    std::string root_;     // of the stick that is there; empty: none
    bool is_due_ = false;  // root_ is to be listed, when the listing before it has ended
    std::future<Listed> listing_;
};

}  // namespace touchline
