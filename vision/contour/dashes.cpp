#include "config/types/angle.h"
#include "vision/contour/gradient.h"
#include "vision/contour/linking.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double longest_dash_mm = 7.0;
constexpr double widest_dot_mm = 3.0;
constexpr double widest_gap_mm = 4.2;
constexpr double most_bend = radians(60.0);  // round the corner of a box
constexpr double most_turn_at_dot = radians(90.0);
constexpr double most_turn_at_tip = radians(150.0);
constexpr double dash_corner_rad = radians(40.0);  // a turn of less is a curve's
constexpr double same_course = 0.03;  // the square of the sine between courses: they meet nowhere
constexpr double dash_over_width = 1.4;
constexpr std::size_t least_dashes = 3;
constexpr std::size_t least_dots = 5;
constexpr double alike_share = 0.35;       // of the middle length or gap: alike
constexpr double most_alike = 0.65;        // of the pieces: those at ends and corners are cut short
constexpr double field_ratio = 1.6;        // of the second nearest dot: so near are many others
constexpr std::size_t most_at_tip = 4;     // so near
constexpr std::size_t most_pieces = 2000;  // more are grain, or a tone that is printed in dots

/// A dash or a dot. Its two ends are EndIds of its place in the list of pieces; a dot's ends point
/// nowhere.
struct DashOrDot {
    std::size_t line = 0;
    std::vector<EdgePoint> way;  // the middle line of a dash; of a dot its middle
    double length_px = 0.0;      // of its ink
    double width_px = 0.0;
    bool is_dot = false;

    [[nodiscard]] const cv::Point2d& middle() const { return way[way.size() / 2].at; }
};

/// Returns a ring of ink as a piece: a dot, or a dash too short to have been a stroke.
std::optional<DashOrDot> piece_of_ring(const Chain& line, std::size_t number, double mm_px) {
    std::vector<cv::Point2f> points;
    for (const EdgePoint& p : line.points) points.emplace_back(p.at);
    const cv::RotatedRect box = cv::minAreaRect(points);
    const cv::Size2d size(box.size);
    const double long_px = std::max(size.width, size.height);
    const double short_px = std::min(size.width, size.height);
    if (short_px > widest_dot_mm * mm_px || long_px > longest_dash_mm * mm_px) return std::nullopt;
    const double strength = line.points.front().strength;
    const cv::Point2d middle(box.center);
    const bool is_dot = long_px < dash_over_width * short_px;
    if (is_dot) return DashOrDot{number, {{middle, strength, false}}, long_px, long_px, true};
    const double turned =
        radians(static_cast<double>(box.angle) + (size.width >= size.height ? 0.0 : 90.0));
    const cv::Point2d along(std::cos(turned), std::sin(turned));
    const cv::Point2d half = 0.5 * (long_px - short_px) * along;
    return DashOrDot{number,
                     {{middle - half, strength, false}, {middle + half, strength, false}},
                     long_px,
                     short_px,
                     false};
}

std::vector<DashOrDot> pieces_of(const std::vector<Chain>& lines, double mm_px) {
    std::vector<DashOrDot> pieces;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Chain& line = lines[i];
        if (line.points.empty()) continue;
        if (line.is_closed) {
            if (auto piece = piece_of_ring(line, i, mm_px)) pieces.push_back(std::move(*piece));
            continue;
        }
        const double length_px = length_of(line) + line.width_px;  // its ends lie within its ink
        if (length_px <= longest_dash_mm * mm_px) {
            pieces.push_back({i, line.points, length_px, line.width_px, false});
        }
    }
    return pieces;
}

/// The gap between the ink of two pieces.
struct Gap {
    double length_px = 0.0;             // along the way
    std::optional<cv::Point2d> corner;  // where the courses of the two meet, off the straight way
    std::optional<std::size_t> dash;    // the piece that is bent round that corner
};

struct Link {
    EndId a = 0;
    EndId b = 0;
    double cost = 0.0;
};

class Joiner {
  public:
    Joiner(std::vector<Chain> lines, double mm_px)
        : lines_(std::move(lines)), mm_px_(mm_px), pieces_(pieces_of(lines_, mm_px)) {}

    std::vector<Chain> joined() {
        link();
        std::vector<bool> is_gone(lines_.size(), false);
        std::vector<bool> is_walked(pieces_.size(), false);
        std::vector<Chain> made;
        for (const bool from_ends : {true, false}) {
            for (std::size_t number = 0; number < pieces_.size(); ++number) {
                const bool is_end =
                    to_[front_of(number)] == no_end || to_[back_of(number)] == no_end;
                if (is_walked[number] || is_end != from_ends) continue;
                const std::vector<EndId> way = walked(number, is_walked);
                if (is_broken_line(way)) {
                    made.push_back(line_through(way, !from_ends));
                    mark_gone(way, !from_ends, is_gone);
                }
            }
        }
        std::vector<Chain> kept;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (!is_gone[i]) kept.push_back(std::move(lines_[i]));
        }
        std::ranges::move(made, std::back_inserter(kept));
        return kept;
    }

  private:
    void mark_gone(const std::vector<EndId>& way, bool is_ring, std::vector<bool>& is_gone) const {
        for (std::size_t i = 0; i < way.size(); ++i) {
            is_gone[piece(way[i]).line] = true;
            const auto bent = i > 0 || is_ring ? gap_before(way, i).dash : std::nullopt;
            if (bent) is_gone[pieces_[*bent].line] = true;
        }
    }

    [[nodiscard]] const DashOrDot& piece(EndId end) const { return pieces_[chain_of(end)]; }

    [[nodiscard]] cv::Point2d place(EndId end) const {
        return is_back(end) ? piece(end).way.back().at : piece(end).way.front().at;
    }

    /// The direction outward, as far back as the dash is straight.
    [[nodiscard]] cv::Point2d straight_direction(EndId end) const {
        const std::vector<EdgePoint>& way = piece(end).way;
        double straight_px = 0.0;
        for (std::size_t i = 1; i < way.size(); ++i) {
            const EdgePoint& here = is_back(end) ? way[way.size() - 1 - i] : way[i];
            const EdgePoint& before = is_back(end) ? way[way.size() - i] : way[i - 1];
            straight_px += distance(here.at, before.at);
            if (here.is_fixed) break;
        }
        return ray_at(way, is_back(end), 0.0, std::min(straight_px, 0.5 * piece(end).length_px))
            .direction;
    }

    [[nodiscard]] const cv::Point2d& direction(EndId end) const { return directions_[end]; }

    /// Returns how far the ink goes beyond an end.
    [[nodiscard]] double beyond_px(EndId end) const { return 0.5 * piece(end).width_px; }

    [[nodiscard]] Gap gap_between(EndId a, EndId b) const {
        const Gap straight{distance(place(a), place(b)) - beyond_px(a) - beyond_px(b), {}, {}};
        if (piece(a).is_dot || piece(b).is_dot) return straight;
        const Ray from_a{place(a), direction(a)};
        const Ray from_b{place(b), direction(b)};
        if (angle_between(from_a.direction, -from_b.direction) < dash_corner_rad) return straight;
        const auto corner = crossing_of({from_a, from_b}, same_course);
        if (!corner) return straight;
        const double ahead_a = (*corner - from_a.from).dot(from_a.direction);
        const double ahead_b = (*corner - from_b.from).dot(from_b.direction);
        const double farthest_px = (longest_dash_mm + 2.0 * widest_gap_mm) * mm_px_;
        if (ahead_a <= -beyond_px(a) || ahead_b <= -beyond_px(b) ||
            ahead_a + ahead_b > farthest_px) {
            return straight;
        }
        const Gap bent{ahead_a + ahead_b - beyond_px(a) - beyond_px(b), corner, dot_at(*corner)};
        if (!bent.dash) return bent;
        return {0.5 * (bent.length_px - pieces_[*bent.dash].length_px), corner, bent.dash};
    }

    /// Returns the gap before the i-th piece of a way; before the first, the one from the last
    /// piece.
    [[nodiscard]] Gap gap_before(const std::vector<EndId>& way, std::size_t i) const {
        return gap_between(way[(i + way.size() - 1) % way.size()] ^ 1U, way[i]);
    }

    /// Returns the dot at a corner: a dash bent round a sharp corner is as wide as it is long.
    [[nodiscard]] std::optional<std::size_t> dot_at(const cv::Point2d& corner) const {
        const auto at = std::ranges::find_if(pieces_, [&](const DashOrDot& piece) {
            return piece.is_dot && distance(piece.middle(), corner) <= 0.75 * piece.length_px;
        });
        if (at == pieces_.end()) return std::nullopt;
        return static_cast<std::size_t>(at - pieces_.begin());
    }

    [[nodiscard]] double bend(EndId end, const cv::Point2d& way) const {
        return piece(end).is_dot ? 0.0 : angle_between(direction(end), way);
    }

    /// Dots with many others about as near as the second lie in a field, as do those at its rim. A
    /// sharp tip of a line has three or four.
    void find_fields() {
        std::vector<bool> is_amid(pieces_.size(), false);
        std::vector<std::vector<std::size_t>> nearest(pieces_.size());
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            std::vector<std::pair<double, std::size_t>> apart;
            for (std::size_t j = 0; pieces_[i].is_dot && j < pieces_.size(); ++j) {
                const double d = distance(pieces_[i].middle(), pieces_[j].middle());
                if (j != i && pieces_[j].is_dot && d < 3.0 * widest_gap_mm * mm_px_) {
                    apart.emplace_back(d, j);
                }
            }
            std::ranges::sort(apart);
            is_amid[i] = apart.size() > most_at_tip &&
                         apart[most_at_tip].first < field_ratio * apart[1].first;
            for (std::size_t k = 0; k < std::min(most_at_tip, apart.size()); ++k) {
                nearest[i].push_back(apart[k].second);
            }
        }
        is_in_field_ = is_amid;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const auto amid =
                std::ranges::count_if(nearest[i], [&](std::size_t j) { return is_amid[j]; });
            is_in_field_[i] = is_amid[i] || amid >= 2;
        }
    }

    void link() {
        to_.assign(2 * pieces_.size(), no_end);
        if (pieces_.size() > most_pieces) return;
        find_fields();
        for (EndId end = 0; end < 2 * pieces_.size(); ++end) {
            directions_.push_back(straight_direction(end));
        }
        link_where(widest_gap_mm * mm_px_, most_turn_at_dot, [](EndId) { return true; });
        // Continues what was begun round a sharp tip of dots, or past a missing dash.
        link_where(usual_pitch_px(), most_turn_at_tip,
                   [&](EndId end) { return to_[end] != no_end || to_[end ^ 1U] != no_end; });
    }

    template <class Counts>
    void link_where(double widest_gap_px, double most_turn, Counts&& counts) {
        std::vector<Link> links;
        std::vector<EndId> ends;
        for (EndId end = 0; end < 2 * pieces_.size(); ++end) {
            if (counts(end)) ends.push_back(end);
        }
        for (auto a = ends.begin(); a != ends.end(); ++a) {
            for (auto b = a + 1; b != ends.end(); ++b) consider(*a, *b, widest_gap_px, links);
        }
        std::ranges::stable_sort(links, {}, &Link::cost);
        for (const Link& link : links) {
            const EndId a = free_end(link.a);
            const EndId b = free_end(link.b);
            const bool is_taken = to_[a] != no_end || to_[b] != no_end;
            if (!is_taken && leads_on(a, b, most_turn) && leads_on(b, a, most_turn) &&
                !are_linked(a, b)) {
                to_[a] = b;
                to_[b] = a;
            }
        }
    }

    /// Returns the median distance from one piece across the next to the one after it; at least the
    /// widest gap.
    [[nodiscard]] double usual_pitch_px() const {
        std::vector<double> pitches;
        for (EndId end = 0; end < to_.size(); ++end) {
            if (to_[end] != no_end && end < to_[end]) {
                pitches.push_back(2.0 * gap_between(end, to_[end]).length_px +
                                  piece(end).length_px);
            }
        }
        const double widest_px = widest_gap_mm * mm_px_;
        if (pitches.empty()) return widest_px;
        return std::max(widest_px, median_of(std::move(pitches)));
    }

    /// Short dashes may look like dots; then they are as long as those that do not.
    [[nodiscard]] static bool are_of_a_kind(const DashOrDot& one, const DashOrDot& other) {
        constexpr double as_long = 0.2;
        return one.is_dot == other.is_dot || std::abs(one.length_px - other.length_px) <=
                                                 as_long * std::max(one.length_px, other.length_px);
    }

    void consider(EndId a, EndId b, double widest_gap_px, std::vector<Link>& links) const {
        const DashOrDot& one = piece(a);
        const DashOrDot& other = piece(b);
        const bool is_second_of_a_dot = (one.is_dot && is_back(a)) || (other.is_dot && is_back(b));
        if (&one == &other || is_second_of_a_dot || !are_of_a_kind(one, other) ||
            is_in_field_[chain_of(a)] || is_in_field_[chain_of(b)] ||
            distance(place(a), place(b)) > longest_dash_mm * mm_px_ + 2.0 * widest_gap_px) {
            return;
        }
        const Gap gap = gap_between(a, b);
        if (gap.length_px > widest_gap_px) return;
        const cv::Point2d way = place(b) - place(a);
        const double bend_a = bend(a, way);
        const double bend_b = bend(b, -way);
        if (gap.corner || std::max(bend_a, bend_b) <= most_bend) {
            links.push_back({a, b, std::max(gap.length_px, 0.1) * (1.0 + 2.0 * (bend_a + bend_b))});
        }
    }

    /// Returns a dot's end that is not taken yet.
    [[nodiscard]] EndId free_end(EndId end) const {
        return piece(end).is_dot && to_[end] != no_end ? end ^ 1U : end;
    }

    [[nodiscard]] bool are_linked(EndId a, EndId b) const {
        return to_[a ^ 1U] == b || to_[a ^ 1U] == (b ^ 1U);
    }

    /// Past a dot the way goes on, and does not turn back.
    [[nodiscard]] bool leads_on(EndId from, EndId to, double most_turn) const {
        if (!piece(from).is_dot || to_[from ^ 1U] == no_end) return true;
        const cv::Point2d before = place(from) - place(to_[from ^ 1U]);
        return angle_between(before, place(to) - place(from)) < most_turn;
    }

    /// Returns the ends through which the pieces are entered, from an end, or round.
    [[nodiscard]] std::vector<EndId> walked(std::size_t piece, std::vector<bool>& is_walked) const {
        std::vector<EndId> way;
        EndId in = to_[front_of(piece)] == no_end ? front_of(piece) : back_of(piece);
        while (in != no_end && !is_walked[chain_of(in)]) {
            is_walked[chain_of(in)] = true;
            way.push_back(in);
            in = to_[in ^ 1U];
        }
        return way;
    }

    static bool are_alike(const std::vector<double>& values) {
        if (values.empty()) return true;
        const double usual = median_of(values);
        const auto like = std::ranges::count_if(values, [&](double value) {
            return std::abs(value - usual) <= alike_share * std::abs(usual) + 1.0;
        });
        return static_cast<double>(like) >= most_alike * static_cast<double>(values.size());
    }

    [[nodiscard]] bool are_dots(const std::vector<EndId>& way) const {
        const auto dots = std::ranges::count_if(way, [&](EndId end) { return piece(end).is_dot; });
        return 2 * static_cast<std::size_t>(dots) >= way.size();
    }

    [[nodiscard]] bool is_broken_line(const std::vector<EndId>& way) const {
        if (way.empty() || way.size() < (are_dots(way) ? least_dots : least_dashes)) return false;
        std::vector<double> lengths;
        std::vector<double> gaps;
        for (std::size_t i = 0; i < way.size(); ++i) {
            lengths.push_back(piece(way[i]).length_px);
            if (i > 0) gaps.push_back(gap_before(way, i).length_px);
        }
        return are_alike(lengths) && are_alike(gaps);
    }

    [[nodiscard]] Chain line_through(const std::vector<EndId>& way, bool is_ring) const {
        Chain line;
        line.is_closed = is_ring;
        line.of = are_dots(way) ? LineOf::dotted : LineOf::dashed;
        for (std::size_t i = 0; i < way.size(); ++i) {
            const DashOrDot& part = piece(way[i]);
            line.width_px = std::max(line.width_px, part.width_px);
            std::vector<EdgePoint> points = part.way;
            if (is_back(way[i])) std::ranges::reverse(points);
            points.front().is_fixed = false;  // no longer an end
            points.back().is_fixed = false;
            if (is_ring || i > 0) add_corner(gap_before(way, i), line);
            std::ranges::move(points, std::back_inserter(line.points));
        }
        if (!is_ring) {
            line.points.front().is_fixed = true;
            line.points.back().is_fixed = true;
        }
        return line;
    }

    static void add_corner(const Gap& gap, Chain& line) {
        if (gap.corner) {
            const double strength = line.points.empty() ? 1.0 : line.points.back().strength;
            line.points.push_back({*gap.corner, strength, true});
        }
    }

    std::vector<Chain> lines_;
    double mm_px_;
    std::vector<DashOrDot> pieces_;
    std::vector<bool> is_in_field_;
    std::vector<cv::Point2d> directions_;  // of each end
    std::vector<EndId> to_;                // of each end
};

}  // namespace

std::vector<Chain> with_dashes_joined(std::vector<Chain> lines, double mm_px) {
    return Joiner(std::move(lines), mm_px).joined();
}

}  // namespace touchline
