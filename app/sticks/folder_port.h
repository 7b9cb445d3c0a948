// A folder that stands for the stick on machines without udisks2. A stick is present while the
// folder holds something.
// Threads: one, which calls poll().
#pragma once

#include "app/sticks/stick_port.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

class FolderPort final : public StickPort {
  public:
    /// `folder`: the path of the operator's settings. It may be missing. Offers whatever is mounted
    /// on it or put into it; a change of its files is reported as gone and ready. It is checked
    /// twice a second, so it should be local: a check of a network folder may wait.
    explicit FolderPort(std::string folder);

    [[nodiscard]] std::vector<StickEvent> poll(std::int64_t now_ns) override;

    void allow(FileSystems /*allowed*/) override {}

    /// The folder's contents belong to the operator and are offered to the next visitor too.
    void end_session() override {}

    /// True while the folder exists.
    [[nodiscard]] bool is_watching() const override { return is_watching_; }

  private:
    /// Changes with what is mounted there, and with each name that comes or goes.
    struct Look {
        std::uint64_t device = 0;
        std::uint64_t number = 0;
        std::int64_t changed_s = 0;
        std::int64_t changed_ns = 0;

        friend bool operator==(const Look&, const Look&) = default;
    };

    [[nodiscard]] std::optional<Look> look();

    std::string folder_;
    std::optional<Look> last_;  // none: empty or missing
    std::int64_t next_look_ns_ = 0;
    bool is_watching_ = false;
};

}  // namespace touchline
