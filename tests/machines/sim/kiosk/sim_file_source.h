// Sticks that come, are listed and are pulled out, on a virtual clock. Threads: one.
#pragma once

#include "app/kiosk/stick_source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

class SimFileSource final : public FileSource {
  public:
    /// Puts in a stick with these files; listing takes so long.
    void put(std::vector<FilePtr> files, double listing_s) {
        files_ = std::move(files);
        listing_s_ = listing_s;
        root_ = "stick";
        is_new_ = true;
    }

    [[nodiscard]] bool is_in() const { return !root_.empty(); }

    /// Pulls the stick out at any moment, even while it is listed.
    void pull() {
        if (root_.empty()) return;
        root_.clear();
        due_ns_.reset();
        is_new_ = false;
        is_gone_ = true;
    }

    [[nodiscard]] std::optional<FilesChange> poll(std::int64_t now_ns) override {
        if (std::exchange(is_gone_, false)) return FilesChange{};
        if (std::exchange(is_new_, false))
            due_ns_ = now_ns + static_cast<std::int64_t>(1e9 * listing_s_);
        if (!due_ns_ || now_ns < *due_ns_) return std::nullopt;
        due_ns_.reset();
        return FilesChange{files_, {}};
    }

    [[nodiscard]] bool is_listing() const override { return due_ns_.has_value(); }

    void allow(FileSystems /*allowed*/) override {}

    void end_session() override { pull(); }

    /// Returns no root: another program would read it in its own time.
    [[nodiscard]] const std::string& root() const override { return no_root_; }

    [[nodiscard]] bool is_watching() const override { return true; }

  private:
    std::vector<FilePtr> files_;
    double listing_s_ = 0.0;
    std::string root_;
    std::string no_root_;
    bool is_new_ = false;
    bool is_gone_ = false;
    std::optional<std::int64_t> due_ns_;
};

}  // namespace touchline
