#include "tests/app/drawings/pdf_sheet.h"

#include "config/types/angle.h"
#include "tests/app/documents/decode/pdf_writer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

/// Maps the sheet to a page with this many points per millimetre, which a viewer turns clockwise by
/// so many quarters.
Matrix page_matrix(double k, int quarter_turns) {
    const double width = k * drawing_sheet_mm.width;
    const double height = k * drawing_sheet_mm.height;
    switch (quarter_turns) {
        case 1:
            return {0, k, k, 0, 0, 0};
        case 2:
            return {-k, 0, 0, k, width, 0};
        case 3:
            return {0, -k, -k, 0, height, width};
        default:
            return {k, 0, 0, -k, 0, height};
    }
}

/// Returns how much longer than written a line can become.
double most_stretch(const Matrix& m) {
    const double sum = m.a * m.a + m.b * m.b + m.c * m.c + m.d * m.d;
    const double area = m.a * m.d - m.b * m.c;
    return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * area * area))));
}

std::string path_of(const std::vector<Polyline>& lines, const Matrix& to_units) {
    std::string out;
    for (const Polyline& line : lines) {
        const char* way = "m";
        for (const cv::Point2d& point : line.points) {
            const cv::Point2d p = to_units.of(point);
            out += fmt::format("{:.5f} {:.5f} {} ", p.x, p.y, std::exchange(way, "l"));
        }
        if (line.is_closed) out += "h ";
    }
    return out;
}

std::string colour_of(const cv::Scalar& bgr) {
    return fmt::format("{:.4f} {:.4f} {:.4f}", bgr[2] / 255.0, bgr[1] / 255.0, bgr[0] / 255.0);
}

std::string box_of(double x, double y, double width, double height) {
    return fmt::format("[{:.4f} {:.4f} {:.4f} {:.4f}]", x, y, x + width, y + height);
}

}  // namespace

std::string written(const Matrix& m) {
    return fmt::format("{:.6f} {:.6f} {:.6f} {:.6f} {:.6f} {:.6f}", m.a, m.b, m.c, m.d, m.e, m.f);
}

PdfSheet::PdfSheet(Chance& chance)
    : chance_(chance), quarter_turns_(chance.below(4)), is_cropped_(chance.coin()) {
    user_unit_ = chance.coin() ? 1.0 : chance.between(0.5, 4.0);
    pt_per_mm_ = chance.between(1.5, 12.0) / user_unit_;
    corner_pt_ = {chance.between(-300.0, 300.0), chance.between(-300.0, 300.0)};
    is_form_ = chance.coin();
    to_page_ =
        Matrix{1, 0, 0, 1, corner_pt_.x, corner_pt_.y} * page_matrix(pt_per_mm_, quarter_turns_);
}

void PdfSheet::paint(const Paint& paint) {
    const double scale = chance_.between(0.2, 5.0);
    const Matrix turned = turn_about({58.0, 42.0}, chance_.between(0.0, 360.0));
    this->paint(paint, chance_.coin() ? Matrix{} : turned * Matrix{scale, 0, 0, scale, 0, 0});
}

void PdfSheet::paint(const Paint& paint, const Matrix& units) {
    know(paint);
    write(operators_of(paint, units));
}

std::string PdfSheet::operators_of(const Paint& paint, const Matrix& units) {
    const Matrix to_units = units.inverse();
    std::string out = fmt::format("q {} cm ", written(units));
    for (const std::vector<Polyline>& clip : paint.clips) out += path_of(clip, to_units) + "W n ";
    if (paint.opacity < 1.0)
        out += add_resource("/ExtGState",
                            fmt::format("<< /ca {0:.3f} /CA {0:.3f} >>", paint.opacity)) +
               " gs ";
    const std::string path = path_of(paint.lines, to_units);
    if (paint.width_mm <= 0.0)
        return fmt::format("{}{} rg {}{} Q\n", out, colour_of(paint.colour), path,
                           paint.is_even_odd ? "f*" : "f");
    const double to_length = 1.0 / most_stretch(units);
    const bool is_broad = paint.width_mm > widest_line_mm;
    const bool is_dots = !paint.dashes_mm.empty() && paint.dashes_mm.front() <= 0.0;
    const int join = is_broad ? 1 : chance_.below(3);
    const int cap = is_broad || is_dots ? 1 : paint.dashes_mm.empty() ? chance_.below(3) : 0;
    std::string dashes;
    for (const double mm : paint.dashes_mm) dashes += fmt::format("{:.5f} ", mm * to_length);
    return fmt::format("{}{} RG {:.5f} w {} j {} J {:.2f} M [{}] 0 d {}S Q\n", out,
                       colour_of(paint.colour), paint.width_mm * to_length, join, cap,
                       chance_.between(2.0, 12.0), dashes, path);
}

void PdfSheet::say(std::string_view words, const cv::Point2d& at, double size_mm, double turn_deg,
                   double grey) {
    const double t = radians(turn_deg);
    const Matrix place{std::cos(t), -std::sin(t), -std::sin(t), -std::cos(t), at.x, at.y};
    write(fmt::format("{:.3f} g BT /F {:.3f} Tf {} Tm ({}) Tj ET\n", grey, size_mm, written(place),
                      words));
}

std::string PdfSheet::add_object(const std::string& body) {
    constexpr std::size_t first = 5;  // after those that written_pdf uses
    objects_.push_back(body);
    return fmt::format("{} 0 R", first + objects_.size() - 1);
}

std::string PdfSheet::add_resource(const std::string& category, const std::string& value) {
    const std::string name = fmt::format("/R{}", ++resource_count_);
    resources_[category] += fmt::format("{} {} ", name, value);
    return name;
}

Matrix PdfSheet::units_of_patterns() const {
    return is_form_ ? Matrix{} : to_page_;
}

cv::Size2d PdfSheet::size_pt() const {
    const cv::Size2d upright = drawing_sheet_mm * pt_per_mm_;
    return quarter_turns_ % 2 == 1 ? cv::Size2d(upright.height, upright.width) : upright;
}

std::string PdfSheet::boxes() const {
    const double width = size_pt().width;
    const double height = size_pt().height;
    const double edge = is_cropped_ ? 40.0 : 0.0;
    std::string out = fmt::format(
        "/Rotate {} /UserUnit {:.5f} /MediaBox {}", 90 * quarter_turns_, user_unit_,
        box_of(corner_pt_.x - edge, corner_pt_.y - edge, width + 2.0 * edge, height + 2.0 * edge));
    if (is_cropped_)
        out += fmt::format(" /CropBox {}", box_of(corner_pt_.x, corner_pt_.y, width, height));
    return out;
}

Drawing PdfSheet::drawing() {
    std::string resources = "/Font << /F 4 0 R >>";
    for (const auto& [category, entries] : resources_)
        resources += fmt::format(" {} << {}>>", category, entries);
    WrittenPage page{fmt::format("q {} cm\n{}Q\n", written(to_page_), content_), boxes(),
                     resources};
    if (is_form_) {
        const std::string form = add_object(stream_of(
            fmt::format("/Type /XObject /Subtype /Form /BBox [-20 -20 140 110] /Matrix [{}] "
                        "/Resources << {} >>",
                        written(to_page_), resources),
            content_));
        page.content = "/All Do\n";
        page.resources = fmt::format("/XObject << /All {} >>", form);
    }
    if (is_cropped_)  // a frame that a printer would cut off
        page.content +=
            fmt::format("4 w {:.4f} {:.4f} {:.4f} {:.4f} re S\n", corner_pt_.x - 20.0,
                        corner_pt_.y - 20.0, size_pt().width + 40.0, size_pt().height + 40.0);
    Drawing out{"", "", "", paints_};
    for (const std::byte byte : written_pdf({page}, objects_))
        out.file.push_back(static_cast<char>(byte));
    return out;
}

}  // namespace touchline::testing
