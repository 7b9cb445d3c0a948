#include "app/decode/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace touchline::decode {
namespace {

/// Reads the lengths of one element, and remembers the first bad one.
class Lengths {
  public:
    explicit Lengths(const pugi::xml_node& element) : element_(element) {}

    std::optional<double> find(const char* name) {
        const pugi::xml_attribute attribute = element_.attribute(name);
        if (!attribute || std::string_view(attribute.value()) == "auto") return std::nullopt;
        const auto length = parse_svg_length(attribute.value());
        if (!length && result_) {
            result_ = failure(fmt::format("{} is no finite length in millimetres", name));
        }
        return length;
    }

    double operator()(const char* name) { return find(name).value_or(0.0); }

    [[nodiscard]] const Result<void>& result() const { return result_; }

  private:
    pugi::xml_node element_;
    Result<void> result_;
};

Result<void> draw_points(const char* points, bool is_closed, SvgTracer& tracer) {
    SvgScanner scanner(points);
    scanner.skip_space();
    for (bool is_first = true; !scanner.is_at_end(); is_first = false) {
        const auto x = scanner.take_number();
        const auto y = x ? scanner.take_number() : x;
        if (!y) {
            return failure(fmt::format("at character {} of points: pairs of finite numbers needed",
                                       scanner.position() + 1));
        }
        if (is_first) {
            tracer.move_to({*x, *y});
        } else {
            tracer.line_to({*x, *y});
        }
    }
    if (is_closed) tracer.close();
    return {};
}

Result<void> draw_line(const pugi::xml_node& element, SvgTracer& tracer) {
    Lengths length(element);
    tracer.move_to({length("x1"), length("y1")});
    tracer.line_to({length("x2"), length("y2")});
    return length.result();
}

/// Draws the rectangle as SVG defines it: from the left end of the upper side, clockwise on the
/// screen.
Result<void> draw_rectangle(const pugi::xml_node& element, SvgTracer& tracer) {
    Lengths length(element);
    const double x = length("x");
    const double y = length("y");
    const double width = length("width");
    const double height = length("height");
    const auto given_rx = length.find("rx");
    const auto given_ry = length.find("ry");
    if (!(width > 0.0 && height > 0.0)) return length.result();
    const double rx = std::clamp(given_rx.value_or(given_ry.value_or(0.0)), 0.0, width / 2.0);
    const double ry = std::clamp(given_ry.value_or(given_rx.value_or(0.0)), 0.0, height / 2.0);
    const double right = x + width;
    const double bottom = y + height;
    const auto corner = [&](UserPoint to) { tracer.arc_to(rx, ry, 0.0, false, true, to); };
    tracer.move_to({x + rx, y});
    tracer.line_to({right - rx, y});
    corner({right, y + ry});
    tracer.line_to({right, bottom - ry});
    corner({right - rx, bottom});
    tracer.line_to({x + rx, bottom});
    corner({x, bottom - ry});
    tracer.line_to({x, y + ry});
    corner({x + rx, y});
    tracer.close();
    return length.result();
}

Result<void> draw_ellipse(const pugi::xml_node& element, const char* name_rx, const char* name_ry,
                          SvgTracer& tracer) {
    Lengths length(element);
    const double x = length("cx");
    const double y = length("cy");
    const double rx = length(name_rx);
    const double ry = length(name_ry);
    if (!(rx > 0.0 && ry > 0.0)) return length.result();
    tracer.move_to({x + rx, y});
    tracer.arc_to(rx, ry, 0.0, false, true, {x - rx, y});
    tracer.arc_to(rx, ry, 0.0, false, true, {x + rx, y});
    tracer.close();
    return length.result();
}

constexpr std::string_view commands = "MLHVCSQTAZ";
constexpr std::array<std::size_t, 10> argument_counts{2, 2, 1, 1, 6, 4, 4, 2, 7, 0};

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Reads one d attribute, command by command.
class PathReader {
  public:
    PathReader(std::string_view d, SvgTracer& tracer) : scanner_(d), tracer_(tracer) {}

    Result<void> read() {
        scanner_.skip_space();
        while (!scanner_.is_at_end()) {
            if (auto taken = take_command(); !taken) return taken;
            if (auto taken = take_arguments(); !taken) return taken;
            draw();
            previous_ = upper(command_);
        }
        return {};
    }

  private:
    Result<void> wrong(std::string_view what) const {
        return failure(fmt::format("at character {} of d: {}", scanner_.position() + 1, what));
    }

    /// Takes a letter, or repeats the last one; a move is followed by lines.
    Result<void> take_command() {
        const char next = scanner_.peek();
        if (commands.find(upper(next)) != std::string_view::npos) {
            command_ = scanner_.take();
            scanner_.skip_space();
        } else if (previous_ == '\0' || previous_ == 'Z') {
            return wrong("a command is missing");
        } else if (command_ == 'M' || command_ == 'm') {
            command_ = command_ == 'M' ? 'L' : 'l';
        }
        if (previous_ == '\0' && upper(command_) != 'M') return wrong("a path begins with M");
        return {};
    }

    Result<void> take_arguments() {
        const bool is_arc = upper(command_) == 'A';
        const std::size_t count = argument_counts[commands.find(upper(command_))];
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_flag = is_arc && (i == 3 || i == 4);
            const auto number = is_flag ? scanner_.take_flag() : scanner_.take_number();
            if (!number) {
                return wrong(fmt::format("{} needs {} finite numbers at a time", command_, count));
            }
            arguments_[i] = *number;
        }
        return {};
    }

    /// The point of the arguments i and i + 1.
    [[nodiscard]] UserPoint point(std::size_t i) const {
        return origin() + UserPoint{arguments_[i], arguments_[i + 1]};
    }

    /// The origin of the numbers: the pen for a small letter.
    [[nodiscard]] UserPoint origin() const {
        return command_ == upper(command_) ? UserPoint{} : tracer_.pen();
    }

    /// The last control point, mirrored at the pen, if the last command was such a curve.
    [[nodiscard]] UserPoint mirrored_control(std::string_view after) const {
        const bool continues = after.find(previous_) != std::string_view::npos;
        return continues ? 2.0 * tracer_.pen() - control_ : tracer_.pen();
    }

    void draw_quadratic(UserPoint control, UserPoint to) {
        control_ = control;
        tracer_.quadratic_to(control, to);
    }

    void draw_cubic(UserPoint control_1, UserPoint control_2, UserPoint to) {
        control_ = control_2;
        tracer_.cubic_to(control_1, control_2, to);
    }

    void draw() {
        const auto& v = arguments_;
        switch (upper(command_)) {
            case 'M':
                return tracer_.move_to(point(0));
            case 'L':
                return tracer_.line_to(point(0));
            case 'H':
                return tracer_.line_to({origin().x + v[0], tracer_.pen().y});
            case 'V':
                return tracer_.line_to({tracer_.pen().x, origin().y + v[0]});
            case 'C':
                return draw_cubic(point(0), point(2), point(4));
            case 'S':
                return draw_cubic(mirrored_control("CS"), point(0), point(2));
            case 'Q':
                return draw_quadratic(point(0), point(2));
            case 'T':
                return draw_quadratic(mirrored_control("QT"), point(0));
            case 'A':
                return tracer_.arc_to(v[0], v[1], v[2], v[3] != 0.0, v[4] != 0.0, point(5));
            default:
                return tracer_.close();
        }
    }

    SvgScanner scanner_;
    SvgTracer& tracer_;
    char command_ = '\0';
    char previous_ = '\0';  // in capitals; 0 before the first
    std::array<double, 7> arguments_{};
    UserPoint control_;
};

}  // namespace

std::optional<Result<void>> draw_shape(const pugi::xml_node& element, std::string_view name,
                                       SvgTracer& tracer) {
    if (name == "path") return draw_path(element.attribute("d").value(), tracer);
    if (name == "polyline") return draw_points(element.attribute("points").value(), false, tracer);
    if (name == "polygon") return draw_points(element.attribute("points").value(), true, tracer);
    if (name == "line") return draw_line(element, tracer);
    if (name == "rect") return draw_rectangle(element, tracer);
    if (name == "circle") return draw_ellipse(element, "r", "r", tracer);
    if (name == "ellipse") return draw_ellipse(element, "rx", "ry", tracer);
    return std::nullopt;
}

Result<void> draw_path(std::string_view d, SvgTracer& tracer) {
    return PathReader(d, tracer).read();
}

}  // namespace touchline::decode
