#include "tests/app/kiosk/transcripts/staged_things.h"

#include "app/trace/finding_things.h"
#include "tests/sim/kiosk/house.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace touchline {
namespace {

constexpr double still_s = 0.7;

/// A dark disc with light and grain everywhere, as no program paints it.
CameraFrame photograph() {
    constexpr int width = 420;
    constexpr int height = 300;
    CameraFrame frame;
    frame.size = {width, height};
    frame.stride_bytes = std::size_t{3} * width;
    std::uint32_t random = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            random = random * 1664525U + 1013904223U;
            const double grain = static_cast<double>(random >> 24U) / 16.0 - 8.0;
            const double light = 30.0 * std::sin(x / 17.0) * std::cos(y / 23.0);
            const double ground = std::hypot(x - 210, y - 150) < 70.0 ? 70.0 : 170.0;
            const double value = ground + light + 15.0 * std::sin((x + 2.0 * y) / 41.0) + grain;
            frame.bytes.insert(frame.bytes.end(), 3, static_cast<std::uint8_t>(value));
        }
    }
    return frame;
}

MainThings dog() {
    constexpr int cells = 40;
    const ThingBox box{0.33, 0.26, 0.67, 0.74};
    MainThings things;
    things.is_sure = true;
    things.boxes = {box};
    things.names = {{ThingName::dog, box, 0.9}};
    things.mask = {cells, cells, std::vector<std::uint8_t>(std::size_t{cells} * cells, 0)};
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            if (std::hypot((x - 19.5) / cells / 0.17, (y - 19.5) / cells / 0.24) < 1.0)
                things.mask.grey[static_cast<std::size_t>(cells * y + x)] = 255;
    return things;
}

/// The lines of a gallery picture, without its words.
Page page_of_document(std::size_t picture, int number, int count) {
    Page page = gallery_without_workers().files[0][picture]->open({}).value();
    page.told.title.clear();
    page.told.description.clear();
    page.told.labels.clear();
    for (Outline& outline : page.told.outlines) outline.label.clear();
    page.number = number;
    page.count = count;
    return page;
}

Result<Page> open_document(const PageOrder& order) {
    constexpr std::array<std::size_t, 3> drawn{5, 12, 34};  // a fish, a boat, a graph
    const int count = static_cast<int>(drawn.size());
    if (order.page < 1 || order.page > count) return failure("plan.pdf has no such page");
    return page_of_document(drawn.at(static_cast<std::size_t>(order.page - 1)), order.page, count);
}

FilePtr file_of_stick(const std::string& name, std::function<Result<Page>(const PageOrder&)> open) {
    return std::make_shared<const PictureFile>(
        PictureFile{name, name, "", true, std::move(open), name});
}

}  // namespace

CameraView StagedCamera::step(double now_s) {
    CameraView view;
    view.condition = CameraCondition::ready;
    if (!is_wanted_) return view;
    if (!due_s_) due_s_ = now_s + still_s;
    if (now_s < *due_s_) return view;
    view.still = Still{photograph(), {}, false, false};
    is_wanted_ = false;
    due_s_.reset();
    return view;
}

ThingFinder staged_finder() {
    return [](const Page& page,
              const std::optional<PlaceInPicture>& place) -> Result<std::optional<Page>> {
        if (place) return std::nullopt;
        Page seen = with_main_things(page, dog());
        seen.was_searched = true;
        return seen;
    };
}

std::vector<FilePtr> staged_files() {
    return {
        file_of_stick("holiday plan.pdf", open_document),
        file_of_stick("letter.pdf", [](const PageOrder&) -> Result<Page> {
            return failure("letter.pdf holds no picture that is known here; choose another one");
        })};
}

}  // namespace touchline
