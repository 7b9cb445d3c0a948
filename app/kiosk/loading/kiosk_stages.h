// The kiosk's stages: workers, vision, and the scene for its device.
// Threads: any, each call by itself.
#pragma once

#include "app/documents/decode/found_words.h"
#include "app/documents/trace/trace_work.h"
#include "app/kiosk/loading/stages.h"
#include "haptics/pantograph/profile.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace touchline {

/// Reads words in a page's pixels. Returns the page with their boxes and labels; nothing if there
/// are none. Takes seconds. Called from any thread, one call at a time.
using PageReader = std::function<std::optional<Page>(const Page&)>;

/// Finds a photograph's main things, its faces and what they probably are, or one further thing at
/// a place. Returns the page with them; nothing if none is clear there. Fails with one line that
/// names no file if the search cannot run now. Takes seconds. Called from any thread, one call at a
/// time.
using ThingFinder =
    std::function<Result<std::optional<Page>>(const Page&, const std::optional<PlaceInPicture>&)>;

/// Reads by the worker of app/documents/decode, in the language that `language` holds at the call;
/// it may change meanwhile. If reading fails, or finds nothing, the page stays as it was felt.
[[nodiscard]] PageReader page_reader(std::shared_ptr<const std::atomic<WrittenLanguage>> language);

/// Looks with networks in their worker. Works without the figure's network if that is not
/// installed, or if less than 2 GB of memory are free. Fails if a network is damaged or its worker
/// fails.
[[nodiscard]] ThingFinder thing_finder();

class KioskStages final : public Stages {
  public:
    /// Without a reader no words are read. Without a finder no main thing is found, and the visitor
    /// is told so.
    explicit KioskStages(DeviceProfile profile, PageReader reader = {}, ThingFinder finder = {});

    [[nodiscard]] Result<PagePtr> open(const PictureFile& file, int page) const override;
    [[nodiscard]] Result<FoundPtr> find(const PictureFile& file, const PagePtr& page, int view,
                                        const FeltPart& part) const override;
    [[nodiscard]] Result<LoadedScene> build(const PictureFile& file, const FoundView& found,
                                            const FeltPart& part) const override;

    [[nodiscard]] bool has_looking() const override { return static_cast<bool>(finder_); }

    [[nodiscard]] Result<PagePtr> look(const PagePtr& page) const override;
    [[nodiscard]] Result<PagePtr> look_at(const PagePtr& page, int view,
                                          const Position& place) const override;

    [[nodiscard]] bool has_reading() const override { return static_cast<bool>(reader_); }

    [[nodiscard]] FoundPtr reread(const FoundView& found) const override;

  private:
    [[nodiscard]] Result<PagePtr> seen(const PagePtr& page,
                                       const std::optional<PlaceInPicture>& place) const;

    DeviceProfile profile_;
    PageReader reader_;
    ThingFinder finder_;
};

/// An empty picture, so that after a visit nothing of it stays with the servo.
[[nodiscard]] FeltPicture nothing_to_feel(const DeviceProfile& profile);

/// What is felt and shown of a drawing, whose version it numbers. Its errors are those of
/// build_scene(). O(N log N).
[[nodiscard]] Result<LoadedScene> scene_of_drawing(TactileMap drawing,
                                                   const DeviceProfile& profile);

/// The file at a path, with the text beside it.
[[nodiscard]] FilePtr file_at(const std::string& path);

}  // namespace touchline
