#include "vision/contour/dashes.h"

#include "vision/contour/ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace touchline {
namespace {

constexpr double kLongestDash_mm = 7.0;
constexpr double kWidestDot_mm = 3.0;
constexpr double kWidestGap_mm = 4.2;
constexpr double kMostBend = 60.0 * std::numbers::pi / 180.0;  // round the corner of a box
constexpr std::size_t kLeastDashes = 3;
constexpr std::size_t kLeastDots = 5;
constexpr double kLike = 0.35;             // of the middle length or gap: alike
constexpr double kMostAlike = 0.65;        // of the pieces: those at ends and corners are cut short
constexpr double kField = 1.5;             // of the second nearest dot: no nearer may be a third
constexpr std::size_t kMostPieces = 2000;  // more are grain, or a tone that is printed in dots
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

/// A dash or a dot. Its two ends are EndIds of its place in the list of pieces; those of a dot
/// point nowhere.
struct Piece {
    std::size_t line = 0;
    cv::Point2d middle;
    cv::Point2d front;
    cv::Point2d back;
    double length_px = 0.0;
    bool is_dot = false;
};

std::optional<Piece> dot_of(const Chain& line, std::size_t number, double mm_px) {
    cv::Point2d low = line.points.front().at;
    cv::Point2d high = low;
    for (const EdgePoint& p : line.points) {
        low = {std::min(low.x, p.at.x), std::min(low.y, p.at.y)};
        high = {std::max(high.x, p.at.x), std::max(high.y, p.at.y)};
    }
    const double across_px = std::max(high.x - low.x, high.y - low.y);
    if (across_px > kWidestDot_mm * mm_px) {
        return std::nullopt;
    }
    const cv::Point2d middle = 0.5 * (low + high);
    return Piece{number, middle, middle, middle, across_px, true};
}

std::vector<Piece> pieces_of(const std::vector<Chain>& lines, double mm_px) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Chain& line = lines[i];
        if (line.points.empty()) {
            continue;
        }
        if (line.is_closed) {
            if (const auto dot = dot_of(line, i, mm_px)) {
                pieces.push_back(*dot);
            }
            continue;
        }
        const double length_px = length_of(line) + line.width_px;  // its ends lie within its ink
        if (length_px <= kLongestDash_mm * mm_px) {
            const cv::Point2d front = line.points.front().at;
            const cv::Point2d back = line.points.back().at;
            pieces.push_back(
                {i, line.points[line.points.size() / 2].at, front, back, length_px, false});
        }
    }
    return pieces;
}

struct Link {
    EndId a = 0;
    EndId b = 0;
    double gap_px = 0.0;
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
            for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
                const bool is_end =
                    to_[front_of(piece)] == kNobody || to_[back_of(piece)] == kNobody;
                if (is_walked[piece] || is_end != from_ends) {
                    continue;
                }
                const std::vector<EndId> way = walked(piece, is_walked);
                if (!is_broken_line(way)) {
                    continue;
                }
                for (const EndId in : way) {
                    is_gone[pieces_[chain_of(in)].line] = true;
                }
                made.push_back(line_through(way, !from_ends));
            }
        }
        std::vector<Chain> kept;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (!is_gone[i]) {
                kept.push_back(std::move(lines_[i]));
            }
        }
        std::ranges::move(made, std::back_inserter(kept));
        return kept;
    }

  private:
    [[nodiscard]] cv::Point2d place(EndId end) const {
        const Piece& piece = pieces_[chain_of(end)];
        return is_back(end) ? piece.back : piece.front;
    }

    /// Outward.
    [[nodiscard]] cv::Point2d direction(EndId end) const {
        const Piece& piece = pieces_[chain_of(end)];
        const std::vector<EdgePoint>& points = lines_[piece.line].points;
        return ray_at(points, is_back(end), 0.0, 0.5 * piece.length_px).direction;
    }

    /// From the edge of the ink of the one to that of the other.
    [[nodiscard]] double gap_px(EndId a, EndId b) const {
        const auto beyond_px = [&](EndId end) {
            const Piece& piece = pieces_[chain_of(end)];
            return piece.is_dot ? 0.5 * piece.length_px : 0.5 * lines_[piece.line].width_px;
        };
        return distance(place(a), place(b)) - beyond_px(a) - beyond_px(b);
    }

    [[nodiscard]] double bend(EndId end, const cv::Point2d& way) const {
        return pieces_[chain_of(end)].is_dot ? 0.0 : angle_between(direction(end), way);
    }

    /// Dots with a third dot as near as the second lie in a field.
    void find_fields() {
        is_in_field_.assign(pieces_.size(), false);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            std::vector<double> apart;
            for (std::size_t j = 0; pieces_[i].is_dot && j < pieces_.size(); ++j) {
                const double d = distance(pieces_[i].middle, pieces_[j].middle);
                if (j != i && pieces_[j].is_dot && d < 3.0 * kWidestGap_mm * mm_px_) {
                    apart.push_back(d);
                }
            }
            if (apart.size() >= 3) {
                std::ranges::nth_element(apart, apart.begin() + 2);
                const double second = *std::max_element(apart.begin(), apart.begin() + 2);
                is_in_field_[i] = apart[2] < kField * second;
            }
        }
    }

    void link() {
        to_.assign(2 * pieces_.size(), kNobody);
        if (pieces_.size() > kMostPieces) {
            return;
        }
        find_fields();
        std::vector<Link> links;
        for (EndId a = 0; a < 2 * pieces_.size(); ++a) {
            for (EndId b = a + 1; b < 2 * pieces_.size(); ++b) {
                consider(a, b, links);
            }
        }
        std::ranges::stable_sort(links, {}, &Link::cost);
        for (const Link& link : links) {
            const EndId a = free_end(link.a);
            const EndId b = free_end(link.b);
            const bool is_taken = to_[a] != kNobody || to_[b] != kNobody;
            if (is_taken || !leads_on(a, b) || !leads_on(b, a) || are_linked(a, b)) {
                continue;
            }
            to_[a] = b;
            to_[b] = a;
        }
    }

    void consider(EndId a, EndId b, std::vector<Link>& links) const {
        const Piece& one = pieces_[chain_of(a)];
        const Piece& other = pieces_[chain_of(b)];
        const bool is_second_of_a_dot = (one.is_dot && is_back(a)) || (other.is_dot && is_back(b));
        if (&one == &other || is_second_of_a_dot || one.is_dot != other.is_dot ||
            is_in_field_[chain_of(a)] || is_in_field_[chain_of(b)]) {
            return;
        }
        const double gap = gap_px(a, b);
        if (gap > kWidestGap_mm * mm_px_) {
            return;
        }
        const cv::Point2d way = place(b) - place(a);
        const double bend_a = bend(a, way);
        const double bend_b = bend(b, -way);
        if (std::max(bend_a, bend_b) <= kMostBend) {
            links.push_back({a, b, gap, std::max(gap, 0.1) * (1.0 + 2.0 * (bend_a + bend_b))});
        }
    }

    /// A dot's end that is not taken yet.
    [[nodiscard]] EndId free_end(EndId end) const {
        return pieces_[chain_of(end)].is_dot && to_[end] != kNobody ? end ^ 1U : end;
    }

    [[nodiscard]] bool are_linked(EndId a, EndId b) const {
        return to_[a ^ 1U] == b || to_[a ^ 1U] == (b ^ 1U);
    }

    /// Past a dot the way goes on, and does not turn back.
    [[nodiscard]] bool leads_on(EndId from, EndId to) const {
        if (!pieces_[chain_of(from)].is_dot || to_[from ^ 1U] == kNobody) {
            return true;
        }
        const cv::Point2d before = place(from) - place(to_[from ^ 1U]);
        return angle_between(before, place(to) - place(from)) < 1.5 * kMostBend;
    }

    /// The ends by which the pieces are entered, from an end, or round.
    [[nodiscard]] std::vector<EndId> walked(std::size_t piece, std::vector<bool>& is_walked) const {
        std::vector<EndId> way;
        EndId in = to_[front_of(piece)] == kNobody ? front_of(piece) : back_of(piece);
        while (in != kNobody && !is_walked[chain_of(in)]) {
            is_walked[chain_of(in)] = true;
            way.push_back(in);
            in = to_[in ^ 1U];
        }
        return way;
    }

    static bool are_alike(std::vector<double> values) {
        if (values.empty()) {
            return true;
        }
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, middle);
        const double usual = *middle;
        const auto like = std::ranges::count_if(values, [&](double value) {
            return std::abs(value - usual) <= kLike * std::abs(usual) + 1.0;
        });
        return static_cast<double>(like) >= kMostAlike * static_cast<double>(values.size());
    }

    [[nodiscard]] bool is_broken_line(const std::vector<EndId>& way) const {
        if (way.empty() ||
            way.size() < (pieces_[chain_of(way.front())].is_dot ? kLeastDots : kLeastDashes)) {
            return false;
        }
        std::vector<double> lengths;
        std::vector<double> gaps;
        for (std::size_t i = 0; i < way.size(); ++i) {
            lengths.push_back(pieces_[chain_of(way[i])].length_px);
            if (i > 0) {
                gaps.push_back(gap_px(way[i - 1] ^ 1U, way[i]));
            }
        }
        return are_alike(std::move(lengths)) && are_alike(std::move(gaps));
    }

    [[nodiscard]] Chain line_through(const std::vector<EndId>& way, bool is_ring) const {
        Chain line;
        line.is_closed = is_ring;
        for (const EndId in : way) {
            const Piece& piece = pieces_[chain_of(in)];
            const Chain& part = lines_[piece.line];
            line.width_px = std::max(line.width_px, piece.is_dot ? piece.length_px : part.width_px);
            line.of = piece.is_dot ? LineOf::dotted : LineOf::dashed;
            if (piece.is_dot) {
                line.points.push_back({piece.middle, part.points.front().strength, false});
                continue;
            }
            std::vector<EdgePoint> points = part.points;
            if (is_back(in)) {
                std::ranges::reverse(points);
            }
            for (EdgePoint& point : points) {  // what was an end is none any more
                const bool is_end = &point == &points.front() || &point == &points.back();
                point.is_fixed = point.is_fixed && !is_end;
            }
            std::ranges::move(points, std::back_inserter(line.points));
        }
        if (!is_ring) {
            line.points.front().is_fixed = true;
            line.points.back().is_fixed = true;
        }
        return line;
    }

    std::vector<Chain> lines_;
    double mm_px_;
    std::vector<Piece> pieces_;
    std::vector<bool> is_in_field_;
    std::vector<EndId> to_;  // of each end
};

}  // namespace

std::vector<Chain> with_dashes_joined(std::vector<Chain> lines, double mm_px) {
    return Joiner(std::move(lines), mm_px).joined();
}

}  // namespace touchline
