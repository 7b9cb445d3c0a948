#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace touchline::workload {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double nominal_radius_m = 0.040;
constexpr int base_octaves = 4;

std::uint64_t splitmix64(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31U);
}

double unit(std::uint64_t key) {
    return static_cast<double>(splitmix64(key) >> 11U) * (1.0 / 9007199254740992.0);
}

double radius_m(double theta, int octaves) {
    double r = 1.0;
    double amplitude = 0.05;
    for (int j = 0; j < octaves; ++j, amplitude *= 0.55) {
        r += amplitude * std::cos(std::ldexp(1.0, j + 1) * theta +
                                  two_pi * unit(1000 + static_cast<std::uint64_t>(j)));
    }
    return nominal_radius_m * r;
}

Position polar(double r, double theta) {
    return {r * std::cos(theta), r * std::sin(theta)};
}

std::vector<Position> sampled(std::size_t n, int octaves) {
    std::vector<Position> points;
    for (std::size_t i = 0; i < n; ++i) {
        const double theta = two_pi * static_cast<double>(i) / static_cast<double>(n);
        points.push_back(polar(radius_m(theta, octaves), theta));
    }
    return points;
}

std::vector<Position> radial(std::size_t n) {
    int octaves = 0;
    while (std::ldexp(1.0, octaves + 1) <= static_cast<double>(n) / 8.0) ++octaves;
    return sampled(n, octaves);
}

std::vector<Position> refined(const std::vector<Position>& coarse, std::uint64_t generation) {
    std::vector<Position> fine;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        const Position a = coarse[i];
        const Position e = coarse[(i + 1) % coarse.size()] - a;
        const double bulge = (splitmix64(generation << 32U | i) & 1U) != 0 ? 0.25 : -0.25;
        fine.push_back(a);
        fine.push_back(a + (1.0 / 3) * e);
        fine.push_back(a + 0.5 * e + bulge * left_of(e));
        fine.push_back(a + (2.0 / 3) * e);
    }
    return fine;
}

std::vector<Position> fractal(std::size_t n) {
    std::size_t start = 16;
    while (start < n) start *= 4;
    std::vector<Position> points = sampled(start == n ? 16 : 32, base_octaves);
    for (std::uint64_t generation = 0; points.size() < n; ++generation) {
        points = refined(points, generation);
    }
    return points;
}

double lift_m(Kind kind, double t) {
    const double press = kind == Kind::radial ? 0.002 : 0.005;
    return -0.0005 + press * std::cos(two_pi * 2.5 * t) + 0.0002 * std::sin(two_pi * 9 * t) +
           0.006 * std::max(0.0, 1 - t / 0.5);
}

}  // namespace

std::vector<Position> curve(Kind kind, std::size_t n) {
    return kind == Kind::radial ? radial(n) : fractal(n);
}

std::vector<Position> hand(Kind kind, std::size_t steps) {
    constexpr double longest_step_m = 0.0003;
    std::vector<Position> out;
    double theta = 0.0;
    for (std::size_t i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) * 1e-3;
        const double h = lift_m(kind, t);
        const double v = 0.15 * (1 - std::cos(two_pi * 0.25 * t));
        const double way = std::sin(two_pi * 0.05 * t + 0.3) >= 0 ? 1 : -1;
        const double advance = way * v * 1e-3 / radius_m(theta, base_octaves);
        const auto at = [&](double share) {
            const double angle = theta + share * advance;
            return polar(radius_m(angle, base_octaves) + h, angle);
        };
        const auto is_short = [&](double share) {
            return i == 0 || norm(at(share) - out.back()) <= longest_step_m;
        };
        double share = 1.0;
        if (!is_short(1.0)) {
            double high = 1.0;
            share = 0.0;
            for (int k = 0; k < 39; ++k) {
                const double middle = 0.5 * (share + high);
                (is_short(middle) ? share : high) = middle;
            }
        }
        out.push_back(at(share));
        theta += share * advance;
    }
    return out;
}

std::uint64_t checksum(const std::vector<Position>& points) {
    std::uint64_t hash = 1469598103934665603ULL;
    for (const Position p : points) {
        for (const double coordinate : {p.x, p.y}) {
            const auto nanometres = static_cast<std::int64_t>(std::llround(coordinate * 1e9));
            for (const unsigned char byte :
                 std::bit_cast<std::array<unsigned char, sizeof nanometres>>(nanometres)) {
                hash = (hash ^ byte) * 1099511628211ULL;
            }
        }
    }
    return hash;
}

TactileMap map_of(std::vector<Position> closed_curve) {
    TactileMap map;
    Outline outline;
    outline.points = std::move(closed_curve);
    outline.is_closed = true;
    map.outlines.push_back(std::move(outline));
    return map;
}

}  // namespace touchline::workload
