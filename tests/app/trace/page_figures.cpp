#include "tests/app/trace/page_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

#include <cairo-pdf.h>
#include <cairo.h>

namespace touchline::testing {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int columns = 3;
constexpr int rows = 2;
constexpr double radius_pt = 75.0;  // 15 mm under the hand

using Points = std::vector<PagePoint>;

struct SurfaceRelease {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

    void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};

using Surface = std::unique_ptr<cairo_surface_t, SurfaceRelease>;
using Pattern = std::unique_ptr<cairo_pattern_t, SurfaceRelease>;

/// Draws in a cell of the page whose middle is (0, 0), and notes what is to be seen.
class Drawing {
  public:
    Drawing(cairo_t* pen, std::mt19937& random) : pen_(pen), random_(random) {}

    [[nodiscard]] cairo_t* pen() const { return pen_; }

    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }

    int whole(int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(random_);
    }

    /// Dark enough on white.
    void ink() {
        cairo_set_source_rgb(pen_, between(0.0, 0.5), between(0.0, 0.5), between(0.0, 0.5));
    }

    void path(const Points& points, bool is_closed) {
        cairo_new_sub_path(pen_);
        for (const PagePoint& p : points) cairo_line_to(pen_, p.x, p.y);
        if (is_closed) cairo_close_path(pen_);
    }

    void circle(double x, double y, double r, bool is_backwards = false) {
        cairo_new_sub_path(pen_);
        is_backwards ? cairo_arc_negative(pen_, x, y, r, 2.0 * pi, 0.0)
                     : cairo_arc(pen_, x, y, r, 0.0, 2.0 * pi);
        cairo_close_path(pen_);
    }

    /// What the current path shows, as Cairo flattens it.
    void see_path() {
        cairo_path_t* const flat = cairo_copy_path_flat(pen_);
        Points line;
        for (int i = 0; i < flat->num_data; i += flat->data[i].header.length) {
            const cairo_path_data_t* const data = flat->data + i;
            if (data->header.type == CAIRO_PATH_MOVE_TO) end(line);
            if (data->header.type == CAIRO_PATH_CLOSE_PATH && !line.empty())
                line.push_back(line.front());
            if (data->header.type == CAIRO_PATH_MOVE_TO || data->header.type == CAIRO_PATH_LINE_TO)
                line.push_back(on_page(data[1].point.x, data[1].point.y));
        }
        end(line);
        cairo_path_destroy(flat);
    }

    void see(const Points& points) {
        Points line;
        for (const PagePoint& p : points) line.push_back(on_page(p.x, p.y));
        end(line);
    }

    /// The runs of a line where a point of the cell can be seen.
    void see_where(const Points& points, const std::function<bool(const PagePoint&)>& is_seen) {
        constexpr double step = 0.25;
        Points run;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const double length =
                std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y);
            const int steps = std::max(1, static_cast<int>(length / step));
            for (int k = 0; k < steps; ++k) {
                const double part = static_cast<double>(k) / steps;
                const PagePoint p{std::lerp(points[i].x, points[i + 1].x, part),
                                  std::lerp(points[i].y, points[i + 1].y, part)};
                if (is_seen(p)) {
                    run.push_back(p);
                } else {
                    see(run);
                    run.clear();
                }
            }
        }
        see(run);
    }

    std::vector<Points> seen;  // on the page

  private:
    [[nodiscard]] PagePoint on_page(double x, double y) const {
        cairo_user_to_device(pen_, &x, &y);
        return {x, y};
    }

    void end(Points& line) {
        if (line.size() > 1) seen.push_back(line);
        line.clear();
    }

    cairo_t* pen_;
    std::mt19937& random_;
};

Points ring_of(double r, int corners, double from_rad, double inner = 1.0) {
    Points ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = from_rad + 2.0 * pi * i / corners;
        const double at = r * (i % 2 == 0 ? 1.0 : inner);
        ring.push_back({at * std::cos(angle), at * std::sin(angle)});
    }
    return ring;
}

Points closed(Points ring) {
    ring.push_back(ring.front());
    return ring;
}

Points circle_points(double x, double y, double r) {
    Points ring = ring_of(r, 360, 0.0);
    for (PagePoint& p : ring) p = {p.x + x, p.y + y};
    return closed(std::move(ring));
}

/// The pentagram as it is drawn, in one go.
Points pentagram(double r, double from_rad) {
    Points corners = ring_of(r, 5, from_rad);
    return {corners[0], corners[2], corners[4], corners[1], corners[3]};
}

/// Where its chords meet, as a share of its radius.
const double pentagram_inner = std::cos(2.0 * pi / 5.0) / std::cos(pi / 5.0);

void choose_pen(Drawing& d) {
    constexpr std::array joins{CAIRO_LINE_JOIN_MITER, CAIRO_LINE_JOIN_ROUND, CAIRO_LINE_JOIN_BEVEL};
    constexpr std::array caps{CAIRO_LINE_CAP_BUTT, CAIRO_LINE_CAP_ROUND, CAIRO_LINE_CAP_SQUARE};
    cairo_set_line_width(d.pen(), d.between(1.5, 12.0));
    cairo_set_line_join(d.pen(), joins.at(static_cast<std::size_t>(d.whole(0, 2))));
    cairo_set_line_cap(d.pen(), caps.at(static_cast<std::size_t>(d.whole(0, 2))));
}

void polygon(Drawing& d) {
    choose_pen(d);
    d.path(ring_of(radius_pt, d.whole(3, 8), d.between(0.0, 3.0)), true);
    d.see_path();
    cairo_stroke(d.pen());
}

void star_line(Drawing& d) {
    choose_pen(d);
    cairo_set_miter_limit(d.pen(), d.between(2.0, 12.0));
    d.path(ring_of(radius_pt, 2 * d.whole(4, 6), d.between(0.0, 3.0), 0.5), true);
    d.see_path();
    cairo_stroke(d.pen());
}

void open_curve(Drawing& d) {
    choose_pen(d);
    cairo_move_to(d.pen(), -70.0, d.between(-30.0, 30.0));
    cairo_curve_to(d.pen(), -30.0, -90.0, 20.0, d.between(40.0, 100.0), 70.0,
                   d.between(-40.0, 20.0));
    d.see_path();
    cairo_stroke(d.pen());
}

void hair_line(Drawing& d) {
    cairo_set_line_width(d.pen(), d.between(0.3, 1.0));
    d.circle(0.0, 0.0, radius_pt);
    d.see_path();
    cairo_stroke(d.pen());
}

void dashes(Drawing& d) {
    cairo_set_line_width(d.pen(), d.between(2.0, 5.0));
    const std::array<double, 2> dash{d.between(8.0, 25.0), d.between(6.0, 14.0)};
    cairo_set_dash(d.pen(), dash.data(), 2, 0.0);
    if (d.whole(0, 1) == 0) {
        d.path({{-70.0, -50.0}, {70.0, -50.0}, {70.0, 50.0}, {-70.0, 50.0}}, true);
    } else {
        d.circle(0.0, 0.0, radius_pt);
    }
    d.see_path();
    cairo_stroke(d.pen());
}

void dots(Drawing& d) {
    cairo_set_line_width(d.pen(), d.between(5.0, 8.0));
    cairo_set_line_cap(d.pen(), CAIRO_LINE_CAP_ROUND);
    const std::array<double, 2> dash{0.0, d.between(13.0, 18.0)};
    cairo_set_dash(d.pen(), dash.data(), 2, 0.0);
    d.circle(0.0, 0.0, radius_pt);
    d.see_path();
    cairo_stroke(d.pen());
}

void wide_ring(Drawing& d) {
    const double half = d.between(9.0, 14.0);
    cairo_set_line_width(d.pen(), 2.0 * half);
    d.circle(0.0, 0.0, 60.0);
    cairo_stroke(d.pen());
    d.see(circle_points(0.0, 0.0, 60.0 - half));
    d.see(circle_points(0.0, 0.0, 60.0 + half));
}

void nonzero_star(Drawing& d) {
    const double from = d.between(0.0, 3.0);
    d.path(pentagram(radius_pt, from), true);
    cairo_set_fill_rule(d.pen(), CAIRO_FILL_RULE_WINDING);
    cairo_fill(d.pen());
    d.see(closed(ring_of(radius_pt, 10, from, pentagram_inner)));
}

void evenodd_star(Drawing& d) {
    d.path(pentagram(radius_pt, d.between(0.0, 3.0)), true);
    d.see_path();
    cairo_set_fill_rule(d.pen(), CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(d.pen());
}

void ring(Drawing& d) {
    const bool is_even_odd = d.whole(0, 1) == 0;
    d.circle(0.0, 0.0, radius_pt);
    d.circle(0.0, 0.0, d.between(30.0, 55.0), !is_even_odd);
    d.see_path();
    cairo_set_fill_rule(d.pen(), is_even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_fill(d.pen());
}

bool is_in_circle(const PagePoint& p, double x, double r) {
    return std::hypot(p.x - x, p.y) < r;
}

void united_discs(Drawing& d) {
    d.circle(-25.0, 0.0, 45.0);
    d.circle(25.0, 0.0, 45.0);
    cairo_fill(d.pen());
    for (const double side : {-25.0, 25.0})
        d.see_where(circle_points(side, 0.0, 45.0),
                    [side](const PagePoint& p) { return !is_in_circle(p, -side, 45.0); });
}

void clear_discs(Drawing& d) {
    for (const double side : {-25.0, 25.0}) {
        cairo_set_source_rgba(d.pen(), side < 0.0 ? 0.8 : 0.0, 0.1, 0.3, 0.55);
        d.circle(side, 0.0, 45.0);
        d.see_path();
        cairo_fill(d.pen());
    }
}

void clipped_area(Drawing& d) {
    const double x = d.between(-20.0, 20.0);
    const Points box{{x - 40.0, -60.0}, {x + 40.0, -60.0}, {x + 40.0, 60.0}, {x - 40.0, 60.0}};
    d.circle(0.0, 0.0, 65.0);
    cairo_clip(d.pen());
    d.path(box, true);
    cairo_fill(d.pen());
    d.see_where(closed(box), [](const PagePoint& p) { return is_in_circle(p, 0.0, 65.0); });
    d.see_where(circle_points(0.0, 0.0, 65.0), [x](const PagePoint& p) {
        return std::abs(p.x - x) < 40.0 && std::abs(p.y) < 60.0;
    });
}

void clipped_lines(Drawing& d) {
    d.circle(0.0, 0.0, 65.0);
    cairo_clip(d.pen());
    cairo_set_line_width(d.pen(), d.between(3.0, 6.0));
    const double turn = d.between(0.0, pi);
    cairo_rotate(d.pen(), turn);
    for (int i = -2; i <= 2; ++i) {
        const Points line{{-90.0, 28.0 * i}, {90.0, 28.0 * i}};
        d.path(line, false);
        cairo_stroke(d.pen());
        d.see_where(line, [](const PagePoint& p) { return is_in_circle(p, 0.0, 65.0); });
    }
}

void skewed(Drawing& d) {
    cairo_matrix_t before;
    cairo_get_matrix(d.pen(), &before);
    const cairo_matrix_t skew{d.between(0.6, 1.0),
                              d.between(-0.4, 0.4),
                              d.between(-0.5, 0.5),
                              d.between(0.5, 0.9),
                              0.0,
                              0.0};
    cairo_transform(d.pen(), &skew);
    cairo_rectangle(d.pen(), -55.0, -45.0, 110.0, 90.0);
    d.see_path();
    cairo_set_matrix(d.pen(), &before);
    choose_pen(d);
    cairo_stroke(d.pen());
}

Surface small_triangle(double width_pt) {
    const cairo_rectangle_t extent{0.0, 0.0, 60.0, 60.0};
    Surface form(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &extent));
    cairo_t* const pen = cairo_create(form.get());
    cairo_set_line_width(pen, width_pt);
    cairo_move_to(pen, 10.0, 50.0);
    cairo_line_to(pen, 30.0, 10.0);
    cairo_line_to(pen, 50.0, 50.0);
    cairo_close_path(pen);
    cairo_stroke(pen);
    cairo_destroy(pen);
    return form;
}

void see_triangle(Drawing& d, double x, double y) {
    d.see({{x + 10.0, y + 50.0}, {x + 30.0, y + 10.0}, {x + 50.0, y + 50.0}, {x + 10.0, y + 50.0}});
}

void forms(Drawing& d) {
    const Surface form = small_triangle(d.between(2.0, 5.0));
    for (const PagePoint at : {PagePoint{-70.0, -70.0}, {10.0, -60.0}, {-30.0, 5.0}}) {
        cairo_set_source_surface(d.pen(), form.get(), at.x, at.y);
        cairo_paint(d.pen());
        see_triangle(d, at.x, at.y);
    }
}

void tiles(Drawing& d) {
    const Surface form = small_triangle(d.between(2.0, 5.0));
    const Pattern pattern(cairo_pattern_create_for_surface(form.get()));
    cairo_pattern_set_extend(pattern.get(), CAIRO_EXTEND_REPEAT);
    cairo_translate(d.pen(), -60.0, -60.0);
    cairo_set_source(d.pen(), pattern.get());
    cairo_rectangle(d.pen(), 0.0, 0.0, 120.0, 120.0);
    cairo_fill(d.pen());
    for (const double x : {0.0, 60.0})
        for (const double y : {0.0, 60.0}) see_triangle(d, x, y);
}

void shaded(Drawing& d) {
    const Pattern shade(cairo_pattern_create_linear(-60.0, 0.0, 60.0, 0.0));
    cairo_pattern_add_color_stop_rgb(shade.get(), 0.0, 0.1, 0.1, 0.4);
    cairo_pattern_add_color_stop_rgb(shade.get(), 1.0, 0.5, 0.4, 0.4);
    cairo_set_source(d.pen(), shade.get());
    d.circle(0.0, 0.0, d.between(45.0, 70.0));
    d.see_path();
    cairo_fill(d.pen());
}

void light_on_dark(Drawing& d) {
    d.path({{-75.0, -75.0}, {75.0, -75.0}, {75.0, 75.0}, {-75.0, 75.0}}, true);
    d.see_path();
    cairo_fill(d.pen());
    cairo_set_source_rgb(d.pen(), 1.0, 1.0, 1.0);
    cairo_set_line_width(d.pen(), d.between(3.0, 7.0));
    d.path(ring_of(45.0, d.whole(3, 6), d.between(0.0, 3.0)), true);
    d.see_path();
    cairo_stroke(d.pen());
}

void area_with_edge(Drawing& d) {
    cairo_set_line_width(d.pen(), d.between(1.5, 3.0));
    d.path(ring_of(radius_pt, d.whole(3, 7), d.between(0.0, 3.0)), true);
    d.see_path();
    cairo_set_source_rgb(d.pen(), 0.75, d.between(0.4, 0.9), 0.5);
    cairo_fill_preserve(d.pen());
    cairo_set_source_rgb(d.pen(), 0.1, 0.1, 0.1);
    cairo_stroke(d.pen());
}

void picture(Drawing& d) {
    const Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 120, 100));
    cairo_t* const pen = cairo_create(image.get());
    cairo_set_source_rgb(pen, 1.0, 1.0, 1.0);
    cairo_paint(pen);
    cairo_set_source_rgb(pen, 0.1, 0.2, 0.3);
    cairo_rectangle(pen, 30.0, 20.0, 60.0, 50.0);
    cairo_fill(pen);
    cairo_destroy(pen);
    cairo_translate(d.pen(), -60.0, -50.0);
    cairo_set_source_surface(d.pen(), image.get(), 0.0, 0.0);
    cairo_paint(d.pen());
    d.see({{30.0, 20.0}, {90.0, 20.0}, {90.0, 70.0}, {30.0, 70.0}, {30.0, 20.0}});
}

void label_in_box(Drawing& d) {
    cairo_set_line_width(d.pen(), d.between(2.0, 5.0));
    d.path({{-75.0, -40.0}, {75.0, -40.0}, {75.0, 40.0}, {-75.0, 40.0}}, true);
    d.see_path();
    cairo_stroke(d.pen());
    cairo_select_font_face(d.pen(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(d.pen(), d.between(12.0, 26.0));
    cairo_move_to(d.pen(), -60.0, 8.0);
    cairo_show_text(d.pen(), "Harbour");
}

void watermarked(Drawing& d) {
    cairo_set_line_width(d.pen(), 4.0);
    d.circle(0.0, 0.0, 60.0);
    d.see_path();
    cairo_stroke(d.pen());
    cairo_select_font_face(d.pen(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
    cairo_set_source_rgba(d.pen(), 0.5, 0.5, 0.5, 0.3);
    cairo_set_font_size(d.pen(), 34.0);
    cairo_rotate(d.pen(), -d.between(0.4, 0.9));
    cairo_move_to(d.pen(), -75.0, 12.0);
    cairo_show_text(d.pen(), "SAMPLE");
}

struct Kind {
    const char* name;
    void (*draw)(Drawing&);
};

constexpr std::array kinds{Kind{"polygon", polygon},
                           Kind{"star line", star_line},
                           Kind{"open curve", open_curve},
                           Kind{"hair line", hair_line},
                           Kind{"dashes", dashes},
                           Kind{"dots", dots},
                           Kind{"wide ring", wide_ring},
                           Kind{"nonzero star", nonzero_star},
                           Kind{"even-odd star", evenodd_star},
                           Kind{"ring", ring},
                           Kind{"united discs", united_discs},
                           Kind{"clear discs", clear_discs},
                           Kind{"clipped area", clipped_area},
                           Kind{"clipped lines", clipped_lines},
                           Kind{"skewed", skewed},
                           Kind{"forms", forms},
                           Kind{"tiles", tiles},
                           Kind{"shaded", shaded},
                           Kind{"light on dark", light_on_dark},
                           Kind{"area with edge", area_with_edge},
                           Kind{"picture", picture},
                           Kind{"label in box", label_in_box},
                           Kind{"watermarked", watermarked}};

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

int figure_kinds() {
    return static_cast<int>(kinds.size());
}

FiguresPage figures_page(std::uint32_t seed) {
    FiguresPage page;
    std::mt19937 random(seed);
    const Surface surface(
        cairo_pdf_surface_create_for_stream(append, &page.pdf, page_width_pt, page_height_pt));
    cairo_t* const pen = cairo_create(surface.get());
    for (int cell = 0; cell < columns * rows; ++cell) {
        const Kind& kind =
            kinds.at((columns * rows * seed + static_cast<std::uint32_t>(cell)) % kinds.size());
        cairo_save(pen);
        cairo_translate(pen, page_width_pt * (cell % columns + 0.5) / columns,
                        page_height_pt * (cell / columns + 0.5) / rows);
        Drawing drawing(pen, random);
        drawing.ink();
        kind.draw(drawing);
        cairo_restore(pen);
        for (Points& line : drawing.seen) page.lines.push_back({std::move(line), kind.name, cell});
    }
    cairo_destroy(pen);
    cairo_surface_finish(surface.get());
    return page;
}

}  // namespace touchline::testing
