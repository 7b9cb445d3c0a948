#include "tests/vision/pictures/canvas.h"

#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {

Canvas::Canvas(cv::Size size, const cv::Scalar& paper)
    : size_(size),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height)),
      pen_(cairo_create(surface_)) {
    use(paper);
    cairo_paint(pen_);
    cairo_set_fill_rule(pen_, CAIRO_FILL_RULE_EVEN_ODD);
}

Canvas::~Canvas() {
    cairo_destroy(pen_);
    cairo_surface_destroy(surface_);
}

void Canvas::use(const cv::Scalar& ink) {
    cairo_set_source_rgb(pen_, ink[2] / 255.0, ink[1] / 255.0, ink[0] / 255.0);
}

void Canvas::use(const Font& font) {
    cairo_select_font_face(pen_, font.family.c_str(),
                           font.is_italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                           font.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(pen_, font.size_px);
}

void Canvas::add(const std::vector<Polyline>& lines) {
    cairo_new_path(pen_);
    for (const Polyline& line : lines) {
        cairo_new_sub_path(pen_);
        for (const cv::Point2d& p : line.points) {
            cairo_line_to(pen_, p.x, p.y);
        }
        if (line.is_closed) {
            cairo_close_path(pen_);
        }
    }
}

void Canvas::fill(const std::vector<Polyline>& rings, const cv::Scalar& ink) {
    use(ink);
    add(rings);
    cairo_fill(pen_);
}

void Canvas::stroke(const std::vector<Polyline>& lines, const Pen& pen, const cv::Scalar& ink) {
    constexpr std::array joins{CAIRO_LINE_JOIN_ROUND, CAIRO_LINE_JOIN_MITER, CAIRO_LINE_JOIN_BEVEL};
    constexpr std::array caps{CAIRO_LINE_CAP_ROUND, CAIRO_LINE_CAP_BUTT, CAIRO_LINE_CAP_SQUARE};
    constexpr double mitre_limit = 20.0;
    use(ink);
    add(lines);
    cairo_set_line_width(pen_, pen.width_px);
    cairo_set_line_join(pen_, joins[static_cast<std::size_t>(pen.join)]);
    cairo_set_line_cap(pen_, caps[static_cast<std::size_t>(pen.cap)]);
    cairo_set_miter_limit(pen_, mitre_limit);
    cairo_stroke(pen_);
}

void Canvas::write(const std::string& text, cv::Point2d at, const Font& font,
                   const cv::Scalar& ink) {
    use(ink);
    use(font);
    cairo_move_to(pen_, at.x, at.y);
    cairo_show_text(pen_, text.c_str());
}

std::vector<Polyline> Canvas::outline_of(const std::string& text, cv::Point2d at,
                                         const Font& font) {
    use(font);
    cairo_new_path(pen_);
    cairo_move_to(pen_, at.x, at.y);
    cairo_text_path(pen_, text.c_str());
    cairo_path_t* path = cairo_copy_path_flat(pen_);
    std::vector<Polyline> rings;
    for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
        const cairo_path_data_t* data = &path->data[i];
        if (data->header.type == CAIRO_PATH_MOVE_TO) {
            rings.push_back({{}, true});
        }
        if (data->header.type != CAIRO_PATH_CLOSE_PATH) {
            rings.back().points.emplace_back(data[1].point.x, data[1].point.y);
        }
    }
    cairo_path_destroy(path);
    cairo_new_path(pen_);
    std::erase_if(rings, [](const Polyline& ring) { return ring.points.size() < 3; });
    return rings;
}

double Canvas::width_of(const std::string& text, const Font& font) {
    use(font);
    cairo_text_extents_t extents;
    cairo_text_extents(pen_, text.c_str(), &extents);
    return extents.x_advance;
}

cv::Mat Canvas::picture() const {
    cairo_surface_flush(surface_);
    const cv::Mat bgrx(size_, CV_8UC4, cairo_image_surface_get_data(surface_),
                       static_cast<std::size_t>(cairo_image_surface_get_stride(surface_)));
    cv::Mat bgr;
    cv::cvtColor(bgrx, bgr, cv::COLOR_BGRA2BGR);
    return bgr;
}

Polyline arc(cv::Point2d centre, cv::Size2d radii, double from_deg, double to_deg) {
    const bool is_round = std::abs(to_deg - from_deg) >= 360.0;
    constexpr double arc_step_deg = 3.0;
    const int steps = std::max(8, static_cast<int>(std::abs(to_deg - from_deg) / arc_step_deg));
    Polyline line{{}, is_round};
    for (int i = 0; i < steps + (is_round ? 0 : 1); ++i) {
        const double a = (from_deg + (to_deg - from_deg) * i / steps) * std::numbers::pi / 180.0;
        line.points.emplace_back(centre.x + radii.width * std::cos(a),
                                 centre.y + radii.height * std::sin(a));
    }
    return line;
}

Polyline placed(const Polyline& line, cv::Point2d at, double scale, double angle_deg) {
    const double c = scale * std::cos(angle_deg * std::numbers::pi / 180.0);
    const double s = scale * std::sin(angle_deg * std::numbers::pi / 180.0);
    Polyline moved = line;
    for (cv::Point2d& p : moved.points) {
        p = at + cv::Point2d(c * p.x - s * p.y, s * p.x + c * p.y);
    }
    return moved;
}

}  // namespace touchline::testing
