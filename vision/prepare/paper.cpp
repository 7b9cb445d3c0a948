#include "vision/prepare/paper.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

using Terms = Paper::Terms;
using Weights = std::array<Terms, 3>;

constexpr int places_per_side = 20;  // along each side: where the paper is looked at
constexpr int samples_per_side = 7;  // along each side of a place
constexpr int tries = 120;           // of random surfaces; 1 in 10 hits at 70 % paper
constexpr double same_paper = 9.0;   // grey levels between a place and the surface

/// One place: where it is, and the median colour there.
struct Place {
    Terms terms;
    cv::Vec3f colour;
};

Terms terms_at(double x, double y) {
    return {1.0, x, y, x * x, x * y, y * y};
}

cv::Vec3f colour_at(const Weights& weights, const Terms& terms) {
    return {static_cast<float>(weights[0].dot(terms)), static_cast<float>(weights[1].dot(terms)),
            static_cast<float>(weights[2].dot(terms))};
}

using Samples = std::array<float, samples_per_side * samples_per_side>;

float middle(Samples& values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

Place place_at(const LabPicture& lab, int column, int row) {
    std::array<Samples, 3> values{};
    std::size_t n = 0;
    for (int j = 0; j < samples_per_side; ++j) {
        for (int i = 0; i < samples_per_side; ++i, ++n) {
            const int x =
                (column * samples_per_side + i) * lab.cols / (places_per_side * samples_per_side);
            const int y =
                (row * samples_per_side + j) * lab.rows / (places_per_side * samples_per_side);
            for (int c = 0; c < 3; ++c) values[static_cast<std::size_t>(c)][n] = lab(y, x)[c];
        }
    }
    return {terms_at((2.0 * column + 1.0) / places_per_side - 1.0,
                     (2.0 * row + 1.0) / places_per_side - 1.0),
            {middle(values[0]), middle(values[1]), middle(values[2])}};
}

Weights fitted(const std::vector<const Place*>& places) {
    cv::Matx<double, Paper::term_count, Paper::term_count> normal =
        cv::Matx<double, Paper::term_count, Paper::term_count>::zeros();
    std::array<Terms, 3> right{};
    for (const Place* place : places) {
        normal += place->terms * place->terms.t();
        for (int c = 0; c < 3; ++c) {
            right[static_cast<std::size_t>(c)] +=
                static_cast<double>(place->colour[c]) * place->terms;
        }
    }
    // Adds a little stiffness, so that a few places in one corner do not bend the surface out of
    // all bounds.
    constexpr double stiffness = 1e-3;
    for (int i = 1; i < Paper::term_count; ++i) {
        normal(i, i) += stiffness * static_cast<double>(places.size());
    }
    const auto inverse = normal.inv(cv::DECOMP_CHOLESKY);
    return {inverse * right[0], inverse * right[1], inverse * right[2]};
}

std::vector<const Place*> agreeing(const std::vector<Place>& places, const Weights& weights) {
    std::vector<const Place*> agree;
    for (const Place& place : places) {
        if (cv::norm(place.colour - colour_at(weights, place.terms)) < same_paper) {
            agree.push_back(&place);
        }
    }
    return agree;
}

/// Tries random sets of six places for uneven light, and single places for flat paper, which needs
/// no luck; then takes all that agree with the best.
std::vector<const Place*> most_agreeing(const std::vector<Place>& places) {
    std::uint64_t state = 0x9E3779B97F4A7C15U;
    const auto random_place = [&] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return &places[static_cast<std::size_t>((state >> 33U) % places.size())];
    };
    std::vector<const Place*> best;
    const auto consider = [&](const std::vector<const Place*>& chosen) {
        std::vector<const Place*> agree = agreeing(places, fitted(chosen));
        if (agree.size() > best.size()) best = std::move(agree);
    };
    for (std::size_t i = 0; i < places.size(); i += 5) consider({&places[i]});
    for (int i = 0; i < tries; ++i) {
        std::vector<const Place*> chosen(Paper::term_count);
        std::ranges::generate(chosen, random_place);
        consider(chosen);
    }
    for (int pass = 0; pass < 3; ++pass) best = agreeing(places, fitted(best));
    return best;
}

/// Returns the places that have exactly the colour of one of them.
std::vector<const Place*> alike(const std::vector<Place>& places, const Place& as) {
    constexpr double same_colour = 0.1;  // grey levels
    std::vector<const Place*> found;
    for (const Place& place : places) {
        if (cv::norm(place.colour - as.colour) <= same_colour) found.push_back(&place);
    }
    return found;
}

/// Returns true for a fifth of the places or more, on four fifths of the rows and columns.
bool reach_everywhere(const std::vector<const Place*>& some, const std::vector<Place>& places) {
    std::array<bool, places_per_side> rows{};
    std::array<bool, places_per_side> columns{};
    for (const Place* place : some) {
        const auto at = static_cast<std::size_t>(place - places.data());
        rows[at / places_per_side] = true;
        columns[at % places_per_side] = true;
    }
    return 5 * some.size() >= places.size() &&
           5 * std::ranges::count(rows, true) >= 4 * places_per_side &&
           5 * std::ranges::count(columns, true) >= 4 * places_per_side;
}

/// Returns a colour that extends over the whole picture but that the surface mostly misses. No lamp
/// leaves it so; then the surface follows something painted.
std::optional<cv::Vec3f> passed_by(const Weights& surface, const std::vector<Place>& places) {
    for (const Place& place : places) {
        const std::vector<const Place*> some = alike(places, place);
        const auto on_it = std::ranges::count_if(some, [&](const Place* each) {
            return cv::norm(each->colour - colour_at(surface, each->terms)) < same_paper;
        });
        if (2 * static_cast<std::size_t>(on_it) < some.size() && reach_everywhere(some, places)) {
            return place.colour;
        }
    }
    return std::nullopt;
}

Weights even_surface(const cv::Vec3f& colour) {
    Weights weights{};
    for (int c = 0; c < 3; ++c) {
        weights[static_cast<std::size_t>(c)][0] = static_cast<double>(colour[c]);
    }
    return weights;
}

constexpr double least_ink_contrast = 12.0;
constexpr double contrast_over_noise = 2.0;
constexpr double contrast_over_ink = 0.22;  // fainter than this beside the ink is dirt and shadow
constexpr double darkest_part = 0.002;      // this part of the picture is darker than "the ink"
constexpr int darkest_within_px = 9;        // where a stroke's own darkest point is looked for
constexpr double ink_smoothing_px = 0.7;

cv::Mat1f contrast_to(const LabPicture& lab, const Paper& paper) {
    cv::Mat1f contrast(lab.size());
    std::vector<cv::Vec3f> colours;
    for (int row = 0; row < lab.rows; ++row) {
        paper.fill_row(row, colours);
        for (int column = 0; column < lab.cols; ++column) {
            const cv::Vec3f d = lab(row, column) - colours[static_cast<std::size_t>(column)];
            contrast(row, column) = std::sqrt(d.dot(d));
        }
    }
    return contrast;
}

}  // namespace

Paper::Paper(const LabPicture& lab) : size_(lab.size()) {
    std::vector<Place> places;
    for (int row = 0; row < places_per_side; ++row) {
        for (int column = 0; column < places_per_side; ++column) {
            places.push_back(place_at(lab, column, row));
        }
    }
    weights_ = fitted(most_agreeing(places));
    if (const auto colour = passed_by(weights_, places)) weights_ = even_surface(*colour);
    part_ =
        static_cast<double>(agreeing(places, weights_).size()) / static_cast<double>(places.size());
}

void Paper::fill_row(int row, std::vector<cv::Vec3f>& colours) const {
    colours.resize(static_cast<std::size_t>(size_.width));
    const double y = (2.0 * row + 1.0) / size_.height - 1.0;
    cv::Vec3f constant;
    cv::Vec3f linear;
    cv::Vec3f square;
    for (int c = 0; c < 3; ++c) {
        const Terms& w = weights_[static_cast<std::size_t>(c)];
        constant[c] = static_cast<float>(w[0] + w[2] * y + w[5] * y * y);
        linear[c] = static_cast<float>(w[1] + w[4] * y);
        square[c] = static_cast<float>(w[3]);
    }
    const float step = 2.0F / static_cast<float>(size_.width);
    for (std::size_t column = 0; column < colours.size(); ++column) {
        const float x = (static_cast<float>(column) + 0.5F) * step - 1.0F;
        for (int c = 0; c < 3; ++c) {
            colours[column][c] = constant[c] + x * (linear[c] + x * square[c]);
        }
    }
}

LabPicture evenly_lit(const LabPicture& lab, const Paper& paper) {
    // L and light: L + 16 (stretched) goes with the cube root of the light, as do a and b.
    constexpr float black_level = 16.0F * 2.55F;
    // A share of the light in the middle; anything darker stays black.
    constexpr float least_light_share = 0.25F;
    std::vector<cv::Vec3f> colours;
    paper.fill_row(lab.rows / 2, colours);
    const float middle = colours[colours.size() / 2][0] + black_level;
    if (!(middle > 0.0F)) {  // if few places agree; without light nothing can be divided out
        return lab.clone();
    }
    LabPicture lit(lab.size());
    for (int row = 0; row < lab.rows; ++row) {
        paper.fill_row(row, colours);
        for (int column = 0; column < lab.cols; ++column) {
            const float here = colours[static_cast<std::size_t>(column)][0] + black_level;
            const float gain = middle / std::max(here, least_light_share * middle);
            const cv::Vec3f& from = lab(row, column);
            lit(row, column) = {(from[0] + black_level) * gain - black_level, from[1] * gain,
                                from[2] * gain};
        }
    }
    return lit;
}

cv::Mat3f painted_over(const cv::Mat3f& picture, const cv::Mat1b& mask) {
    cv::Mat1f apart;
    cv::Mat1i nearest;  // the same number for all pixels with the same nearest one outside
    cv::distanceTransform(mask, apart, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<cv::Vec3f> colours(picture.total() + 1);
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (mask(y, x) == 0) colours[static_cast<std::size_t>(nearest(y, x))] = picture(y, x);
        }
    }
    cv::Mat3f painted = picture.clone();
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (mask(y, x) != 0) painted(y, x) = colours[static_cast<std::size_t>(nearest(y, x))];
        }
    }
    return painted;
}

double least_contrast(double noise, double strongest) {
    return std::max(
        {least_ink_contrast, contrast_over_noise * noise, contrast_over_ink * strongest});
}

Ink ink_of(const LabPicture& lab, double noise) {
    LabPicture calm = lab;
    if (noise > 1.0) {  // first: the distance of noise to the paper is never 0
        cv::GaussianBlur(lab, calm, cv::Size(), ink_smoothing_px);
    }
    const Paper paper(lab);
    Ink ink;
    ink.paper_part = paper.part();
    ink.contrast = contrast_to(calm, paper);
    const auto strong = static_cast<double>(quantile(ink.contrast, 1.0 - darkest_part));
    ink.floor = least_contrast(noise, strong);

    cv::Mat1f half;
    cv::dilate(ink.contrast, half, cv::Mat::ones(darkest_within_px, darkest_within_px, CV_8U));
    cv::blur(half, half, {darkest_within_px, darkest_within_px});
    half = cv::max(0.5 * half, ink.floor);
    cv::divide(ink.contrast, half, ink.darkness);
    ink.mask = cv::Mat(ink.darkness >= 1.0F);
    return ink;
}

}  // namespace touchline
