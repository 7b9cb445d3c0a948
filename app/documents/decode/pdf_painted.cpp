// Decides by the page's picture which letters of its program a visitor could see.
#include "app/documents/decode/pdf_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace touchline::decode {
namespace {

using Colour = std::array<int, 3>;

constexpr double beside = 0.25;  // of a cell's size: how far letters lean out of it
constexpr std::size_t most_samples = 20'000;
constexpr int inked_at_least = 64;       // of 255
constexpr double least_contrast = 10.0;  // levels: the palest print

struct Pixels {
    int left = 0;
    int top = 0;
    int right = 0;  // one past the last pixel
    int bottom = 0;

    [[nodiscard]] int width() const { return std::max(0, right - left); }

    [[nodiscard]] int height() const { return std::max(0, bottom - top); }
};

Pixels pixels_of(const TextBox& box, double grown, int width, int height) {
    const auto pixel = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    return {pixel(std::floor(box.left - grown), width), pixel(std::floor(box.top - grown), height),
            pixel(std::ceil(box.right + grown), width),
            pixel(std::ceil(box.bottom + grown), height)};
}

/// Converts a part of a window to a part of the page.
Pixels on_page(const Pixels& part, const Pixels& window) {
    return {part.left + window.left, part.top + window.top, part.right + window.left,
            part.bottom + window.top};
}

double shorter_side(const TextBox& box) {
    return std::min(box.right - box.left, box.bottom - box.top);
}

const std::uint8_t* pixel_at(const Picture& picture, int x, int y) {
    return picture.bgr.data() +
           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(x));
}

struct Sample {
    double ink = 0.0;  // 0 ... 1
    std::array<double, 3> colour{};
};

/// The mean of a pixel and its neighbours, because two renderers place a letter up to half a pixel
/// apart.
Sample sample_at(const LetterInk& ink, const Picture& picture, int x, int y) {
    Sample mean;
    int count = 0;
    for (int v = std::max(0, y - 1); v <= std::min(picture.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(picture.width - 1, x + 1); ++u) {
            const std::uint8_t* const pixel = pixel_at(picture, u, v);
            for (std::size_t i = 0; i < 3; ++i) mean.colour.at(i) += pixel[i];
            mean.ink += ink.at(u, v);
            ++count;
        }
    for (double& channel : mean.colour) channel /= count;
    mean.ink /= 255.0 * count;
    return mean;
}

std::vector<TextBox> cells_of(const DrawnText& text) {
    std::vector<TextBox> cells;
    for (const DrawnWord& word : text.words) {
        if (text.is_slanted)
            cells.insert(cells.end(), word.letters.begin(), word.letters.end());
        else
            cells.push_back(word.box);
    }
    return cells;
}

std::vector<Sample> samples_of(const DrawnText& text, const LetterInk& ink,
                               const Picture& picture) {
    constexpr double around_px = 3.0;
    std::size_t all = 0;
    std::vector<Pixels> windows;
    for (const TextBox& cell : cells_of(text)) {
        windows.push_back(pixels_of(cell, around_px, picture.width, picture.height));
        all += static_cast<std::size_t>(windows.back().width()) *
               static_cast<std::size_t>(windows.back().height());
    }
    const int step = 1 + static_cast<int>(std::sqrt(static_cast<double>(all / most_samples)));
    std::vector<Sample> samples;
    for (const Pixels& window : windows)
        for (int y = window.top; y < window.bottom; y += step)
            for (int x = window.left; x < window.right; x += step)
                samples.push_back(sample_at(ink, picture, x, y));
    return samples;
}

double middle_of(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The share of samples in a range of ink whose colour fits letters of the colour `letter`.
double share_as_told(const std::vector<Sample>& samples, double least_ink, double most_ink,
                     std::size_t channel, double ground, double letter) {
    const double slack = 6.0 + 0.3 * std::abs(letter - ground);
    std::size_t all = 0;
    std::size_t right = 0;
    for (const Sample& sample : samples) {
        if (sample.ink < least_ink || sample.ink > most_ink) continue;
        ++all;
        const double told = ground + sample.ink * (letter - ground);
        if (std::abs(sample.colour.at(channel) - told) <= slack) ++right;
    }
    return all == 0 ? 0.0 : static_cast<double>(right) / static_cast<double>(all);
}

/// The letters' contrast in one channel; 0 if its pixels do not follow their shapes.
double contrast_in(const std::vector<Sample>& samples, std::size_t channel, double most_ink) {
    constexpr double no_ink = 0.02;
    constexpr double least_share = 0.5;
    std::vector<double> grounds;
    std::vector<double> letters;
    for (const Sample& sample : samples)
        if (sample.ink < no_ink) grounds.push_back(sample.colour.at(channel));
    if (grounds.empty()) return 0.0;
    const double ground = middle_of(grounds);
    for (const Sample& sample : samples)
        if (sample.ink >= 0.5 * most_ink)
            letters.push_back(ground + (sample.colour.at(channel) - ground) / sample.ink);
    const double letter = std::clamp(middle_of(letters), 0.0, 255.0);
    const double contrast = std::abs(letter - ground);
    const bool is_told =
        share_as_told(samples, 0.0, no_ink, channel, ground, letter) >= least_share &&
        share_as_told(samples, 0.4 * most_ink, 1.0, channel, ground, letter) >= least_share;
    return contrast >= least_contrast && is_told ? contrast : 0.0;
}

Colour ground_around(const Picture& picture, const Pixels& box) {
    Colour ground{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::vector<double> edge;
        for (int x = box.left; x < box.right; ++x)
            for (const int y : {box.top, box.bottom - 1})
                edge.push_back(pixel_at(picture, x, y)[channel]);
        for (int y = box.top; y < box.bottom; ++y)
            for (const int x : {box.left, box.right - 1})
                edge.push_back(pixel_at(picture, x, y)[channel]);
        ground.at(channel) = static_cast<int>(middle_of(edge));
    }
    return ground;
}

/// The connected pieces of ink in a window of the picture.
class Pieces {
  public:
    Pieces(const Picture& picture, const Pixels& window) : window_(window) {
        constexpr int least_difference = 48;
        const Colour ground = ground_around(picture, window);
        for (int y = window.top; y < window.bottom; ++y)
            for (int x = window.left; x < window.right; ++x) {
                const std::uint8_t* const pixel = pixel_at(picture, x, y);
                bool is_ink = false;
                for (std::size_t i = 0; i < 3; ++i)
                    is_ink = is_ink || std::abs(pixel[i] - ground.at(i)) > least_difference;
                is_open_.push_back(is_ink);
            }
        for (int y = 0; y < window.height(); ++y)
            for (int x = 0; x < window.width(); ++x)
                if (is_open_[index(x, y)]) take(x, y);
    }

    struct Piece {
        Pixels extent;
        int area = 0;
    };

    [[nodiscard]] const std::vector<Piece>& all() const { return pieces_; }

    [[nodiscard]] bool leads_out(const Piece& piece) const {
        return piece.extent.left == 0 || piece.extent.top == 0 ||
               piece.extent.right == window_.width() || piece.extent.bottom == window_.height();
    }

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(window_.width()) +
               static_cast<std::size_t>(x);
    }

    void take(int from_x, int from_y) {
        Piece piece{{from_x, from_y, from_x + 1, from_y + 1}, 0};
        std::vector<std::pair<int, int>> open{{from_x, from_y}};
        is_open_[index(from_x, from_y)] = false;
        while (!open.empty()) {
            const auto [x, y] = open.back();
            open.pop_back();
            ++piece.area;
            Pixels& extent = piece.extent;
            extent = {std::min(extent.left, x), std::min(extent.top, y),
                      std::max(extent.right, x + 1), std::max(extent.bottom, y + 1)};
            for (int v = std::max(0, y - 1); v <= std::min(window_.height() - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(window_.width() - 1, x + 1); ++u) {
                    if (!is_open_[index(u, v)]) continue;
                    is_open_[index(u, v)] = false;
                    open.emplace_back(u, v);
                }
        }
        pieces_.push_back(piece);
    }

    Pixels window_;
    std::vector<bool> is_open_;  // ink without a piece yet
    std::vector<Piece> pieces_;
};

}  // namespace

double contrast_of(const DrawnText& text, const LetterInk& ink, const Picture& picture) {
    constexpr double least_ink = 0.1;
    const std::vector<Sample> samples = samples_of(text, ink, picture);
    double most_ink = 0.0;
    for (const Sample& sample : samples) most_ink = std::max(most_ink, sample.ink);
    double contrast = 0.0;
    for (std::size_t channel = 0; channel < 3 && most_ink >= least_ink; ++channel)
        contrast = std::max(contrast, contrast_in(samples, channel, most_ink));
    return contrast;
}

bool looks_written(const DrawnText& text, const Picture& picture) {
    constexpr std::size_t least_letters = 3;  // fewer letters look like a drawing
    const double height = text.height_px;
    const Pixels window = pixels_of(text.box, 0.5 * height, picture.width, picture.height);
    if (text.is_slanted || text.letters < least_letters || window.width() < 3 ||
        window.height() < 3)
        return false;
    const Pixels box = pixels_of(text.box, 0.0, picture.width, picture.height);
    const double long_px =
        text.runs_upright ? text.box.bottom - text.box.top : text.box.right - text.box.left;
    const Pieces pieces(picture, window);
    double count = 0.0;
    double covered_px = 0.0;
    double area = 0.0;
    double all_area = 0.0;
    for (const Pieces::Piece& piece : pieces.all()) {
        if (!meet(on_page(piece.extent, window), box)) continue;
        all_area += piece.area;
        const int across = text.runs_upright ? piece.extent.width() : piece.extent.height();
        const int along = text.runs_upright ? piece.extent.height() : piece.extent.width();
        if (pieces.leads_out(piece) || across < 0.2 * height) continue;
        count += 1.0;
        covered_px += along;
        area += piece.area;
    }
    const auto letters = static_cast<double>(text.letters);
    return count >= std::max(2.0, 0.4 * letters) && count <= 1.7 * letters &&
           covered_px >= 0.35 * long_px && area >= 0.6 * all_area;
}

TextBox inked(const TextBox& box, const LetterInk& ink) {
    const Pixels window = pixels_of(box, beside * shorter_side(box), ink.width, ink.height);
    Pixels found{window.right, window.bottom, window.left, window.top};
    for (int y = window.top; y < window.bottom; ++y)
        for (int x = window.left; x < window.right; ++x) {
            if (ink.at(x, y) < inked_at_least) continue;
            found = {std::min(found.left, x), std::min(found.top, y), std::max(found.right, x + 1),
                     std::max(found.bottom, y + 1)};
        }
    if (found.left >= found.right) return box;
    return {static_cast<double>(found.left), static_cast<double>(found.top),
            static_cast<double>(found.right), static_cast<double>(found.bottom)};
}

}  // namespace touchline::decode
