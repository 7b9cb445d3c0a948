#include "tests/app/drawings/pdf_figures.h"

#include "tests/app/documents/decode/pdf_writer.h"
#include "tests/app/drawings/forms.h"
#include "tests/app/drawings/svg_features.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

constexpr double figure_mm = 15.0;  // radius

using Place = cv::Point2d;

Polyline moved(Polyline line, const Place& by) {
    for (cv::Point2d& p : line.points) p += by;
    return line;
}

Polyline box_about(const Place& at, double half_width, double half_height) {
    return {{{at.x - half_width, at.y - half_height},
             {at.x + half_width, at.y - half_height},
             {at.x + half_width, at.y + half_height},
             {at.x - half_width, at.y + half_height}},
            true};
}

void outline_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    sheet.paint(stroked(any_form(chance, at, figure_mm).line, pen_mm(chance), any_ink(chance).bgr));
}

void open_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    sheet.paint(
        stroked(open_form(chance, at, figure_mm).line, pen_mm(chance), any_ink(chance).bgr));
}

void hair_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    sheet.paint(stroked(any_form(chance, at, figure_mm).line, chance.between(0.06, 0.2),
                        any_ink(chance).bgr));
}

void dashed_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    Paint paint = stroked(any_form(chance, at, figure_mm).line, chance.between(0.4, 1.0),
                          any_ink(chance).bgr);
    paint.dashes_mm = {chance.between(1.6, 5.0), chance.between(1.2, 2.8)};
    sheet.paint(paint);
}

void dotted_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    Paint paint = stroked(any_form(chance, at, figure_mm).line, chance.between(1.0, 1.6),
                          any_ink(chance).bgr);
    paint.dashes_mm = {0.0, chance.between(2.6, 3.6)};
    sheet.paint(paint);
}

void broad_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    sheet.paint(stroked(arc(at, {12.0, 12.0}), chance.between(4.5, 6.0), any_ink(chance).bgr));
}

void crossing_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    Paint paint = filled(crossing_star(chance, at, figure_mm), any_ink(chance).bgr);
    paint.is_even_odd = chance.coin();
    sheet.paint(paint);
}

void ring_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    Polyline inner = arc(at, cv::Size2d(1.0, 1.0) * chance.between(6.0, 10.0));
    const bool is_even_odd = chance.coin();
    if (!is_even_odd) std::ranges::reverse(inner.points);
    sheet.paint(
        {{arc(at, {figure_mm, figure_mm}), inner}, 0.0, is_even_odd, {}, any_ink(chance).bgr});
}

void united_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    sheet.paint({{arc(at - Place(5.0, 0.0), {9.0, 9.0}), arc(at + Place(5.0, 0.0), {9.0, 9.0})},
                 0.0,
                 false,
                 {},
                 any_ink(chance).bgr});
}

void clear_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    for (const double side : {-5.0, 5.0}) {
        Paint paint = filled(arc(at + Place(side, 0.0), {9.0, 9.0}),
                             side < 0.0 ? cv::Scalar(76, 26, 204) : cv::Scalar(76, 26, 0));
        paint.opacity = chance.between(0.45, 0.65);
        sheet.paint(paint);
    }
}

void clipped_area_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const Place aside(chance.between(-4.0, 4.0), 0.0);
    Paint paint = filled(box_about(at + aside, 8.0, 12.0), any_ink(chance).bgr);
    paint.clips = {{arc(at, {13.0, 13.0})}};
    sheet.paint(paint);
}

void clipped_lines_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const Matrix turn = turn_about(at, chance.between(0.0, 180.0));
    const double width_mm = chance.between(0.6, 1.2);
    const Ink ink = any_ink(chance);
    for (int i = -2; i <= 2; ++i) {
        const Polyline line{{at + Place(-18.0, 5.6 * i), at + Place(18.0, 5.6 * i)}, false};
        Paint paint = stroked(turn.of(line), width_mm, ink.bgr);
        paint.clips = {{arc(at, {13.0, 13.0})}};
        sheet.paint(paint);
    }
}

/// The pen is as uneven as the map of its units.
void uneven_pen_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const Matrix units{chance.between(0.6, 1.0),  chance.between(-0.4, 0.4),
                       chance.between(-0.5, 0.5), chance.between(0.5, 0.9),
                       chance.between(0.0, 50.0), chance.between(0.0, 50.0)};
    sheet.paint(stroked(any_form(chance, at, figure_mm).line, chance.between(0.6, 2.6),
                        any_ink(chance).bgr),
                units);
}

const Polyline& triangle() {
    static const Polyline line{{{2.0, 10.0}, {6.0, 2.0}, {10.0, 10.0}}, true};
    return line;
}

/// One form XObject, placed three times.
void form_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const Paint paint = stroked(triangle(), chance.between(0.4, 1.0), any_ink(chance).bgr);
    const std::string form = sheet.add_resource(
        "/XObject", sheet.add_object(stream_of("/Type /XObject /Subtype /Form /BBox [0 0 12 12]",
                                               sheet.operators_of(paint))));
    for (const Place& corner : {Place(-14.0, -14.0), Place(2.0, -12.0), Place(-6.0, 1.0)}) {
        const Matrix there = turn_about(at + corner + Place(6.0, 6.0), chance.between(-15, 15)) *
                             Matrix{1, 0, 0, 1, at.x + corner.x, at.y + corner.y};
        sheet.write(fmt::format("q {} cm {} Do Q\n", written(there), form));
        sheet.know(stroked(there.of(triangle()), paint.width_mm, paint.colour));
    }
}

/// A pattern of four tiles.
void tiled_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const Paint paint = stroked(triangle(), chance.between(0.4, 1.0), any_ink(chance).bgr);
    const Place corner = at - Place(12.0, 12.0);
    const Matrix there = sheet.units_of_patterns() * Matrix{1, 0, 0, 1, corner.x, corner.y};
    const std::string pattern = sheet.add_resource(
        "/Pattern",
        sheet.add_object(stream_of(
            fmt::format("/Type /Pattern /PatternType 1 /PaintType 1 /TilingType 1 /BBox [0 0 12 12]"
                        " /XStep 12 /YStep 12 /Resources << >> /Matrix [{}]",
                        written(there)),
            sheet.operators_of(paint))));
    sheet.write(fmt::format("q /Pattern cs {} scn {:.4f} {:.4f} 24 24 re f Q\n", pattern, corner.x,
                            corner.y));
    for (const Place& tile : {Place(0, 0), Place(12, 0), Place(0, 12), Place(12, 12)})
        sheet.know(stroked(moved(triangle(), corner + tile), paint.width_mm, paint.colour));
}

/// Shading: one dark colour blends into another, along a line or outwards.
void shaded_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const Form form = any_form(chance, at, figure_mm);
    const std::string way =
        chance.coin()
            ? fmt::format("/ShadingType 2 /Coords [{} {} {} {}]", at.x - 12, at.y, at.x + 12, at.y)
            : fmt::format("/ShadingType 3 /Coords [{0} {1} 0 {0} {1} 15]", at.x, at.y);
    const std::string shading = sheet.add_resource(
        "/Shading",
        fmt::format("<< {} /ColorSpace /DeviceRGB /Extend [true true] /Function << /FunctionType 2 "
                    "/Domain [0 1] /C0 [0.1 0.1 0.4] /C1 [0.5 0.4 0.4] /N 1 >> >>",
                    way));
    std::string path;
    for (const cv::Point2d& p : form.line.points)
        path += fmt::format("{:.5f} {:.5f} {} ", p.x, p.y, path.empty() ? "m" : "l");
    sheet.write(fmt::format("q {}h W n {} sh Q\n", path, shading));
    sheet.know(filled(form.line, {100, 64, 76}));
}

void light_on_dark_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    sheet.paint(filled(box_about(at, figure_mm, figure_mm), any_ink(chance).bgr));
    sheet.paint(stroked(any_form(chance, at, 9.0).line, chance.between(0.6, 1.4), {255, 255, 255}));
}

void edged_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const Form form = any_form(chance, at, figure_mm);
    sheet.paint(filled(form.line, {128, chance.between(100, 230), 191}));
    sheet.paint(stroked(form.line, chance.between(0.3, 0.6), {26, 26, 26}));
}

/// An image of pixels: a dark box on white.
void picture_figure(PdfSheet& sheet, Chance&, const Place& at) {
    constexpr int width_px = 120;
    constexpr int height_px = 100;
    std::string pixels;
    for (int y = 0; y < height_px; ++y)
        for (int x = 0; x < width_px; ++x)
            pixels += x >= 30 && x < 90 && y >= 20 && y < 70 ? '\x30' : '\xff';
    const std::string image = sheet.add_resource(
        "/XObject",
        sheet.add_object(stream_of(fmt::format("/Type /XObject /Subtype /Image /Width {} /Height "
                                               "{} /BitsPerComponent 8 /ColorSpace /DeviceGray",
                                               width_px, height_px),
                                   pixels)));
    sheet.write(
        fmt::format("q 24 0 0 -20 {:.4f} {:.4f} cm {} Do Q\n", at.x - 12.0, at.y + 10.0, image));
    sheet.know(filled(box_about(at + Place(0.0, -1.0), 6.0, 5.0), {48, 48, 48}));
}

void label_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    sheet.paint(
        stroked(box_about(at, figure_mm, 8.0), chance.between(0.4, 1.0), any_ink(chance).bgr));
    sheet.say("Harbour", at + Place(-12.0, 1.6), chance.between(2.4, 5.2));
}

void watermark_figure(PdfSheet& sheet, Chance& chance, const Place& at) {
    const bool is_under = chance.coin();
    const Paint circle = stroked(arc(at, {12.0, 12.0}), 0.8, any_ink(chance).bgr);
    const double turn_deg = chance.between(23.0, 52.0);
    if (!is_under) sheet.paint(circle);
    const std::string clear = sheet.add_resource("/ExtGState", "<< /ca 0.3 >>");
    sheet.write(is_under ? "q " : fmt::format("q {} gs ", clear));
    const Matrix turned = turn_about(at, -turn_deg);
    sheet.say("SAMPLE", turned.of(at + Place(-15.0, 2.4)), 6.8, turn_deg, is_under ? 0.85 : 0.5);
    sheet.write("Q\n");
    if (is_under) sheet.paint(circle);
}

constexpr std::array<PdfFigure, 21> figures{{{"outline", outline_figure},
                                             {"open stroke", open_figure},
                                             {"hair line", hair_figure},
                                             {"dashes", dashed_figure},
                                             {"dots", dotted_figure},
                                             {"broad ring", broad_figure},
                                             {"crossing star", crossing_figure},
                                             {"ring", ring_figure},
                                             {"united discs", united_figure},
                                             {"clear discs", clear_figure},
                                             {"clipped area", clipped_area_figure},
                                             {"clipped lines", clipped_lines_figure},
                                             {"uneven pen", uneven_pen_figure},
                                             {"forms", form_figure},
                                             {"tiles", tiled_figure},
                                             {"shaded", shaded_figure},
                                             {"light on dark", light_on_dark_figure},
                                             {"area with edge", edged_figure},
                                             {"picture", picture_figure},
                                             {"label in box", label_figure},
                                             {"watermarked", watermark_figure}}};

}  // namespace

std::span<const PdfFigure> pdf_figures() {
    return figures;
}

}  // namespace touchline::testing
