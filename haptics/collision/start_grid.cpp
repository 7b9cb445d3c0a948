#include "haptics/collision/collision_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr double cells_per_stretch = 128.0;
constexpr double least_cells = 256.0;
constexpr double most_cells = 262144.0;
constexpr double way_m = 5e-4;  // of a fast hand in a tick

}  // namespace

StartGrid::StartGrid(std::vector<Nodes> stretches, std::span<const Shadow> bounds, double reach_m)
    : stretches_(std::move(stretches)) {
    if (stretches_.empty()) return;
    Shadow all = no_shadow;
    for (const Shadow& bound : bounds) all.hold(bound);
    low_ = {all.along_low, all.across_low};
    const double wanted = std::clamp(cells_per_stretch * static_cast<double>(stretches_.size()),
                                     least_cells, most_cells);
    const Position size = Position{all.along_high, all.across_high} - low_;
    cell_m_ = std::max({std::sqrt(size.x * size.y / wanted), std::max(size.x, size.y) / wanted,
                        way_m + 2.0 * reach_m});
    per_cell_m_ = 1.0 / cell_m_;
    // A border of empty cells, so that a way along the outermost lines stays inside.
    low_ = low_ - Position{cell_m_, cell_m_};
    columns_ = 3 + static_cast<int>(size.x * per_cell_m_);
    rows_ = 3 + static_cast<int>(size.y * per_cell_m_);
    const std::vector<Item> items = items_of(bounds);
    first_item_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (const Item& item : items) ++first_item_[item.cell + 1];
    for (std::size_t c = 1; c < first_item_.size(); ++c) first_item_[c] += first_item_[c - 1];
    items_.resize(items.size());
    std::vector<std::int32_t> next(first_item_.begin(), first_item_.end() - 1);
    for (const Item& item : items) {
        items_[static_cast<std::size_t>(next[item.cell]++)] = item.stretch;
    }
}

/// Returns each stretch once for every cell that answers for one of its nodes, in their order.
std::vector<StartGrid::Item> StartGrid::items_of(std::span<const Shadow> bounds) const {
    const double beside_m = grown * cell_m_;
    const auto column = [&](double x) {
        return std::clamp(static_cast<int>((x - low_.x) * per_cell_m_), 0, columns_ - 1);
    };
    const auto row = [&](double y) {
        return std::clamp(static_cast<int>((y - low_.y) * per_cell_m_), 0, rows_ - 1);
    };
    std::vector<Item> items;
    std::vector<std::int32_t> newest(
        static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
    const auto add = [&](std::int32_t stretch, const Shadow& node) {
        const int right = column(node.along_high + beside_m);
        const int top = row(node.across_high + beside_m);
        for (int y = row(node.across_low - beside_m); y <= top; ++y) {
            for (int x = column(node.along_low - beside_m); x <= right; ++x) {
                const auto cell = static_cast<std::size_t>(y * columns_ + x);
                if (newest[cell] != stretch) items.push_back({cell, stretch});
                newest[cell] = stretch;
            }
        }
    };
    std::size_t node = 0;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
        for (int k = 0; k < stretches_[i].stretch.count; ++k) {
            add(static_cast<std::int32_t>(i), bounds[node++]);
        }
    }
    return items;
}

std::size_t StartGrid::memory_bytes() const {
    return stretches_.capacity() * sizeof(Nodes) +
           (first_item_.capacity() + items_.capacity()) * sizeof(std::int32_t);
}

}  // namespace touchline
