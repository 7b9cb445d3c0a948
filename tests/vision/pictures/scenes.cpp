#include "tests/vision/pictures/scenes.h"

#include "tests/vision/pictures/canvas.h"

#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

class Dice {
  public:
    explicit Dice(int seed) : random_(static_cast<std::uint64_t>(seed) * 7919U + 12345U) {
        random_.next();
    }

    int upto(int n) { return random_.uniform(0, n); }

    double between(double low, double high) { return random_.uniform(low, high); }

    cv::Scalar colour(double low = 0.0, double high = 255.0) {
        const double blue = between(low, high);
        const double green = between(low, high);
        return {blue, green, between(low, high)};
    }

    cv::RNG& rng() { return random_; }

  private:
    cv::RNG random_;
};

/// Noise with the spectrum of nature (amplitude falls as 1/f), mean 0, standard deviation 1.
cv::Mat1f cloud(cv::Size size, Dice& dice, int finest) {
    cv::Mat1f sum(size, 0.0F);
    for (int cells = 2; cells <= std::max(size.width, size.height) / finest; cells *= 2) {
        cv::Mat1f octave(cells + 1, cells + 1);
        dice.rng().fill(octave, cv::RNG::NORMAL, 0.0, 1.0);
        cv::Mat1f large;
        cv::resize(octave, large, size, 0.0, 0.0, cv::INTER_CUBIC);
        sum += large / std::sqrt(static_cast<float>(cells));
    }
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(sum, mean, deviation);
    return cv::Mat((sum - mean[0]) / deviation[0]);
}

/// A surface: colour, a slow change of light across it, texture.
cv::Mat3f surface(cv::Size size, Dice& dice, double texture_levels) {
    const cv::Scalar colour = dice.colour(40.0, 215.0);
    const cv::Mat1f texture = cloud(size, dice, 1 + dice.upto(4));
    const cv::Mat1f tint = cloud(size, dice, 8);
    const double slope_x = dice.between(-60.0, 60.0) / size.width;
    const double slope_y = dice.between(-60.0, 60.0) / size.height;
    cv::Mat3f made(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double light =
                slope_x * x + slope_y * y + texture_levels * static_cast<double>(texture(y, x));
            for (int c = 0; c < 3; ++c) {
                made(y, x)[c] = static_cast<float>(colour[c] + light +
                                                   (c - 1) * 0.3 * texture_levels *
                                                       static_cast<double>(tint(y, x)));
            }
        }
    }
    return made;
}

Polyline blob(Dice& dice, cv::Point2d centre, double radius_px) {
    std::array<double, 5> amplitude{};
    std::array<double, 5> phase{};
    for (std::size_t k = 0; k < amplitude.size(); ++k) {
        amplitude[k] = dice.between(0.0, 0.22) / static_cast<double>(k + 1) * 1.6;
        phase[k] = dice.between(0.0, 2.0 * std::numbers::pi);
    }
    Polyline ring{{}, true};
    for (int i = 0; i < 180; ++i) {
        const double a = 2.0 * std::numbers::pi * i / 180.0;
        double r = 1.0;
        for (std::size_t k = 0; k < amplitude.size(); ++k) {
            r += amplitude[k] * std::cos(static_cast<double>(k + 1) * a + phase[k]);
        }
        ring.points.emplace_back(centre.x + radius_px * r * std::cos(a),
                                 centre.y + radius_px * r * std::sin(a));
    }
    return ring;
}

cv::Mat1f coverage(const std::vector<Polyline>& rings, cv::Size size) {
    Canvas canvas(size, {0, 0, 0});
    canvas.fill(rings, {255, 255, 255});
    cv::Mat1b grey;
    cv::cvtColor(canvas.picture(), grey, cv::COLOR_BGR2GRAY);
    cv::Mat1f part;
    grey.convertTo(part, CV_32F, 1.0 / 255.0);
    return part;
}

void lay(cv::Mat3f& picture, const cv::Mat3f& over, const cv::Mat1f& part) {
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            picture(y, x) += part(y, x) * (over(y, x) - picture(y, x));
        }
    }
}

cv::Mat developed(const cv::Mat3f& light) {
    cv::Mat soft;
    cv::GaussianBlur(light, soft, cv::Size(), 0.7);
    cv::Mat bytes;
    soft.convertTo(bytes, CV_8U);
    return bytes;
}

cv::Mat3f background(cv::Size size, Dice& dice) {
    const int kind = dice.upto(3);
    cv::Mat3f made =
        surface(size, dice, kind == 0 ? dice.between(2.0, 5.0) : dice.between(8.0, 22.0));
    if (kind == 2) {  // a horizon
        const double y = dice.between(0.3, 0.7) * size.height;
        const Polyline ground{{{-1.0, y + dice.between(-20.0, 20.0)},
                               {size.width + 1.0, y},
                               {size.width + 1.0, size.height + 1.0},
                               {-1.0, size.height + 1.0}},
                              true};
        lay(made, surface(size, dice, dice.between(8.0, 25.0)), coverage({ground}, size));
    }
    return made;
}

std::string word(Dice& dice) {
    static constexpr const char* letters = "etaoinshrdlucmfwypvbgkETAOINSHR";
    std::string made;
    for (int n = 2 + dice.upto(8); n > 0; --n) {
        made += letters[dice.upto(n == 1 ? 22 : 24)];
    }
    return made;
}

}  // namespace

PhotoScene photo_scene(int seed, cv::Size size) {
    Dice dice(seed);
    cv::Mat3f light = background(size, dice);
    PhotoScene scene;
    const double unit = std::min(size.width, size.height);
    for (int objects = dice.upto(3); objects > 0; --objects) {
        const cv::Point2d at(dice.between(0.0, 1.0) * size.width,
                             dice.between(0.0, 1.0) * size.height);
        lay(light, surface(size, dice, dice.between(6.0, 25.0)),
            coverage({blob(dice, at, unit * dice.between(0.05, 0.12))}, size));
    }
    const cv::Point2d middle(size.width * dice.between(0.4, 0.6),
                             size.height * dice.between(0.4, 0.6));
    const cv::Mat1f part = coverage({blob(dice, middle, unit * dice.between(0.2, 0.3))}, size);
    lay(light, surface(size, dice, dice.between(6.0, 25.0)), part);
    scene.truth = cv::Mat(part > 0.5F);
    scene.picture = developed(light);
    return scene;
}

PhotoScene photo_of(const cv::Mat1b& silhouette, int seed, cv::Size size) {
    Dice dice(seed);
    const double fit = 0.6 * std::min(static_cast<double>(size.width) / silhouette.cols,
                                      static_cast<double>(size.height) / silhouette.rows);
    const cv::Matx23d to_middle(fit, 0.0, 0.5 * (size.width - fit * silhouette.cols), 0.0, fit,
                                0.5 * (size.height - fit * silhouette.rows));
    cv::Mat1b mask;
    cv::warpAffine(silhouette, mask, to_middle, size, cv::INTER_AREA);
    cv::Mat1f part;
    mask.convertTo(part, CV_32F, 1.0 / 255.0);
    cv::Mat3f light = background(size, dice);
    lay(light, surface(size, dice, dice.between(6.0, 20.0)), part);
    return {developed(light), cv::Mat(mask > 127)};
}

cv::Mat diagram(int seed, cv::Size size) {
    Dice dice(seed);
    const double w = size.width;
    const double h = size.height;
    const double unit = std::min(w, h);
    const cv::Scalar paper =
        dice.upto(3) == 0 ? dice.colour(180.0, 255.0) : cv::Scalar(255, 255, 255);
    Canvas canvas(size, paper);
    const int kind = dice.upto(5);
    const cv::Point2d middle(0.5 * w, 0.5 * h);
    if (kind == 0) {  // pie
        double from = dice.between(0.0, 360.0);
        const double end = from + 360.0;
        while (from < end) {
            const double to = std::min(end, from + dice.between(30.0, 130.0));
            Polyline slice = arc(middle, {0.38 * unit, 0.38 * unit}, from, to);
            slice.points.push_back(middle);
            slice.is_closed = true;
            canvas.fill({slice}, dice.colour());
            from = to;
        }
    } else if (kind == 1) {  // bars
        const int bars = 3 + dice.upto(4);
        for (int i = 0; i < bars; ++i) {
            const double x = w * (0.1 + 0.8 * i / bars);
            const double y = h * dice.between(0.15, 0.7);
            canvas.fill(
                {{{{x, y}, {x + 0.6 * w / bars, y}, {x + 0.6 * w / bars, 0.9 * h}, {x, 0.9 * h}},
                  true}},
                dice.colour(0.0, 220.0));
        }
        canvas.stroke({{{{0.07 * w, 0.1 * h}, {0.07 * w, 0.9 * h}, {0.95 * w, 0.9 * h}}, false}},
                      {3.0, Join::mitre, Cap::butt}, {0, 0, 0});
    } else if (kind == 2) {  // flag
        const int stripes = 2 + dice.upto(3);
        const bool is_upright = dice.upto(2) == 0;
        for (int i = 0; i < stripes; ++i) {
            const double a = 0.1 + 0.8 * i / stripes;
            const double b = 0.1 + 0.8 * (i + 1) / stripes;
            const Polyline stripe =
                is_upright
                    ? Polyline{{{a * w, 0.2 * h},
                                {b * w, 0.2 * h},
                                {b * w, 0.8 * h},
                                {a * w, 0.8 * h}},
                               true}
                    : Polyline{
                          {{0.1 * w, a * h}, {0.9 * w, a * h}, {0.9 * w, b * h}, {0.1 * w, b * h}},
                          true};
            canvas.fill({stripe}, dice.colour());
        }
        canvas.fill({arc(middle, {0.12 * unit, 0.12 * unit})}, dice.colour());
    } else if (kind == 3) {  // a logo: blob with a hole, letter inside
        canvas.fill({blob(dice, middle, 0.36 * unit), arc(middle, {0.2 * unit, 0.2 * unit})},
                    dice.colour(0.0, 160.0));
        const Font font{"DejaVu Sans", 0.25 * unit, true, false};
        canvas.write(std::string(1, static_cast<char>('A' + dice.upto(26))),
                     middle + cv::Point2d(-0.09, 0.09) * unit, font, dice.colour(0.0, 160.0));
    } else {  // shapes over each other
        for (int n = 3 + dice.upto(5); n > 0; --n) {
            const cv::Point2d at(dice.between(0.2, 0.8) * w, dice.between(0.2, 0.8) * h);
            canvas.fill({blob(dice, at, dice.between(0.1, 0.25) * unit)}, dice.colour());
        }
    }
    if (dice.upto(2) == 0) {
        canvas.write(word(dice) + " " + word(dice), {0.3 * w, 0.08 * h},
                     {"DejaVu Sans", 0.05 * unit, false, false}, {40, 40, 40});
    }
    return canvas.picture();
}

cv::Mat line_drawing(int seed, cv::Size size) {
    Dice dice(seed);
    const double w = size.width;
    const double h = size.height;
    const double unit = std::min(w, h);
    const bool is_blackboard = dice.upto(6) == 0;
    const cv::Scalar paper = is_blackboard ? dice.colour(10.0, 50.0) : dice.colour(225.0, 255.0);
    const cv::Scalar ink = is_blackboard ? dice.colour(200.0, 255.0) : dice.colour(0.0, 100.0);
    const double width_px = unit * dice.between(0.005, 0.015);
    Canvas canvas(size, paper);
    const int kind = dice.upto(4);
    if (kind == 0) {  // a doodle
        for (int n = 2 + dice.upto(4); n > 0; --n) {
            const cv::Point2d at(dice.between(0.25, 0.75) * w, dice.between(0.25, 0.75) * h);
            canvas.stroke({blob(dice, at, unit * dice.between(0.08, 0.22))}, width_px, ink);
        }
    } else if (kind == 1) {  // handwriting: loops along lines
        const double step = unit * dice.between(0.03, 0.05);
        for (double y = 0.2 * h; y < 0.85 * h; y += 4.0 * step) {
            Polyline line;
            double phase = 0.0;
            double tall = 1.0;
            for (double x = 0.1 * w; x < 0.9 * w; x += 0.15 * step) {
                phase += 0.45;
                if (phase > 2.0 * std::numbers::pi) {
                    phase -= 2.0 * std::numbers::pi;
                    tall = dice.between(0.4, 1.6);
                }
                line.points.emplace_back(x + 0.5 * step * std::cos(phase),
                                         y - tall * step * std::sin(phase));
            }
            canvas.stroke({line}, width_px * 0.7, ink);
        }
    } else if (kind == 2) {  // borders
        for (int n = 4 + dice.upto(3); n > 0; --n) {
            Polyline line;
            double y = dice.between(0.1, 0.9) * h;
            const bool is_upright = n % 2 == 0;
            for (double x = 0.0; x < 1.0; x += 0.01) {
                y += unit * dice.between(-0.02, 0.02);
                line.points.push_back(is_upright ? cv::Point2d(y * w / h, x * h)
                                                 : cv::Point2d(x * w, y));
            }
            canvas.stroke({line}, width_px * 0.6, ink);
        }
    } else {  // a technical drawing
        const double x0 = dice.between(0.1, 0.25) * w;
        const double y0 = dice.between(0.15, 0.3) * h;
        const double x1 = dice.between(0.7, 0.9) * w;
        const double y1 = dice.between(0.7, 0.85) * h;
        canvas.stroke({{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, true}},
                      {width_px, Join::mitre, Cap::butt}, ink);
        canvas.stroke({arc({0.5 * (x0 + x1), 0.5 * (y0 + y1)}, {0.15 * unit, 0.15 * unit})},
                      width_px, ink);
        canvas.stroke({{{{x0, 0.5 * (y0 + y1)}, {x1, 0.5 * (y0 + y1)}}, false},
                       {{{0.5 * (x0 + x1), y0}, {0.5 * (x0 + x1), y1}}, false}},
                      {0.5 * width_px, Join::mitre, Cap::butt}, ink);
        canvas.write(word(dice), {x0, 0.95 * h}, {"DejaVu Sans", 0.05 * unit, false, false}, ink);
    }
    return canvas.picture();
}

cv::Mat text_page(int seed, cv::Size size) {
    Dice dice(seed);
    const double w = size.width;
    const double h = size.height;
    const cv::Scalar paper = dice.colour(225.0, 255.0);
    const cv::Scalar ink = dice.colour(0.0, 70.0);
    Canvas canvas(size, paper);
    Font font{dice.upto(2) == 0 ? "DejaVu Sans" : "DejaVu Serif",
              std::max(9.0, h * dice.between(0.018, 0.035)), false, false};
    const int columns = 1 + dice.upto(2);
    const bool has_figure = dice.upto(4) == 0;
    double top = 0.08 * h;
    if (dice.upto(2) == 0) {
        Font heading = font;
        heading.size_px *= 1.8;
        heading.is_bold = true;
        canvas.write(word(dice) + " " + word(dice), {0.08 * w, top}, heading, ink);
        top += 3.0 * font.size_px;
    }
    if (has_figure) {
        canvas.fill({blob(dice, {0.5 * w, 0.8 * h}, 0.1 * std::min(w, h))}, dice.colour(0, 180));
    }
    for (int column = 0; column < columns; ++column) {
        const double left = w * (0.08 + 0.44 * column);
        const double right = columns == 1 ? 0.92 * w : left + 0.4 * w;
        for (double y = top; y < (has_figure ? 0.65 : 0.93) * h; y += 1.5 * font.size_px) {
            double x = left;
            const double end = dice.upto(6) == 0 ? left + 0.5 * (right - left) : right;
            for (std::string next = word(dice); x + canvas.width_of(next, font) < end;
                 next = word(dice)) {
                canvas.write(next, {x, y}, font, ink);
                x += canvas.width_of(next + " ", font);
            }
        }
    }
    return canvas.picture();
}

}  // namespace touchline::testing
