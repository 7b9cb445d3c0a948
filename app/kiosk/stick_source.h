// What the plugged-in stick offers, as sticks come and go.
// Threads: one; no call waits. It lists on a thread of its own; the destructor waits for it.
#pragma once

#include "app/kiosk/file_source.h"
#include "app/kiosk/stick_files.h"
#include "app/sticks/stick_port.h"

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

class StickSource final : public FileSource {
  public:
    /// `import_program`: the path of touchline-import.
    StickSource(std::unique_ptr<StickPort> port, const std::string& import_program);

    [[nodiscard]] std::optional<FilesChange> poll(std::int64_t now_ns) override;

    [[nodiscard]] bool is_listing() const override { return is_due_ || listing_.valid(); }

    void allow(FileSystems allowed) override { port_->allow(allowed); }

    void end_session() override {
        port_->end_session();
        reader_->forget();
    }

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

}  // namespace touchline
