#include "tests/vision/contour/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr int samples_per_px = 8;

Ring regular(int corners, double radius, double inner_radius) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners - std::numbers::pi / 2.0;
        const double r = i % 2 == 0 ? radius : inner_radius;
        ring.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return ring;
}

/// Letters on a box of -1..1, y down.
std::vector<Ring> letter_a() {
    return {{{-0.85, 1},
             {-0.2, -1},
             {0.2, -1},
             {0.85, 1},
             {0.5, 1},
             {0.33, 0.45},
             {-0.33, 0.45},
             {-0.5, 1}},
            {{0, -0.65}, {0.24, 0.15}, {-0.24, 0.15}}};
}

std::vector<Ring> letter_l() {
    return {{{-0.6, -1}, {-0.25, -1}, {-0.25, 0.68}, {0.6, 0.68}, {0.6, 1}, {-0.6, 1}}};
}

void arc(Ring& ring, cv::Point2d centre, double radius, double from_deg, double to_deg) {
    constexpr int arc_steps = 60;
    for (int i = 0; i <= arc_steps; ++i) {
        const double a =
            (from_deg + (to_deg - from_deg) * i / arc_steps) * std::numbers::pi / 180.0;
        ring.emplace_back(centre.x + radius * std::cos(a), centre.y + radius * std::sin(a));
    }
}

std::vector<Ring> letter_r() {
    Ring outer{{-0.7, 1}, {-0.7, -1}};
    arc(outer, {0.1, -0.4}, 0.6, -90, 60);
    outer.insert(outer.end(), {{0.8, 1}, {0.4, 1}, {-0.05, 0.2}, {-0.35, 0.2}, {-0.35, 1}});
    Ring counter{{-0.35, -0.68}};
    arc(counter, {0.1, -0.4}, 0.28, -90, 90);
    counter.emplace_back(-0.35, -0.12);
    return {outer, counter};
}

Shape placed(std::string name, std::vector<Ring> rings, cv::Point2d centre, double scale,
             double angle_deg) {
    const double c = scale * std::cos(angle_deg * std::numbers::pi / 180.0);
    const double s = scale * std::sin(angle_deg * std::numbers::pi / 180.0);
    for (Ring& ring : rings) {
        for (cv::Point2d& p : ring) {
            p = centre + cv::Point2d(c * p.x - s * p.y, s * p.x + c * p.y);
        }
    }
    return {std::move(name), std::move(rings)};
}

/// Counts the covered samples of each pixel by the crossings of every sample row with the rings.
cv::Mat1d coverage(const Shape& shape, cv::Size size) {
    cv::Mat1d covered(size, 0.0);
    for (int row = 0; row < size.height * samples_per_px; ++row) {
        const double y = (row + 0.5) / samples_per_px;
        std::vector<double> crossings;
        for (const Ring& ring : shape.rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const cv::Point2d a = ring[i];
                const cv::Point2d b = ring[(i + 1) % ring.size()];
                if ((a.y <= y) != (b.y <= y)) {
                    crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
                }
            }
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int from =
                std::max(0, static_cast<int>(std::ceil(crossings[i] * samples_per_px - 0.5)));
            const int to =
                std::min(size.width * samples_per_px,
                         static_cast<int>(std::ceil(crossings[i + 1] * samples_per_px - 0.5)));
            for (int column = from; column < to; ++column) {
                covered(row / samples_per_px, column / samples_per_px) +=
                    1.0 / (samples_per_px * samples_per_px);
            }
        }
    }
    return covered;
}

double distance_to(const cv::Point2d& p, const Ring& line) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const cv::Point2d along = line[i] - line[i - 1];
        const double t = std::clamp((p - line[i - 1]).dot(along) / along.dot(along), 0.0, 1.0);
        best = std::min(best, cv::norm(p - line[i - 1] - t * along));
    }
    return best;
}

double distance_to(const cv::Point2d& p, const std::vector<Ring>& lines) {
    double best = std::numeric_limits<double>::infinity();
    for (const Ring& line : lines) {
        best = std::min(best, distance_to(p, line));
    }
    return best;
}

struct Corner {
    cv::Point2d at;
    double inner_deg = 180.0;
};

std::vector<Corner> corners_of(const Shape& shape) {
    std::vector<Corner> corners;
    for (const Ring& ring : shape.rings) {
        const std::size_t n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            const cv::Point2d in = ring[i] - ring[(i + n - 1) % n];
            const cv::Point2d out = ring[(i + 1) % n] - ring[i];
            const double turn_deg =
                std::abs(std::atan2(in.cross(out), in.dot(out))) * 180.0 / std::numbers::pi;
            if (turn_deg > 20.0) {
                corners.push_back({ring[i], 180.0 - turn_deg});
            }
        }
    }
    return corners;
}

void compare(const std::vector<Ring>& from, const std::vector<Ring>& to,
             const std::vector<Corner>& corners, Distances& worst) {
    for (const Ring& line : from) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const int steps = std::max(1, static_cast<int>(2.0 * cv::norm(line[i] - line[i - 1])));
            for (int k = 0; k < steps; ++k) {
                const cv::Point2d p =
                    line[i - 1] + (static_cast<double>(k) / steps) * (line[i] - line[i - 1]);
                double* where = &worst.smooth_px;
                for (const Corner& corner : corners) {
                    if (cv::norm(p - corner.at) <= 3.0) {
                        where = corner.inner_deg >= 89.9 ? &worst.corner_px : &worst.tip_px;
                    }
                }
                *where = std::max(*where, distance_to(p, to));
            }
        }
    }
}

}  // namespace

std::vector<Shape> test_shapes(cv::Point2d centre, double size_px, double angle_deg) {
    const double half = size_px / 2.0;
    const double star_inner =
        std::cos(2.0 * std::numbers::pi / 5.0) / std::cos(std::numbers::pi / 5.0);
    return {placed("disc", {regular(720, 1.0, 1.0)}, centre, half, angle_deg),
            placed("square", {regular(4, 1.0, 1.0)}, centre, half, angle_deg),
            placed("star", {regular(10, 1.0, star_inner)}, centre, half, angle_deg),
            placed("A", letter_a(), centre, half, angle_deg),
            placed("L", letter_l(), centre, half, angle_deg),
            placed("R", letter_r(), centre, half, angle_deg)};
}

cv::Mat drawn(const Shape& shape, cv::Size size, const Look& look) {
    const cv::Mat1d covered = coverage(shape, size);
    cv::Mat3d picture(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                picture(y, x)[c] = look.paper[c] + covered(y, x) * (look.ink[c] - look.paper[c]);
            }
        }
    }
    if (look.blur_px > 0.0) {
        cv::GaussianBlur(picture, picture, cv::Size(), look.blur_px, look.blur_px);
    }
    if (look.noise_levels > 0.0) {
        cv::RNG random(static_cast<std::uint64_t>(look.seed));
        for (cv::Vec3d& pixel : picture) {
            pixel += cv::Vec3d::all(random.gaussian(look.noise_levels));
        }
    }
    cv::Mat bytes;
    picture.convertTo(bytes, CV_8U);
    return bytes;
}

std::vector<Ring> lines_in_pixels(const PhotoLines& found, cv::Size picture) {
    std::vector<Ring> lines;
    for (const Chain& chain : found.chains) {
        Ring line;
        for (const EdgePoint& p : chain.points) {
            line.emplace_back((p.at.x + 0.5) * picture.width / found.size.width,
                              (p.at.y + 0.5) * picture.height / found.size.height);
        }
        if (chain.is_closed) {
            line.push_back(line.front());
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

Distances distances(const Shape& truth, const std::vector<Ring>& lines) {
    std::vector<Ring> rings = truth.rings;
    for (Ring& ring : rings) {
        ring.push_back(ring.front());
    }
    const std::vector<Corner> corners = corners_of(truth);
    Distances worst;
    compare(rings, lines, corners, worst);
    compare(lines, rings, corners, worst);
    return worst;
}

}  // namespace touchline::testing
