// The pictures that can be chosen: those of the stick first, then those that were named, then the
// gallery's.
// Threads: one.
#pragma once

#include "app/loading/stages.h"

#include <optional>
#include <utility>
#include <vector>

namespace touchline {

class PictureList {
  public:
    explicit PictureList(std::vector<FilePtr> standing) : standing_(std::move(standing)) {}

    /// The stick's files from now on; none: there is none.
    void put_stick(std::vector<FilePtr> files) { of_stick_ = std::move(files); }

    [[nodiscard]] int size() const;

    [[nodiscard]] int stick_size() const { return static_cast<int>(of_stick_.size()); }

    /// `place` from 0, below size().
    [[nodiscard]] const FilePtr& at(int place) const;

    /// Nothing for a file that is not in it, or none.
    [[nodiscard]] std::optional<int> place_of(const FilePtr& file) const;

  private:
    std::vector<FilePtr> standing_;
    std::vector<FilePtr> of_stick_;
};

}  // namespace touchline
