#include "config/types/angle.h"
#include "tests/app/drawings/forms.h"
#include "tests/app/drawings/matrix.h"
#include "tests/app/drawings/svg_features.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

constexpr std::string_view namespaces =
    R"(xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink")";

/// A form for each half, drawn with one pen.
struct Pair {
    Form left;
    Form right;
    double width_mm = 1.0;
    Ink ink;

    [[nodiscard]] std::string attributes() const {
        return fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.4f}")", ink.css, width_mm);
    }

    [[nodiscard]] std::string body() const {
        return with(left, attributes()) + with(right, attributes());
    }

    [[nodiscard]] std::vector<Paint> paints() const {
        return {stroked(left.line, width_mm, ink.bgr), stroked(right.line, width_mm, ink.bgr)};
    }
};

Pair any_pair(Chance& chance, double radius_mm = 23.0) {
    return {any_form(chance, left_half_mm, radius_mm), any_form(chance, right_half_mm, radius_mm),
            pen_mm(chance), any_ink(chance)};
}

Drawing in_file(std::string file, std::vector<Paint> paints) {
    return {"", "", std::move(file), std::move(paints)};
}

Drawing transforms(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = any_form(chance, {0.0, 0.0}, 10.0);
        const double k = chance.between(1.5, 2.1);
        const double turn = chance.between(-180.0, 180.0);
        const double skew = chance.between(-15.0, 15.0);
        const Matrix outer{1, 0, 0, 1, at.x, at.y};
        const Matrix inner = turn_about({0, 0}, turn) * Matrix{k, 0, 0, k, 0, 0} *
                             Matrix{1, 0, std::tan(radians(skew)), 1, 0, 0};
        const Ink ink = any_ink(chance);
        body += fmt::format(R"(<g transform='translate({},{})'><g transform='rotate({:.4f}) )"
                            R"(scale({:.4f}),skewX({:.4f})'>{}</g></g>)",
                            at.x, at.y, turn, k, skew,
                            with(form, fmt::format(R"(fill="{}")", ink.css)));
        paints.push_back(filled((outer * inner).of(form.line), ink.bgr));
    }
    return in_file(svg_sheet(body), paints);
}

Drawing matrices(Chance& chance) {
    std::string body;
    std::vector<Paint> paints;
    for (const cv::Point2d& at : {left_half_mm, right_half_mm}) {
        const Form form = any_form(chance, at, 22.0);
        const Matrix m = chance.coin() ? turn_about(at, chance.between(0.0, 360.0))
                                       : Matrix{-1, 0, 0, 1, 2 * at.x, 0};
        const double width = pen_mm(chance);
        const Ink ink = any_ink(chance);
        body += with(
            form,
            fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.4f}" transform='matrix({:.6f} )"
                        R"({:.6f} {:.6f} {:.6f} {:.6f} {:.6f})')",
                        ink.css, width, m.a, m.b, m.c, m.d, m.e, m.f));
        paints.push_back(stroked(m.of(form.line), width, ink.bgr));
    }
    return in_file(svg_sheet(body), paints);
}

Drawing style_transforms(Chance& chance) {
    const Pair pair = any_pair(chance, 20.0);
    const double turn = chance.between(-30.0, 30.0);
    const Matrix m = turn_about({0, 0}, turn);
    const cv::Point2d back = left_half_mm - m.of(left_half_mm);
    Polyline turned = m.of(pair.left.line);
    for (cv::Point2d& p : turned.points) p += back;
    return in_file(svg_sheet(fmt::format(
                       R"(<g style='transform:translate({:.4f}px,{:.4f}px) rotate({:.4f}deg)'>)"
                       R"({}</g>{})",
                       back.x, back.y, turn, with(pair.left, pair.attributes()),
                       with(pair.right, pair.attributes()))),
                   {stroked(turned, pair.width_mm, pair.ink.bgr),
                    stroked(pair.right.line, pair.width_mm, pair.ink.bgr)});
}

Drawing used_again(Chance& chance) {
    const Form form = any_form(chance, left_half_mm, 23.0);
    const double width = pen_mm(chance);
    const Ink ink = any_ink(chance);
    const cv::Point2d over = right_half_mm - left_half_mm;
    Polyline second = form.line;
    for (cv::Point2d& p : second.points) p += over;
    const std::string attributes =
        fmt::format(R"(id="f" fill="none" stroke="{}" stroke-width="{:.4f}")", ink.css, width);
    const bool is_symbol = chance.coin();
    const std::string body =
        is_symbol
            ? fmt::format(R"(<symbol id="s" overflow="visible">{}</symbol><use href="#s"/><use )"
                          R"(xlink:href="#s" x="{}"/>)",
                          with(form, attributes), over.x)
            : fmt::format(
                  R"(<defs>{}</defs><use xlink:href="#f"/><use xlink:href="#f" x="{}" y="{}"/>)",
                  with(form, attributes), over.x, over.y);
    return in_file(svg_sheet(body),
                   {stroked(form.line, width, ink.bgr), stroked(second, width, ink.bgr)});
}

Drawing clips(Chance& chance) {
    const Form form = any_form(chance, {58.0, 42.0}, 34.0);
    const Form clip = form_of_kind(chance.below(5), chance, {58.0, 42.0}, 26.0);
    const Ink ink = any_ink(chance);
    Paint paint = filled(form.line, ink.bgr);
    paint.clips = {{clip.line}};
    return in_file(
        svg_sheet(fmt::format(R"(<clipPath id="c">{}</clipPath><g clip-path='url(#c)'>{}</g>)",
                              with(clip, ""), with(form, fmt::format(R"(fill="{}")", ink.css)))),
        {paint});
}

Drawing masks(Chance& chance) {
    const Form form = any_form(chance, {58.0, 42.0}, 34.0);
    const Form clip = form_of_kind(chance.below(5), chance, {58.0, 42.0}, 26.0);
    const Ink ink = any_ink(chance);
    Paint paint = filled(form.line, ink.bgr);
    paint.clips = {{clip.line}};
    return in_file(
        svg_sheet(fmt::format(R"(<mask id="m" maskUnits="userSpaceOnUse" x="0" y="0" width="116" )"
                              R"(height="84">{}</mask><g mask='url(#m)'>{}</g>)",
                              with(clip, R"(fill="white")"),
                              with(form, fmt::format(R"(fill="{}")", ink.css)))),
        {paint});
}

/// The sheet in another unit of length, with or without a viewBox.
Drawing units(Chance& chance) {
    struct Unit {
        std::string_view name;
        double per_mm;
    };

    constexpr std::array<Unit, 6> all_units{{{"mm", 1.0},
                                             {"cm", 0.1},
                                             {"in", 1 / 25.4},
                                             {"pt", 72 / 25.4},
                                             {"pc", 6 / 25.4},
                                             {"px", 96 / 25.4}}};
    const Unit unit = all_units[static_cast<std::size_t>(chance.below(6))];
    const double width = pen_mm(chance);
    const double r = chance.between(15.0, 25.0);
    const auto length = [&](double mm) {
        return fmt::format("{:.5f}{}", mm * unit.per_mm, unit.name);
    };
    const std::string body =
        fmt::format(R"(<circle cx="{}" cy="{}" r="{}" fill="none" stroke="black" )"
                    R"(stroke-width="{}"/><rect x="{}" y="{}" width="{}" height="{}" )"
                    R"(fill="#204080"/>)",
                    length(30), length(42), length(r), length(width), length(86 - r), length(20),
                    length(2 * r), length(44));
    const Polyline box{{{86 - r, 20}, {86 + r, 20}, {86 + r, 64}, {86 - r, 64}}, true};
    return in_file(
        fmt::format(R"(<svg {} width="{}" height="{}">{}</svg>)", namespaces, length(116),
                    length(84), body),
        {stroked(arc(left_half_mm, {r, r}), width, {0, 0, 0}), filled(box, {0x80, 0x40, 0x20})});
}

Drawing percents(Chance& chance) {
    const double w = chance.between(25.0, 40.0);
    const double h = chance.between(40.0, 80.0);
    const double width = pen_mm(chance);
    const std::string body =
        fmt::format(R"(<rect x="5%" y="{:.4f}%" width="{:.4f}%" height="{:.4f}%" fill="none" )"
                    R"(stroke="black" stroke-width="{:.4f}"/><ellipse cx="75%" cy="50%" )"
                    R"(rx="{:.4f}%" ry="{:.4f}%" fill="#206040"/>)",
                    50 - h / 2, w, h, width, w / 2, h / 2);
    const double x = 0.05 * drawing_sheet_mm.width;
    const double y = (0.5 - h / 200) * drawing_sheet_mm.height;
    const double right = x + w / 100 * drawing_sheet_mm.width;
    const double bottom = y + h / 100 * drawing_sheet_mm.height;
    const Polyline box{{{x, y}, {right, y}, {right, bottom}, {x, bottom}}, true};
    const Polyline oval =
        arc({0.75 * drawing_sheet_mm.width, 42.0},
            {w / 200 * drawing_sheet_mm.width, h / 200 * drawing_sheet_mm.height});
    const std::string_view size = chance.coin() ? R"(width="100%" height="100%")" : "";
    return in_file(
        fmt::format(R"(<svg {} {} viewBox="0 0 116 84">{}</svg>)", namespaces, size, body),
        {stroked(box, width, {0, 0, 0}), filled(oval, {0x40, 0x60, 0x20})});
}

/// A viewBox with another origin and other units.
Drawing view_boxes(Chance& chance) {
    const Pair pair = any_pair(chance);
    const bool in_px = chance.coin();
    const double k = chance.between(0.05, 40.0);
    const cv::Point2d from(chance.between(-500.0, 500.0), chance.between(-500.0, 500.0));
    return in_file(
        fmt::format(R"(<svg {} width="{}" height="{}" viewBox="{:.6f} {:.6f} {:.6f} {:.6f}"><g )"
                    R"(transform='translate({:.6f} {:.6f}) scale({:.6f})'>{}</g></svg>)",
                    namespaces, in_px ? "1160" : "116mm", in_px ? "840" : "84mm", from.x, from.y,
                    k * 116, k * 84, from.x, from.y, k, pair.body()),
        pair.paints());
}

Drawing nested(Chance& chance) {
    const Form form = form_of_kind(chance.below(3) * 2, chance, {50.0, 50.0}, 40.0);
    const bool is_slice = chance.coin();
    const Ink ink = any_ink(chance);
    const cv::Rect2d box(20.0, 12.0, 76.0, 60.0);
    const double k = (is_slice ? box.width : box.height) / 100.0;
    const Matrix m{
        k, 0, 0, k, box.x + 0.5 * (box.width - 100 * k), box.y + 0.5 * (box.height - 100 * k)};
    Paint paint = filled(m.of(form.line), ink.bgr);
    paint.clips = {{{{{box.x, box.y},
                      {box.x + box.width, box.y},
                      {box.x + box.width, box.y + box.height},
                      {box.x, box.y + box.height}},
                     true}}};
    return in_file(
        svg_sheet(fmt::format(R"(<svg x="{}" y="{}" width="{}" height="{}" viewBox="0 0 100 100" )"
                              R"(preserveAspectRatio="xMidYMid {}">{}</svg>)",
                              box.x, box.y, box.width, box.height, is_slice ? "slice" : "meet",
                              with(form, fmt::format(R"(fill="{}")", ink.css)))),
        {paint});
}

Drawing switches(Chance& chance) {
    const Pair pair = any_pair(chance);
    return in_file(
        svg_sheet(fmt::format(
            R"(<switch><g requiredExtensions="http://example.org/none">{}</g><g>{}</g></switch>{})",
            R"(<rect width="116" height="84"/>)", with(pair.left, pair.attributes()),
            with(pair.right, pair.attributes()))),
        pair.paints());
}

Drawing entities(Chance& chance) {
    const Pair pair = any_pair(chance);
    const std::string entity =
        fmt::format("fill:none;stroke:{};stroke-width:{:.4f}", pair.ink.css, pair.width_mm);
    const std::string sheet =
        svg_sheet(with(pair.left, R"(style="&pen;")") + with(pair.right, R"(style="&pen;")"));
    const std::string head = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE svg [<!ENTITY pen \"{}\">]>\n",
        entity);
    return in_file(head + sheet.substr(sheet.find("<svg")), pair.paints());
}

/// Forms on a ground of the sheet's own size, pale or dark, or in white without a ground.
Drawing grounds(Chance& chance) {
    Pair pair = any_pair(chance);
    const int way = chance.below(3);
    if (way == 0)
        return in_file(svg_sheet(R"(<rect width="116" height="84" fill="#e8e4da"/>)" + pair.body()),
                       pair.paints());
    pair.ink = {{255, 255, 255}, "white"};
    Paint ground = filled({{{-9, -9}, {125, -9}, {125, 93}, {-9, 93}}, true}, {0x40, 0x28, 0x10});
    std::vector<Paint> paints{ground};
    for (const Paint& paint : pair.paints()) paints.push_back(paint);
    return in_file(svg_sheet((way == 1 ? R"(<rect width="116" height="84" fill="#102840"/>)" : "") +
                             pair.body()),
                   paints);
}

Drawing markers(Chance& chance) {
    const double y = chance.between(20.0, 60.0);
    const double size = chance.between(7.0, 10.0);
    const std::string body =
        fmt::format(R"(<defs><marker id="a" viewBox="0 0 10 10" refX="0" refY="5" )"
                    R"(markerWidth="{:.3f}" markerHeight="{:.3f}" markerUnits="userSpaceOnUse" )"
                    R"(orient="auto"><path d="M0 0L10 5L0 10z"/></marker></defs><path d="M15 )"
                    R"({:.3f}H80" fill="none" stroke="black" stroke-width="1" )"
                    R"(marker-end='url(#a)'/>)",
                    size, size, y);
    const Polyline head{{{80, y - size / 2}, {80 + size, y}, {80, y + size / 2}}, true};
    return in_file(svg_sheet(body),
                   {stroked({{{15, y}, {80, y}}, false}, 1.0, {0, 0, 0}), filled(head, {0, 0, 0})});
}

Drawing shadows(Chance& chance) {
    const Form left = form_of_kind(chance.below(5), chance, left_half_mm, 22.0);
    const Form right = form_of_kind(chance.below(5), chance, right_half_mm, 22.0);
    const Ink ink = any_ink(chance);
    const std::string body = fmt::format(
        R"(<filter id="s" x="-20%" y="-20%" width="150%" height="150%"><feGaussianBlur )"
        R"(in="SourceAlpha" stdDeviation="{:.2f}"/><feOffset dx="{:.2f}" dy="{:.2f}"/>)"
        R"(<feComponentTransfer><feFuncA type="linear" slope="0.45"/></feComponentTransfer>)"
        R"(<feMerge><feMergeNode/><feMergeNode in="SourceGraphic"/></feMerge></filter>)"
        R"(<g filter='url(#s)'>{}{}</g>)",
        chance.between(0.6, 1.5), chance.between(0.5, 1.5), chance.between(0.5, 1.5),
        with(left, fmt::format(R"(fill="{}")", ink.css)),
        with(right, fmt::format(R"(fill="{}")", ink.css)));
    return in_file(svg_sheet(body), {filled(left.line, ink.bgr), filled(right.line, ink.bgr)});
}

constexpr std::array<SvgFeature, 15> place_features{{{"transforms", transforms},
                                                     {"matrices", matrices},
                                                     {"transforms in style", style_transforms},
                                                     {"used again", used_again},
                                                     {"clips", clips},
                                                     {"masks", masks},
                                                     {"units", units},
                                                     {"percents", percents},
                                                     {"view boxes", view_boxes},
                                                     {"drawings within", nested},
                                                     {"switches", switches},
                                                     {"entities", entities},
                                                     {"grounds", grounds},
                                                     {"markers", markers},
                                                     {"drop shadows", shadows}}};

}  // namespace

std::span<const SvgFeature> svg_place_features() {
    return place_features;
}

}  // namespace touchline::testing
