#include "tests/app/drawings/forms.h"

#include "config/types/angle.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

using Points = std::vector<cv::Point2d>;

cv::Point2d polar(const cv::Point2d& centre, double radius, double deg) {
    const double a = radians(deg);
    return centre + cv::Point2d(radius * std::cos(a), radius * std::sin(a));
}

std::string written(const Points& points) {
    std::string out;
    for (const cv::Point2d& p : points)
        out += fmt::format("{}{:.4f},{:.4f}", out.empty() ? "" : " ", p.x, p.y);
    return out;
}

std::string relative_path(const Points& points) {
    std::string d = fmt::format("m{:.4f} {:.4f}", points.front().x, points.front().y);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const cv::Point2d step = points[i] - points[i - 1];
        d += fmt::format("l{:.4f}{}{:.4f}", step.x, step.y < 0.0 ? "" : ",", step.y);
    }
    return d + "z";
}

void add_cubic(Points& out, const cv::Point2d& a, const cv::Point2d& b, const cv::Point2d& c,
               const cv::Point2d& d) {
    for (int i = 1; i <= 48; ++i) {
        const double t = i / 48.0;
        const double u = 1.0 - t;
        out.push_back(a * (u * u * u) + b * (3 * u * u * t) + c * (3 * u * t * t) +
                      d * (t * t * t));
    }
}

void add_quadratic(Points& out, const cv::Point2d& a, const cv::Point2d& b, const cv::Point2d& c) {
    for (int i = 1; i <= 32; ++i) {
        const double t = i / 32.0;
        const double u = 1.0 - t;
        out.push_back(a * (u * u) + b * (2 * u * t) + c * (t * t));
    }
}

Form circle(Chance&, const cv::Point2d& c, double r) {
    return {arc(c, {r, r}),
            fmt::format(R"(<circle cx="{:.4f}" cy="{:.4f}" r="{:.4f}")", c.x, c.y, r)};
}

Form ellipse(Chance& chance, const cv::Point2d& c, double r) {
    const double ry = r * chance.between(0.5, 0.9);
    return {arc(c, {r, ry}),
            fmt::format(R"(<ellipse cx="{:.4f}" cy="{:.4f}" rx="{:.4f}" ry="{:.4f}")", c.x, c.y, r,
                        ry)};
}

Form rectangle(Chance& chance, const cv::Point2d& c, double r) {
    const double h = r * chance.between(0.5, 0.95);
    return {
        {{{c.x - r, c.y - h}, {c.x + r, c.y - h}, {c.x + r, c.y + h}, {c.x - r, c.y + h}}, true},
        fmt::format(R"(<rect x="{:.4f}" y="{:.4f}" width="{:.4f}" height="{:.4f}")", c.x - r,
                    c.y - h, 2 * r, 2 * h)};
}

Form rounded(Chance& chance, const cv::Point2d& c, double r) {
    const double h = r * chance.between(0.6, 0.95);
    const double k = r * chance.between(0.2, 0.5);
    Polyline line{{}, true};
    const std::array<cv::Point2d, 4> middles{{{c.x + r - k, c.y + h - k},
                                              {c.x - r + k, c.y + h - k},
                                              {c.x - r + k, c.y - h + k},
                                              {c.x + r - k, c.y - h + k}}};
    for (int i = 0; i < 4; ++i)
        for (int step = 0; step <= 16; ++step)
            line.points.push_back(
                polar(middles[static_cast<std::size_t>(i)], k, 90.0 * i + step * 90.0 / 16));
    return {line,
            fmt::format(R"(<rect x="{:.4f}" y="{:.4f}" width="{:.4f}" height="{:.4f}" rx="{:.4f}")",
                        c.x - r, c.y - h, 2 * r, 2 * h, k)};
}

Form polygon(Chance& chance, const cv::Point2d& c, double r) {
    const int n = 3 + chance.below(5);
    const double turn = chance.between(0.0, 360.0);
    Polyline line{{}, true};
    for (int i = 0; i < n; ++i)
        line.points.push_back(polar(c, r, turn + (i + chance.between(-0.15, 0.15)) * 360.0 / n));
    return {line, fmt::format(R"(<polygon points="{}")", written(line.points))};
}

Form star(Chance& chance, const cv::Point2d& c, double r) {
    const int tips = 4 + chance.below(3);
    const double inner = r * chance.between(0.5, 0.7);
    const double turn = chance.between(0.0, 360.0);
    Polyline line{{}, true};
    for (int i = 0; i < 2 * tips; ++i)
        line.points.push_back(polar(c, i % 2 == 0 ? r : inner, turn + i * 180.0 / tips));
    return {line, fmt::format(R"(<path d="{}")", relative_path(line.points))};
}

/// Four smooth quarters; the second handle of all but the first is left out for mirroring (S).
Form smooth(Chance& chance, const cv::Point2d& c, double r) {
    const double turn = chance.between(0.0, 90.0);
    const double pull = 0.5523 * r;
    std::array<cv::Point2d, 4> at;
    std::array<cv::Point2d, 4> along;
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<std::size_t>(i);
        at[k] = polar(c, r * chance.between(0.6, 1.0), turn + 90.0 * i);
        along[k] = polar({0, 0}, pull, turn + 90.0 * i + 90.0);
    }
    Polyline line{{at[0]}, true};
    std::string d = fmt::format("M{:.4f},{:.4f}", at[0].x, at[0].y);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        const cv::Point2d b = at[i] + along[i];
        const cv::Point2d e = at[next] - along[next];
        add_cubic(line.points, at[i], b, e, at[next]);
        d += i == 0 ? fmt::format("C{:.4f},{:.4f} {:.4f},{:.4f} {:.4f},{:.4f}", b.x, b.y, e.x, e.y,
                                  at[next].x, at[next].y)
                    : fmt::format("S{:.4f},{:.4f} {:.4f},{:.4f}", e.x, e.y, at[next].x, at[next].y);
    }
    line.points.pop_back();
    return {line, fmt::format(R"(<path d="{} Z")", d)};
}

/// A cloud's edge: quadratic curves from corner to corner.
Form quadratic(Chance& chance, const cv::Point2d& c, double r) {
    const int n = 4 + chance.below(3);
    const double turn = chance.between(0.0, 360.0);
    const auto corner = [&](int i) { return polar(c, 0.75 * r, turn + i * 360.0 / n); };
    Polyline line{{corner(0)}, true};
    std::string d = fmt::format("M{:.4f} {:.4f}", corner(0).x, corner(0).y);
    for (int i = 0; i < n; ++i) {
        const cv::Point2d handle = polar(c, 1.15 * r, turn + (i + 0.5) * 360.0 / n);
        add_quadratic(line.points, corner(i), handle, corner(i + 1));
        d += fmt::format(" Q{:.4f} {:.4f} {:.4f} {:.4f}", handle.x, handle.y, corner(i + 1).x,
                         corner(i + 1).y);
    }
    line.points.pop_back();
    return {line, fmt::format(R"(<path d="{}z")", d)};
}

Form sector(Chance& chance, const cv::Point2d& c, double r) {
    const double from = chance.between(0.0, 360.0);
    const double sweep = chance.between(60.0, 300.0);
    Polyline line = arc(c, {r, r}, from, from + sweep);
    line.is_closed = true;
    line.points.push_back(c);
    const cv::Point2d a = polar(c, r, from);
    const cv::Point2d b = polar(c, r, from + sweep);
    return {
        line,
        fmt::format(R"(<path d="M{:.4f} {:.4f}L{:.4f} {:.4f}A{:.4f} {:.4f} 0 {} 1 {:.4f} {:.4f}z")",
                    c.x, c.y, a.x, a.y, r, r, sweep > 180.0 ? 1 : 0, b.x, b.y)};
}

Form stairs(Chance& chance, const cv::Point2d& c, double r) {
    const int steps = 2 + chance.below(2);
    const double run = 1.6 * r / steps;
    const double rise = 1.4 * r / steps;
    Points points{{c.x - 0.8 * r, c.y + 0.7 * r}};
    std::string d = fmt::format("M{:.4f} {:.4f}", points.front().x, points.front().y);
    for (int i = 0; i < steps; ++i) {
        points.push_back(points.back() - cv::Point2d(0.0, rise));
        points.push_back(points.back() + cv::Point2d(run, 0.0));
        d += fmt::format("v{:.4f}H{:.4f}", -rise, points.back().x);
    }
    points.emplace_back(points.back().x, c.y + 0.7 * r);
    d += fmt::format("V{:.4f}", c.y + 0.7 * r);
    return {{points, true}, fmt::format(R"(<path d="{}z")", d)};
}

}  // namespace

Form form_of_kind(int kind, Chance& chance, cv::Point2d centre, double radius) {
    constexpr std::array<Form (*)(Chance&, const cv::Point2d&, double), form_kinds> makers{
        circle, ellipse, rectangle, rounded, polygon, star, smooth, quadratic, sector, stairs};
    return makers[static_cast<std::size_t>(kind)](chance, centre, radius);
}

Form any_form(Chance& chance, cv::Point2d centre, double radius) {
    const int kind = chance.below(form_kinds);
    return form_of_kind(kind, chance, centre, radius);
}

std::string with(const Form& form, std::string_view attributes) {
    return fmt::format("{} {}/>", form.element, attributes);
}

Form open_form(Chance& chance, cv::Point2d centre, double radius) {
    const int kind = chance.below(3);
    const cv::Point2d a(centre.x - radius, centre.y + radius * chance.between(-0.5, 0.5));
    const cv::Point2d b(centre.x + radius, centre.y + radius * chance.between(-0.5, 0.5));
    Polyline line{{a}, false};
    if (kind == 0) {
        for (int i = 1; i < 4; ++i)
            line.points.push_back(a + (b - a) * (i / 4.0) +
                                  cv::Point2d(0.0, radius * (i % 2 == 0 ? -0.6 : 0.6)));
        line.points.push_back(b);
        return {line, fmt::format(R"(<polyline points="{}")", written(line.points))};
    }
    const cv::Point2d up(0.0, radius * (kind == 1 ? 1.2 : 0.9));
    const cv::Point2d p = a + (b - a) * 0.33 - up;
    const cv::Point2d q = a + (b - a) * 0.67 + (kind == 1 ? up : -up);
    add_cubic(line.points, a, p, q, b);
    return {line,
            fmt::format(R"(<path d="M{:.4f} {:.4f}C{:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f}")",
                        a.x, a.y, p.x, p.y, q.x, q.y, b.x, b.y)};
}

Polyline crossing_star(Chance& chance, cv::Point2d centre, double radius) {
    Polyline line{{}, true};
    const double turn = chance.between(0.0, 72.0);
    for (int i = 0; i < 5; ++i) line.points.push_back(polar(centre, radius, turn + 144.0 * i));
    return line;
}

}  // namespace touchline::testing
