#include "app/sheets/paper_faces.h"

#include "app/sheets/stroke_grid.h"

#include <algorithm>
#include <limits>

namespace touchline {
namespace {

constexpr double square_mm = 1.0;
constexpr double mark_step_mm = 0.4;
constexpr std::size_t unknown_face = std::numeric_limits<std::size_t>::max();

}  // namespace

PaperFaces::PaperFaces(const std::vector<SheetStroke>& lines, PaperSize page)
    : columns_(1 + static_cast<std::size_t>(page.width_mm / square_mm)),
      rows_(1 + static_cast<std::size_t>(page.height_mm / square_mm)),
      faces_(columns_ * rows_, unknown_face) {
    // Squares of a line touch at least by their corners, and nothing spreads over corners.
    for (const SheetStroke& stroke : lines)
        for (const PaperPoint& p : sampled(stroke, mark_step_mm)) faces_[square(p)] = line;
    std::size_t next = open;
    const auto is_unknown = [this](std::size_t i) { return faces_[i] == unknown_face; };
    const auto name = [&](std::size_t i) { faces_[i] = next; };
    spread(rim(), is_unknown, name);
    next = line;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        if (!is_unknown(i)) continue;
        ++next;
        spread({i}, is_unknown, name);
    }
}

std::size_t PaperFaces::face_at(PaperPoint place) const {
    return faces_[square(place)];
}

bool PaperFaces::is_around(std::size_t face, PaperPoint place) {
    auto known = outside_.find(face);
    if (known == outside_.end()) {
        std::vector<bool> outside(faces_.size(), false);
        spread(
            rim(), [&](std::size_t i) { return faces_[i] != face && !outside[i]; },
            [&](std::size_t i) { outside[i] = true; });
        known = outside_.emplace(face, std::move(outside)).first;
    }
    return !known->second[square(place)];
}

std::size_t PaperFaces::square(PaperPoint place) const {
    const auto index = [](double place_mm, std::size_t count) {
        return static_cast<std::size_t>(
            std::clamp(place_mm / square_mm, 0.0, static_cast<double>(count - 1)));
    };
    return index(place.y_mm, rows_) * columns_ + index(place.x_mm, columns_);
}

template <class Visit>
void PaperFaces::each_beside(std::size_t square, const Visit& visit) const {
    const std::size_t column = square % columns_;
    if (column > 0) visit(square - 1);
    if (column + 1 < columns_) visit(square + 1);
    if (square >= columns_) visit(square - columns_);
    if (square + columns_ < faces_.size()) visit(square + columns_);
}

template <class IsFree, class Mark>
void PaperFaces::spread(std::vector<std::size_t> from, const IsFree& is_free,
                        const Mark& mark) const {
    std::erase_if(from, [&](std::size_t i) {
        if (!is_free(i)) return true;
        mark(i);
        return false;
    });
    while (!from.empty()) {
        const std::size_t square = from.back();
        from.pop_back();
        each_beside(square, [&](std::size_t i) {
            if (!is_free(i)) return;
            mark(i);
            from.push_back(i);
        });
    }
}

std::vector<std::size_t> PaperFaces::rim() const {
    std::vector<std::size_t> squares;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        const std::size_t column = i % columns_;
        const std::size_t row = i / columns_;
        if (column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_)
            squares.push_back(i);
    }
    return squares;
}

}  // namespace touchline
