#include "app/documents/trace/page_views.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <fmt/core.h>

namespace touchline {
namespace {

constexpr std::size_t longest_title_bytes = 80;
constexpr int most_shown_px = 2000;  // along a part drawn in lines: no screen shows more
constexpr double like_named = 0.4;   // overlap of a named thing with a main thing's view

const Figure* figure_of(const Page& page, int view) {
    const auto index = static_cast<std::size_t>(view - 1);
    return view >= 1 && index < page.figures.size() ? &page.figures[index] : nullptr;
}

/// Pixels from (left, top) up to, but without, (right, bottom); may reach beyond the page.
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    [[nodiscard]] int width() const { return right - left; }

    [[nodiscard]] int height() const { return bottom - top; }
};

PixelBox part_of(const Page& page, int view) {
    const Figure* const figure = figure_of(page, view);
    if (figure == nullptr) return {0, 0, page.picture.width, page.picture.height};
    if (const DrawnPart* const drawn = figure->drawn.get())
        return {drawn->left_px, drawn->top_px, drawn->right_px, drawn->bottom_px};
    const WordBox& box = figure->box;
    return {box.left, box.top, box.right, box.bottom};
}

/// Takes every `step`-th pixel each way. White where the part reaches beyond the picture.
Picture cut(const Picture& whole, const PixelBox& part, int step = 1) {
    Picture picture;
    picture.width = (part.width() + step - 1) / step;
    picture.height = (part.height() + step - 1) / step;
    picture.scale = whole.scale / step;
    picture.bgr.assign(std::size_t{3} * static_cast<std::size_t>(picture.width) *
                           static_cast<std::size_t>(picture.height),
                       255);
    const auto place = [](int x, int y, int width) { return 3 * (std::ptrdiff_t{y} * width + x); };
    for (int y = 0; y < picture.height; ++y) {
        const int from_y = part.top + step * y;
        if (from_y < 0 || from_y >= whole.height) continue;
        for (int x = 0; x < picture.width; ++x) {
            const int from_x = part.left + step * x;
            if (from_x >= 0 && from_x < whole.width)
                std::copy_n(whole.bgr.begin() + place(from_x, from_y, whole.width), 3,
                            picture.bgr.begin() + place(x, y, picture.width));
        }
    }
    return picture;
}

/// Cuts a mask over a whole picture to the box. The mask's pixels are larger than the picture's, so
/// the cut is rounded to the nearest whole ones.
GreyPicture cut(const GreyPicture& whole, const WordBox& box, const Picture& picture) {
    if (whole.grey.empty()) return {};
    const auto place = [](double at_px, int size_px, int mask_px) {
        return static_cast<int>(std::lround(at_px * mask_px / size_px));
    };
    const int left = std::min(place(box.left, picture.width, whole.width), whole.width - 1);
    const int top = std::min(place(box.top, picture.height, whole.height), whole.height - 1);
    const int right = std::max(left + 1, place(box.right, picture.width, whole.width));
    const int bottom = std::max(top + 1, place(box.bottom, picture.height, whole.height));
    GreyPicture part{right - left, bottom - top, {}};
    for (int y = top; y < bottom; ++y) {
        const auto row = whole.grey.begin() + std::ptrdiff_t{y} * whole.width;
        part.grey.insert(part.grey.end(), row + left, row + right);
    }
    return part;
}

/// The part of the word in the box, relative to its corner.
std::optional<WordBox> within(const WordBox& word, const WordBox& box) {
    const int left = std::max(word.left, box.left);
    const int top = std::max(word.top, box.top);
    const int right = std::min(word.right, box.right);
    const int bottom = std::min(word.bottom, box.bottom);
    if (left >= right || top >= bottom) return std::nullopt;
    const auto moved = [](int value, int by) { return static_cast<std::uint16_t>(value - by); };
    return WordBox{moved(left, box.left), moved(top, box.top), moved(right, box.left),
                   moved(bottom, box.top)};
}

/// The page's labels in the box, except the text of the whole figure.
std::vector<Label> labels_in(const Page& page, const Figure& figure, double m_per_px) {
    const double centre_x_px = (figure.box.left + figure.box.right) / 2.0;
    const double centre_y_px = (figure.box.top + figure.box.bottom) / 2.0;
    const Position centre{(centre_x_px - page.picture.width / 2.0) * m_per_px,
                          (page.picture.height / 2.0 - centre_y_px) * m_per_px};
    const double half_width_m = (figure.box.right - figure.box.left) * m_per_px / 2.0;
    const double half_height_m = (figure.box.bottom - figure.box.top) * m_per_px / 2.0;
    std::vector<Label> labels;
    for (const Label& label : page.told.labels) {
        const Position place{label.place.x - centre.x, label.place.y - centre.y};
        const bool is_inside =
            std::abs(place.x) <= half_width_m && std::abs(place.y) <= half_height_m;
        if (is_inside && label.text != figure.text) labels.push_back({label.text, place});
    }
    return labels;
}

}  // namespace

std::size_t bytes_of(const Page& page) {
    return page.picture.bgr.size() * (page.answer ? 2U : 1U);
}

bool has_main_things(const Page& page) {
    return !page.main_things.grey.empty() ||
           std::ranges::any_of(page.figures,
                               [](const Figure& figure) { return figure.drawn != nullptr; });
}

int view_count(const Page& page) {
    return static_cast<int>(page.figures.size()) + 1;
}

bool is_face(const Page& page, int view) {
    const Figure* const figure = figure_of(page, view);
    return figure != nullptr && figure->drawn != nullptr;
}

std::vector<NamedThing> names_told(const Page& page, int view) {
    const Figure* const figure = figure_of(page, view);
    if (figure == nullptr || view == 1) return page.names;
    if (figure->drawn) return {};
    const double width = page.picture.width;
    const double height = page.picture.height;
    const ThingBox box{figure->box.left / width, figure->box.top / height,
                       figure->box.right / width, figure->box.bottom / height};
    std::vector<NamedThing> names;
    for (const NamedThing& thing : page.names) {
        if (overlap_of(thing.box, box) < like_named) continue;
        names.push_back({thing.name, {0.0, 0.0, 1.0, 1.0}, thing.likelihood});
    }
    return names;
}

int dpi_for(const Page& page, int view) {
    const PixelBox part = part_of(page, view);
    const int longer_px = std::max(part.width(), part.height());
    if (page.dpi <= 0 || longer_px <= 0 || longer_px >= least_view_px) return page.dpi;
    const double wanted = std::ceil(static_cast<double>(page.dpi) * least_view_px / longer_px);
    return static_cast<int>(std::min<double>(wanted, most_view_dpi));
}

std::optional<Page> finer_page(const Page& page, int view, const PageOpener& open) {
    const int dpi = dpi_for(page, view);
    if (dpi <= page.dpi) return std::nullopt;
    auto finer = open({page.number, dpi});
    if (!finer || finer->figures.size() != page.figures.size()) return std::nullopt;
    return std::move(*finer);
}

PlaceInPicture place_in_page(const Page& page, int view, const Position& place) {
    const Picture& picture = page.picture;
    const PixelBox part = part_of(page, view);
    const double m_per_px =
        std::min(Area{}.width_m / part.width(), Area{}.height_m / part.height());
    const double x_px = 0.5 * (part.left + part.right) + place.x / m_per_px;
    const double y_px = 0.5 * (part.top + part.bottom) - place.y / m_per_px;
    return {std::clamp(x_px / picture.width, 0.0, 1.0),
            std::clamp(y_px / picture.height, 0.0, 1.0)};
}

Page view_of(const Page& page, int view) {
    const Figure* const figure = figure_of(page, view);
    if (figure == nullptr) return page;
    const double m_per_px = page.told.area.width_m / page.picture.width;
    Page part;
    const PixelBox box = part_of(page, view);
    const int step = figure->drawn ? 1 + std::max(box.width(), box.height()) / most_shown_px : 1;
    part.picture = cut(page.picture, box, step);
    if (figure->drawn) {
        part.told = figure->drawn->map;
        part.told.title = page.told.title;
        part.told.description = page.told.description;
        part.number = page.number;
        part.count = page.count;
        return part;
    }
    part.main_things = cut(page.main_things, figure->box, page.picture);
    part.told.area = {m_per_px * part.picture.width, m_per_px * part.picture.height};
    part.told.title = figure->text.empty() || figure->text.size() > longest_title_bytes
                          ? page.told.title
                          : figure->text;
    part.told.description = has_main_things(page) ? page.told.description : figure->text;
    part.told.labels = labels_in(page, *figure, m_per_px);
    for (const WordBox& word : page.words)
        if (const auto inside = within(word, figure->box)) part.words.push_back(*inside);
    part.number = page.number;
    part.count = page.count;
    part.dpi = page.dpi;
    return part;
}

Result<TactileMap> shown_at(TactileMap map, int detail) {
    std::erase_if(map.outlines,
                  [detail](const Outline& outline) { return outline.detail > detail; });
    if (map.outlines.empty())
        return failure(
            fmt::format("no outline is shown at detail {}; choose a higher detail", detail));
    return map;
}

}  // namespace touchline
