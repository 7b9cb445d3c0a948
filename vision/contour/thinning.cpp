#include "vision/contour/thinning.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <vector>

namespace touchline {
namespace {

constexpr float kSteps = 8.0F;  // of depth, per pixel

/// Whether a pixel may go, by its eight neighbours (bit k: neighbour k, round the pixel, even bits
/// beside it): it is not an end, and its neighbours stay connected without it (Yokoi's number is
/// 1).
constexpr std::array<bool, 256> removable_table() {
    std::array<bool, 256> table{};
    for (unsigned code = 0; code < 256; ++code) {
        const auto empty = [&](unsigned k) { return (code >> (k % 8U) & 1U) == 0U ? 1 : 0; };
        int parts = 0;
        for (unsigned k = 0; k < 8; k += 2) {
            parts += empty(k) - empty(k) * empty(k + 1) * empty(k + 2);
        }
        table[code] = parts == 1 && std::popcount(code) >= 2;
    }
    return table;
}

constexpr std::array<bool, 256> kRemovable = removable_table();

class Thinning {
  public:
    Thinning(const cv::Mat1b& mask, const cv::Mat1f& depth)
        : width_(mask.cols + 2),
          around_{1, 1 - width_, -width_, -1 - width_, -1, width_ - 1, width_, width_ + 1},
          inside_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(mask.rows + 2), 0),
          level_(inside_.size(), 0) {
        for (int y = 0; y < mask.rows; ++y) {
            for (int x = 0; x < mask.cols; ++x) {
                if (mask(y, x) != 0) {
                    add(static_cast<std::size_t>((y + 1) * width_ + x + 1), depth(y, x));
                }
            }
        }
    }

    /// Goes level by level, from the four sides in turn: going from one side only would remove a
    /// line that is two pixels wide from its end.
    void peel() {
        for (std::size_t level = 0; level < queues_.size(); ++level) {
            std::vector<std::size_t> asked = std::move(queues_[level]);
            while (!asked.empty()) {
                std::vector<std::size_t> again;
                for (const std::size_t side : {2U, 6U, 0U, 4U}) {
                    peel_side(asked, side, static_cast<int>(level), again);
                }
                asked = std::move(again);
            }
        }
    }

    [[nodiscard]] cv::Mat1b rest(cv::Size size) const {
        cv::Mat1b kept(size);
        for (int y = 0; y < size.height; ++y) {
            const auto row = inside_.begin() + (y + 1) * width_ + 1;
            std::copy(row, row + size.width, kept[y]);
        }
        return kept;
    }

  private:
    void add(std::size_t p, float depth) {
        const auto level = static_cast<std::size_t>(depth * kSteps);
        if (queues_.size() <= level) {
            queues_.resize(level + 1);
        }
        inside_[p] = 255;
        level_[p] = static_cast<int>(level);
        queues_[level].push_back(p);
    }

    [[nodiscard]] std::size_t neighbour(std::size_t p, std::size_t k) const {
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + around_[k]);
    }

    [[nodiscard]] unsigned code_of(std::size_t p) const {
        unsigned code = 0;
        for (std::size_t k = 0; k < 8; ++k) {
            code |= (inside_[neighbour(p, k)] & 1U) << k;
        }
        return code;
    }

    /// Removes what now lies open to that side, if it may go; its neighbours are checked again.
    void peel_side(const std::vector<std::size_t>& asked, std::size_t side, int level,
                   std::vector<std::size_t>& again) {
        std::vector<std::size_t> open;
        std::ranges::copy_if(asked, std::back_inserter(open), [&](std::size_t p) {
            return inside_[p] != 0 && inside_[neighbour(p, side)] == 0;
        });
        for (const std::size_t p : open) {
            if (inside_[p] == 0 || !kRemovable[code_of(p)]) {
                continue;
            }
            inside_[p] = 0;
            for (std::size_t k = 0; k < 8; ++k) {
                const std::size_t q = neighbour(p, k);
                if (inside_[q] != 0 && level_[q] <= level) {
                    again.push_back(q);
                }
            }
        }
    }

    int width_;  // of a row with its frame
    std::array<int, 8> around_;
    std::vector<unsigned char> inside_;
    std::vector<int> level_;
    std::vector<std::vector<std::size_t>> queues_;  // by depth
};

}  // namespace

cv::Mat1b thinned(const cv::Mat1b& mask, const cv::Mat1f& depth) {
    Thinning thinning(mask, depth);
    thinning.peel();
    return thinning.rest(mask.size());
}

}  // namespace touchline
