// Private to app/documents/decode: the drawing elements of SVG, and the pen that turns their lines
// and curves into polylines, in millimetres of the viewBox. Threads: one tracer, one thread.
#pragma once

#include "app/documents/decode/svg_nodes.h"
#include "config/types/result.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace touchline::decode {

/// Closed: the last point joins the first, which is not repeated. Has at least two points, three if
/// closed; no two in a row are equal.
struct Subpath {
    std::vector<UserPoint> points;
    bool is_closed = false;
};

class SvgTracer {
  public:
    /// `to_view_box` maps the element's units to the viewBox; `max_points` bounds all subpaths
    /// together.
    SvgTracer(const Affine& to_view_box, std::size_t max_points)
        : to_view_box_(to_view_box), is_exact_(to_view_box == Affine{}), points_left_(max_points) {}

    void move_to(UserPoint to);
    void line_to(UserPoint to);
    void quadratic_to(UserPoint control, UserPoint to);
    void cubic_to(UserPoint control_1, UserPoint control_2, UserPoint to);

    /// SVG's elliptical arc (SVG 1.1, appendix F.6), radii of any sign and size.
    void arc_to(double radius_x, double radius_y, double rotation_deg, bool is_large,
                bool is_sweeping, UserPoint to);

    void close();

    /// The pen's place, in the element's units.
    [[nodiscard]] UserPoint pen() const { return pen_; }

    /// False from the first point that is not finite, or is one too many; such a point is not
    /// stored.
    [[nodiscard]] bool is_good() const { return is_good_; }

    /// Takes what was drawn. The tracer cannot be used after that.
    [[nodiscard]] std::vector<Subpath> take();

  private:
    void add(UserPoint in_view_box);
    void add_computed(UserPoint in_view_box);
    void add_end(UserPoint to);
    [[nodiscard]] bool can_add(double count);
    void begin_if_needed();
    void end_subpath(bool is_closed);

    Affine to_view_box_;
    bool is_exact_;  // no transform: coordinates pass as they were written
    std::size_t points_left_;
    bool is_good_ = true;
    bool is_open_ = false;
    UserPoint start_;
    UserPoint pen_;
    Subpath subpath_;
    std::vector<Subpath> done_;
};

/// Draws the d attribute of a path. Fails with what is wrong and where, not with a whole line,
/// because the caller knows the element's name.
[[nodiscard]] Result<void> draw_path(std::string_view d, SvgTracer& tracer);

/// Draws <path>, <polyline>, <polygon>, <line>, <rect>, <circle> or <ellipse>. Returns nothing for
/// any other element, which is left out. `name` is the element's name without its prefix.
[[nodiscard]] std::optional<Result<void>> draw_shape(const pugi::xml_node& element,
                                                     std::string_view name, SvgTracer& tracer);

}  // namespace touchline::decode
