// The file behind each choice of a visit. Threads: one.
#pragma once

#include "app/loading/stages.h"
#include "app/session/visit.h"
#include "app/session/visit_orders.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// The gallery's titles to choose from, and the files behind them.
struct Gallery {
    std::vector<std::vector<GalleryTitle>> titles;  // one list per language
    std::vector<std::vector<FilePtr>> files;        // one list per language, in the same order
    FilePtr circle, square;                         // to practise on
};

/// The maps of `folder` in every language, then the pictures of the packs in `library` (app/packs;
/// empty: none). Fails with one line if the folder cannot be used. Waits for one worker per picture
/// of a pack.
[[nodiscard]] Result<Gallery> read_gallery(const std::string& folder, const std::string& library,
                                           const std::vector<Language>& languages);

class Pictures {
  public:
    explicit Pictures(Gallery gallery) : gallery_(std::move(gallery)) {}

    [[nodiscard]] const std::vector<std::vector<GalleryTitle>>& titles() const {
        return gallery_.titles;
    }

    void put_stick(std::vector<FilePtr> files) { stick_ = std::move(files); }

    void put_photo(FilePtr photo) { photo_ = std::move(photo); }

    /// Null if it does not exist, or is gone.
    [[nodiscard]] FilePtr of(const LoadPicture& order) const;

    /// The visitor is gone: releases their files.
    void forget();

  private:
    Gallery gallery_;
    std::vector<FilePtr> stick_;
    FilePtr photo_;
};

}  // namespace touchline
