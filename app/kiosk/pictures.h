// The pictures of a visit: the file behind each choice, the one that is ordered, on its way from
// its file, and the one that is felt until then. Threads: one; no call but read_gallery() waits.
#pragma once

#include "app/kiosk/attract.h"
#include "app/kiosk/loading/loader.h"
#include "app/kiosk/loading/stages.h"
#include "app/kiosk/picture_facts.h"
#include "app/screen/line_drawing.h"
#include "app/visit/visit.h"
#include "app/visit/visit_orders.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// The gallery's titles to choose from, and the files behind them.
struct Gallery {
    std::vector<std::vector<GalleryTitle>> titles;  // one list per language
    std::vector<std::vector<FilePtr>> files;        // one list per language, in the same order
    FilePtr circle, square;                         // to practise on
    std::vector<LineDrawingPtr> lines;              // in the same order; null: of a pack
    AttractPicture attract;                         // shown while nobody is here
};

/// What can be chosen under Gallery: its pictures and those of packs, or of packs alone.
enum class Offered : std::uint8_t { all, packs };

/// The maps of `folder` in every language, then the pictures of the packs in `library`
/// (app/documents/packs; empty: none). Fails with one line if the folder cannot be used. Waits for
/// one worker per picture of a pack, and per recorded title.
[[nodiscard]] Result<Gallery> read_gallery(const std::string& folder, const std::string& library,
                                           const std::vector<Language>& languages,
                                           Offered offered = Offered::all);

class Pictures {
  public:
    explicit Pictures(Gallery gallery) : gallery_(std::move(gallery)) {}

    [[nodiscard]] const std::vector<std::vector<GalleryTitle>>& titles() const {
        return gallery_.titles;
    }

    [[nodiscard]] const AttractPicture& attract() const { return gallery_.attract; }

    /// The lines of the picture with this title in its list; null: they are not known. O(pictures).
    [[nodiscard]] LineDrawingPtr lines_of(PictureSource source, const std::string& title,
                                          std::size_t language) const;

    /// The picture is felt: keeps its lines for the list until the visitor or the stick goes.
    void keep_lines(PictureSource source, const std::string& title, const TactileMap& map);

    void put_stick(std::vector<FilePtr> files);

    /// These are offered to every visitor in a stick's place, while there is none.
    void give(std::vector<FilePtr> files) { given_ = std::move(files); }

    void put_photo(FilePtr photo) { photo_ = std::move(photo); }

    /// Null if it does not exist, or is gone.
    [[nodiscard]] FilePtr of(const LoadPicture& order) const;

    /// The visitor is gone: releases their files.
    void forget();

  private:
    Gallery gallery_;
    std::vector<FilePtr> given_;
    std::vector<FilePtr> stick_;
    FilePtr photo_;
    std::map<std::pair<PictureSource, std::string>, LineDrawingPtr> felt_;  // by their titles
};

/// What a delivery means for the visit and the servo.
struct PictureNews {
    VisitEvent event;
    std::optional<FeltPicture> felt = {};  // nothing: what was felt stays
    bool is_better = false;                // the same picture was felt before
    std::string line = {};                 // for the log; empty: nothing to say
};

class OrderedPicture {
  public:
    explicit OrderedPicture(std::unique_ptr<Loader> loader) : loader_(std::move(loader)) {}

    /// `listed`: the file that the order stands for in its list; null: it is gone, and the visit is
    /// told so. Another part or detail of what a visitor brought comes from that same file,
    /// whatever is at its place in the list by now.
    [[nodiscard]] std::optional<PictureFailed> want(const LoadPicture& order,
                                                    const Visitor& visitor, const FilePtr& listed,
                                                    const Language& language);

    /// What is felt stays, and no better version of it comes later.
    void cancel();

    /// As Loader::poll().
    [[nodiscard]] std::vector<Delivery> poll() { return loader_->poll(); }

    /// As Loader::take_things().
    [[nodiscard]] std::optional<ThingsFound> take_things() { return loader_->take_things(); }

    /// Nothing: nobody waits for it any more.
    [[nodiscard]] std::optional<PictureNews> take(const Delivery& delivery,
                                                  const Language& language);

    /// The visitor is gone: releases all that was theirs.
    void forget();

    /// The order of the picture that is loading, else of the one that is felt.
    [[nodiscard]] const LoadPicture& order() const { return order_; }

    [[nodiscard]] const ShownScene& shown() const { return shown_; }

    /// The map that is felt; null: none.
    [[nodiscard]] const TactileMap* map() const { return map_.get(); }

    /// A drawing is felt, which nothing loads. Returns its facts.
    PictureFacts put_drawing(std::uint64_t request, const LoadedScene& drawing,
                             const Language& language);

    /// As touchline::part_at() for the map that is felt.
    [[nodiscard]] std::optional<std::size_t> part_at(const HandState& hand) const;

  private:
    [[nodiscard]] PictureNews refuse(const Delivery& delivery, const Language& language);
    void stay_with_felt();

    std::unique_ptr<Loader> loader_;
    LoadPicture order_;  // the last one
    FilePtr wanted_;     // its file
    bool is_loading_ = false;
    FilePtr felt_file_;       // the file that is felt
    LoadPicture felt_order_;  // the order that brought it
    ShownScene shown_;
    std::shared_ptr<const TactileMap> map_;
    std::vector<PartFacts> parts_;  // of map_
};

}  // namespace touchline
