#include "tests/app/drawings/forms.h"
#include "tests/app/drawings/svg_features.h"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

Drawing sheet(std::string_view body, std::vector<Paint> paints) {
    return {"", "", svg_sheet(body), std::move(paints)};
}

std::string points_of(const Polyline& line) {
    std::string out;
    for (const cv::Point2d& p : line.points) out += fmt::format("{:.4f},{:.4f} ", p.x, p.y);
    return out;
}

Drawing fill_rules(Chance& chance) {
    const Polyline left = crossing_star(chance, left_half_mm, 26.0);
    const Polyline right = crossing_star(chance, right_half_mm, 26.0);
    const Ink ink = any_ink(chance);
    Paint hollow = filled(right, ink.bgr);
    hollow.is_even_odd = true;
    return sheet(fmt::format(R"(<polygon points="{}" fill="{}"/><polygon points="{}" fill="{}" )"
                             R"(fill-rule="evenodd"/>)",
                             points_of(left), ink.css, points_of(right), ink.css),
                 {filled(left, ink.bgr), hollow});
}

Drawing holes(Chance& chance) {
    std::string body;
    Drawing out;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Polyline outer = arc(at, {24, 24});
        Polyline inner = arc(at, {12, 12});
        const bool turns_back = chance.coin();
        const Ink ink = any_ink(chance);
        body +=
            fmt::format(R"(<path fill="{}" fill-rule="{}" d="M{} {}a24 24 0 1 1 0 -48a24 24 0 1 1 )"
                        R"(0 48zM{} {}a12 12 0 1 {} 0 -24a12 12 0 1 {} 0 24z"/>)",
                        ink.css, turns_back ? "nonzero" : "evenodd", at.x, at.y + 24, at.x,
                        at.y + 12, turns_back ? 0 : 1, turns_back ? 0 : 1);
        out.paints.push_back({{outer, inner}, 0.0, true, {}, ink.bgr});
    }
    out.file = svg_sheet(body);
    return out;
}

Drawing closed_by_filling(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = open_form(chance, at, 24.0);
        const Ink ink = any_ink(chance);
        body += with(form, fmt::format(R"(fill="{}")", ink.css));
        paints.push_back(filled(form.line, ink.bgr));
    }
    return sheet(body, paints);
}

Drawing outlined(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = any_form(chance, at, 23.0);
        const double width = pen_mm(chance);
        const Ink ink = any_ink(chance);
        body += with(
            form,
            fmt::format(
                R"(fill="none" stroke="{}" stroke-width="{:.3f}" stroke-linejoin="{}")", ink.css,
                width,
                std::array{"miter", "round", "bevel"}[static_cast<std::size_t>(chance.below(3))]));
        paints.push_back(stroked(form.line, width, ink.bgr));
    }
    return sheet(body, paints);
}

Drawing wide_strokes(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = chance.coin() ? form_of_kind(chance.below(4), chance, at, 20.0)
                                        : open_form(chance, at, 20.0);
        const double width = chance.between(4.5, 9.0);
        const Ink ink = any_ink(chance);
        body += with(
            form,
            fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.3f}" stroke-linejoin="round" )"
                        R"(stroke-linecap="round")",
                        ink.css, width));
        paints.push_back(stroked(form.line, width, ink.bgr));
    }
    return sheet(body, paints);
}

Drawing caps(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = open_form(chance, at, 23.0);
        const double width = pen_mm(chance);
        const Ink ink = any_ink(chance);
        body += with(
            form,
            fmt::format(
                R"(fill="none" stroke="{}" stroke-width="{:.3f}" stroke-linecap="{}")", ink.css,
                width,
                std::array{"butt", "round", "square"}[static_cast<std::size_t>(chance.below(3))]));
        paints.push_back(stroked(form.line, width, ink.bgr));
    }
    return sheet(body, paints);
}

Drawing dashes(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = any_form(chance, at, 23.0);
        const double width = chance.between(0.5, 1.2);
        const bool is_dots = chance.coin();
        const double on = is_dots ? 0.0 : chance.between(2.0, 6.0);
        const double off = is_dots ? chance.between(2.2, 3.5) : chance.between(1.5, 3.0);
        const Ink ink = any_ink(chance);
        body +=
            with(form,
                 fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.3f}" stroke-linecap="{}" )"
                             R"(stroke-dasharray="{:.2f} {:.2f}" stroke-dashoffset="{:.2f}")",
                             ink.css, width, is_dots ? "round" : "butt", on, off,
                             chance.between(0.0, 4.0)));
        Paint paint = stroked(form.line, width, ink.bgr);
        paint.dashes_mm = {on, off};
        paints.push_back(paint);
    }
    return sheet(body, paints);
}

Drawing filled_and_outlined(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = any_form(chance, at, 23.0);
        const double width = pen_mm(chance);
        body += with(
            form,
            fmt::format(R"(fill='rgb(240,200,60)' stroke="#102030" stroke-width="{:.3f}")", width));
        paints.push_back(filled(form.line, {60, 200, 240}));
        paints.push_back(stroked(form.line, width, {0x30, 0x20, 0x10}));
    }
    return sheet(body, paints);
}

Drawing see_through(Chance& chance) {
    const Form below = any_form(chance, {46.0, 42.0}, 26.0);
    const Form above = any_form(chance, {74.0, 42.0}, 26.0);
    const double opacity = chance.between(0.4, 0.7);
    const int way = chance.below(3);
    const std::string body =
        with(below, R"(fill="#1040a0")") +
        (way == 0   ? with(above, fmt::format(R"(fill="#c02020" fill-opacity="{:.2f}")", opacity))
         : way == 1 ? with(above, fmt::format(R"(fill='rgba(192,32,32,{:.2f})')", opacity))
                    : fmt::format(R"(<g opacity="{:.2f}">{}</g>)", opacity,
                                  with(above, R"(fill="#c02020")")));
    Paint second = filled(above.line, {0x20, 0x20, 0xc0});
    second.opacity = opacity;
    return sheet(body, {filled(below.line, {0xa0, 0x40, 0x10}), second});
}

Drawing painted_over(Chance& chance) {
    const Form below = any_form(chance, {46.0, 42.0}, 26.0);
    const Form above = any_form(chance, {74.0, 42.0}, 26.0);
    const Ink ink = any_ink(chance);
    const bool is_white = chance.coin();
    return sheet(
        with(below, fmt::format(R"(fill="{}")", ink.css)) +
            with(above, fmt::format(R"(fill="{}")", is_white ? "white" : "#f0b040")),
        {filled(below.line, ink.bgr),
         filled(above.line, is_white ? cv::Scalar(255, 255, 255) : cv::Scalar(0x40, 0xb0, 0xf0))});
}

/// Elements that exist but cannot be seen, each hidden in one of several ways.
Drawing hidden(Chance& chance) {
    const Form form = any_form(chance, left_half_mm, 23.0);
    const Form other = any_form(chance, right_half_mm, 23.0);
    const std::array<std::string, 7> ways{R"(display="none")",
                                          R"(visibility="hidden")",
                                          R"(fill="none" stroke="none")",
                                          R"(fill="white")",
                                          R"(opacity="0")",
                                          R"(fill="none" stroke="black" stroke-width="0")",
                                          R"(style="display:none")"};
    const double width = pen_mm(chance);
    const Ink ink = any_ink(chance);
    return sheet(
        with(form,
             fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.3f}")", ink.css, width)) +
            with(other,
                 ways[static_cast<std::size_t>(chance.below(static_cast<int>(ways.size())))]),
        {stroked(form.line, width, ink.bgr)});
}

Drawing gradients(Chance& chance) {
    const Form left = any_form(chance, left_half_mm, 23.0);
    const Form right = any_form(chance, right_half_mm, 23.0);
    Drawing out = sheet(
        fmt::format(R"(<defs><linearGradient id="a"><stop offset="0" stop-color="#203080"/>)"
                    R"(<stop offset="1" stop-color="#603020"/></linearGradient><radialGradient )"
                    R"(id="b"><stop offset="0" stop-color="#804000"/><stop offset="1" )"
                    R"(stop-color="#006040"/></radialGradient></defs>{}{})",
                    with(left, R"(fill='url(#a)')"), with(right, R"(fill='url(#b)')")),
        {filled(left.line, {0x50, 0x30, 0x40}), filled(right.line, {0x20, 0x50, 0x40})});
    return out;
}

Drawing style_sheet(Chance& chance) {
    const Form left = any_form(chance, left_half_mm, 23.0);
    const Form right = any_form(chance, right_half_mm, 23.0);
    const double width = pen_mm(chance);
    const std::array<std::string, 5> rules{
        fmt::format(".l{{fill:none;stroke:#123456;stroke-width:{:.3f}px}}", width),
        fmt::format("g .l{{stroke:#123456;fill:none!important}} g{{stroke-width:{:.3f}}}", width),
        fmt::format("#one,#two{{fill:none;stroke:rgb(18,52,86);stroke-width:{:.3f}}}", width),
        fmt::format("svg g *{{fill:none;stroke:currentColor;color:#123456;stroke-width:{:.3f}}}",
                    width),
        fmt::format(
            "@media print{{.l{{display:none}}}} .l{{fill:none;stroke:#123456;stroke-width:{:.3f}}}",
            width)};
    return sheet(
        fmt::format(R"(<style type="text/css"><![CDATA[{}]]></style><g>{}{}</g>)",
                    rules[static_cast<std::size_t>(chance.below(5))],
                    with(left, R"(id="one" class="l")"), with(right, R"(id="two" class="l")")),
        {stroked(left.line, width, {0x56, 0x34, 0x12}),
         stroked(right.line, width, {0x56, 0x34, 0x12})});
}

Drawing texts(Chance& chance) {
    const Form form = any_form(chance, right_half_mm, 23.0);
    const double width = pen_mm(chance);
    const double size = chance.between(4.0, 8.0);
    Drawing out = sheet(
        fmt::format(
            R"({}<text x="8" y="42" font-family="DejaVu Sans" font-size="{:.2f}">Harbour</text>)",
            with(form, fmt::format(R"(fill="none" stroke="black" stroke-width="{:.3f}")", width)),
            size),
        {stroked(form.line, width, {0, 0, 0})});
    return out;
}

Drawing patterns(Chance& chance) {
    const Form form = form_of_kind(chance.below(7), chance, left_half_mm, 22.0);
    const Form other = any_form(chance, right_half_mm, 23.0);
    Drawing out =
        sheet(fmt::format(R"(<defs><pattern id="p" width="3" height="3" )"
                          R"(patternUnits="userSpaceOnUse"><path d="M0 0L3 3" stroke="black" )"
                          R"(stroke-width="0.5"/></pattern></defs>{}{})",
                          with(form, R"(fill='url(#p)' stroke="black" stroke-width="1")"),
                          with(other, R"(fill="#204060")")),
              {stroked(form.line, 1.0, {0, 0, 0}), filled(other.line, {0x60, 0x40, 0x20})});
    out.unjudged.push_back({left_half_mm.x - 24, left_half_mm.y - 24, 48, 48});
    return out;
}

constexpr std::array<SvgFeature, 15> paint_features{{{"fill rules", fill_rules},
                                                     {"holes", holes},
                                                     {"closed by filling", closed_by_filling},
                                                     {"outlines", outlined},
                                                     {"wide strokes", wide_strokes},
                                                     {"caps", caps},
                                                     {"dashes and dots", dashes},
                                                     {"filled and outlined", filled_and_outlined},
                                                     {"see-through", see_through},
                                                     {"painted over", painted_over},
                                                     {"hidden", hidden},
                                                     {"gradients", gradients},
                                                     {"style sheets", style_sheet},
                                                     {"texts", texts},
                                                     {"patterns", patterns}}};

}  // namespace

std::span<const SvgFeature> svg_paint_features() {
    return paint_features;
}

}  // namespace touchline::testing
