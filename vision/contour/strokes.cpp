#include "vision/contour/strokes.h"

#include "vision/contour/corners.h"
#include "vision/contour/courses.h"
#include "vision/contour/ink_parts.h"
#include "vision/contour/junctions.h"
#include "vision/contour/rings.h"
#include "vision/contour/skeleton.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchline {
namespace {

constexpr double least_length_over_width = 2.5;  // with shorter arms it is a dot or a small star
// At a corner of angle a, the middle of the ink is 0.25 (1 / sin(a / 2) - 1) widths inside it, over
// half a width / tan(a / 2) of either side: as a blur of this many widths would move it.
constexpr double rounding_over_width = 0.5;
// A bevelled join of angle a leaves half a width x sin(a / 2) of ink beyond the corner, and other
// joins leave more; a bend's vertex is nearer to the edge.
constexpr double depth_at_corner = 0.48;

/// The contents of one connected piece of ink.
struct Piece {
    std::vector<std::size_t> arms;  // of the skeleton
    std::vector<const SolvedJunction*> solved;
    std::vector<const std::vector<EndId>*> unsolved;  // ends that meet
    std::vector<Chain> outlines;
    double width_px = 0.0;
    double longest_px = 0.0;  // of the arms
};

double middle_width(const std::vector<Chain>& arms, const std::vector<std::size_t>& which,
                    const cv::Mat1f& depth) {
    std::vector<float> depths;
    for (const std::size_t arm : which) {
        for (const EdgePoint& point : arms[arm].points) {
            depths.push_back(depth(cv::Point(cvRound(point.at.x), cvRound(point.at.y))));
        }
    }
    if (depths.empty()) return 0.0;
    return std::max(1.0, 2.0 * static_cast<double>(median_of(std::move(depths))) - 1.0);
}

class StrokeTracer {
  public:
    StrokeTracer(const Ink& ink, double greatest_width_px)
        : ink_(ink), parts_(parts_of(ink.mask, greatest_width_px)) {}

    std::vector<Chain> run() {
        const cv::Mat1b thin = thinned(parts_.strokes, depth_of(parts_.strokes));
        skeleton_ = with_hairpins_parted(skeleton_of(thin, parts_.depth), parts_.depth);
        std::vector<Piece> pieces = sorted_into_pieces();
        solve_joints(pieces);
        dots_become_shapes(pieces);
        for (Chain& outline : outlines()) {
            const int piece = piece_at(outline.points.front().at);
            pieces[static_cast<std::size_t>(piece)].outlines.push_back(std::move(outline));
        }
        std::vector<Chain> lines;
        for (Piece& piece : pieces) {
            std::vector<Chain> network = assembled(piece);
            std::ranges::move(network, std::back_inserter(lines));
        }
        return lines;
    }

  private:
    /// Returns the piece of ink at a place or right beside it.
    int piece_at(const cv::Point2d& at) const {
        for (const double dy : {0.0, -1.0, 1.0}) {
            for (const double dx : {0.0, -1.0, 1.0}) {
                const cv::Point p(cvRound(at.x + dx), cvRound(at.y + dy));
                if (cv::Rect({}, parts_.piece.size()).contains(p) && parts_.piece(p) != 0) {
                    return parts_.piece(p);
                }
            }
        }
        return 0;
    }

    std::vector<Piece> sorted_into_pieces() const {
        std::vector<Piece> pieces(static_cast<std::size_t>(parts_.pieces));
        for (std::size_t i = 0; i < skeleton_.arms.size(); ++i) {
            pieces[piece_of_arm(i)].arms.push_back(i);
            double& longest_px = pieces[piece_of_arm(i)].longest_px;
            longest_px = std::max(longest_px, length_of(skeleton_.arms[i]));
        }
        for (Piece& piece : pieces) {
            piece.width_px = middle_width(skeleton_.arms, piece.arms, parts_.depth);
        }
        return pieces;
    }

    /// Finds which ends meet, and where; drops the arms that nobody drew.
    void solve_joints(std::vector<Piece>& pieces) {
        std::vector<double> usual_depth_px(skeleton_.arms.size(), 1.0);
        for (const Piece& piece : pieces) {
            for (const std::size_t arm : piece.arms) {
                usual_depth_px[arm] = 0.5 * (piece.width_px + 1.0);
                skeleton_.arms[arm].width_px = piece.width_px;
                skeleton_.arms[arm] = in_the_middle(skeleton_.arms[arm], ink_.darkness);
            }
        }
        joints_ = joints_of(skeleton_, parts_.depth, usual_depth_px);
        for (Piece& piece : pieces) {
            std::erase_if(piece.arms, [&](std::size_t arm) { return joints_.is_dropped[arm]; });
        }
        for (const SolvedJunction& junction : joints_.solved) {
            pieces[piece_of_arm(chain_of(junction.arms.front().end))].solved.push_back(&junction);
        }
        for (const std::vector<EndId>& ends : joints_.unsolved) {
            pieces[piece_of_arm(chain_of(ends.front()))].unsolved.push_back(&ends);
        }
    }

    std::size_t piece_of_arm(std::size_t arm) const {
        const std::vector<EdgePoint>& points = skeleton_.arms[arm].points;
        return static_cast<std::size_t>(piece_at(points[points.size() / 2].at));
    }

    void dots_become_shapes(std::vector<Piece>& pieces) {
        std::vector<uchar> is_dot(pieces.size(), 0);
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            Piece& piece = pieces[i];
            if (piece.longest_px < least_length_over_width * piece.width_px) {
                is_dot[i] = 1;
                piece.arms.clear();
                piece.solved.clear();
                piece.unsolved.clear();
            }
        }
        for (int y = 0; y < parts_.shapes.rows; ++y) {
            for (int x = 0; x < parts_.shapes.cols; ++x) {
                if (is_dot[static_cast<std::size_t>(parts_.piece(y, x))] != 0) {
                    parts_.shapes(y, x) = 255;
                }
            }
        }
    }

    /// Returns the borders of the shapes, where the darkness is 1: a picture of two colours, 0 and
    /// 2.
    std::vector<Chain> outlines() const {
        if (cv::countNonZero(parts_.shapes) == 0) return {};
        LabPicture levels(ink_.darkness.size(), cv::Vec3f(0.0F, 0.0F, 0.0F));
        cv::insertChannel(ink_.darkness, levels, 0);
        const cv::Mat1b map = cv::Mat(parts_.shapes & 1);
        return region_borders(map, levels, {{0.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}});
    }

    std::vector<Chain> assembled(const Piece& piece) const {
        std::vector<Chain> lines;
        std::vector<EndId> place(2 * skeleton_.arms.size(), 0);  // of a skeleton's end among lines
        std::vector<bool> is_free;
        for (const std::size_t arm : piece.arms) {
            place[front_of(arm)] = front_of(lines.size());
            place[back_of(arm)] = back_of(lines.size());
            lines.push_back(skeleton_.arms[arm]);
            is_free.insert(is_free.end(), 2, !lines.back().is_closed);
        }
        const std::size_t strokes = lines.size();
        lines.insert(lines.end(), piece.outlines.begin(), piece.outlines.end());
        JunctionSet junctions(0.75 * piece.width_px + 0.5, std::max(4.0, 1.5 * piece.width_px));
        const auto placed = [&](EndId end) {
            is_free[place[end]] = false;
            return place[end];
        };
        for (const std::vector<EndId>* node : piece.unsolved) {
            std::vector<EndId> ends;
            std::ranges::transform(*node, std::back_inserter(ends), placed);
            if (ends.size() == 2) {
                junctions.add_joint(ends[0], ends[1]);
            } else {
                junctions.add_cluster(ends, point_at(lines, ends[0]).at);
            }
        }
        for (const SolvedJunction* known : piece.solved) {
            SolvedJunction junction = *known;
            for (SolvedJunction::Arm& arm : junction.arms) arm.end = placed(arm.end);
            for (auto& [a, b] : junction.through) {
                a = place[a];
                b = place[b];
            }
            junctions.add_solved(std::move(junction));
        }
        meet_outlines(lines, strokes, is_free, junctions);
        std::vector<Chain> network = junctions.assembled(std::move(lines));
        for (Chain& line : network) line = finished(std::move(line));
        return network;
    }

    /// Makes free ends of strokes that stop at a wide shape meet its outline.
    static void meet_outlines(const std::vector<Chain>& lines, std::size_t strokes,
                              const std::vector<bool>& is_free, JunctionSet& junctions) {
        for (EndId end = 0; end < 2 * strokes; ++end) {
            const Chain& line = lines[chain_of(end)];
            if (!is_free[end]) continue;
            const cv::Point2d at = point_at(lines, end).at;
            double nearest_px = line.width_px + 2.0;
            std::optional<PointRef> host;
            for (std::size_t c = strokes; c < lines.size(); ++c) {
                for (std::size_t i = 0; i < lines[c].points.size(); ++i) {
                    const double d = distance(lines[c].points[i].at, at);
                    if (d < nearest_px) {
                        nearest_px = d;
                        host = PointRef{c, i};
                    }
                }
            }
            if (host) junctions.add_meeting(end, *host);
        }
    }

    Chain finished(Chain line) const {
        if (line.width_px > 0.0) line = centred(line, ink_.darkness);
        const double width_px = line.width_px;
        line = with_sharp_corners(line, drawing_blur_px + rounding_over_width * width_px,
                                  [&](const cv::Point2d& at, double turn) {
                                      return depth_near(at) >=
                                             depth_at_corner * width_px * std::cos(0.5 * turn);
                                  });
        line.width_px = width_px;
        const auto is_set = [](const EdgePoint& point) { return point.strength > 0.0; };
        for (EdgePoint& point : line.points) {
            point.strength =
                gradient_over_step * static_cast<double>(ink_.contrast(pixel_at(point.at)));
        }
        if (std::ranges::none_of(line.points, is_set)) take_strength_beside(line);
        return line;
    }

    /// A border half-way between two pixels may be rounded to the paper's side all along, where
    /// there is no contrast, so the ink beside it tells how strong it is.
    void take_strength_beside(Chain& line) const {
        for (EdgePoint& point : line.points) {
            for (const double dy : {-0.5, 0.5}) {
                for (const double dx : {-0.5, 0.5}) {
                    const cv::Point pixel = pixel_at(point.at + cv::Point2d(dx, dy));
                    const auto contrast = static_cast<double>(ink_.contrast(pixel));
                    point.strength = std::max(point.strength, gradient_over_step * contrast);
                }
            }
        }
    }

    /// Returns the greatest depth within a pixel.
    double depth_near(const cv::Point2d& at) const {
        const cv::Point p = pixel_at(at);
        const cv::Rect around =
            cv::Rect(p.x - 1, p.y - 1, 3, 3) & cv::Rect({}, parts_.depth.size());
        double depth_px = 0.0;
        cv::minMaxLoc(parts_.depth(around), nullptr, &depth_px);
        return depth_px;
    }

    cv::Point pixel_at(const cv::Point2d& at) const {
        return touchline::pixel_at(at, ink_.mask.size());
    }

    const Ink& ink_;
    InkParts parts_;
    Skeleton skeleton_;
    Joints joints_;
};

/// Returns the contrast that all but one in fifty of the ink's pixels stay below.
double strong_contrast(const Ink& ink) {
    std::vector<float> contrasts;
    for (int y = 0; y < ink.mask.rows; ++y) {
        for (int x = 0; x < ink.mask.cols; ++x) {
            if (ink.mask(y, x) != 0) contrasts.push_back(ink.contrast(y, x));
        }
    }
    if (contrasts.empty()) return 0.0;
    const auto at = contrasts.begin() + static_cast<std::ptrdiff_t>(contrasts.size() * 49 / 50);
    std::ranges::nth_element(contrasts, at);
    return static_cast<double>(*at);
}

Ink without_grid(Ink ink, double greatest_width_px) {
    const cv::Mat1b pale((ink.contrast <= palest * strong_contrast(ink)) & ink.mask);
    const cv::Mat1b grid = grid_of(pale, greatest_width_px);
    if (!grid.empty()) {
        ink.mask.setTo(0, grid);
        ink.darkness.setTo(0.0, grid);
    }
    return ink;
}

}  // namespace

std::vector<Chain> stroke_lines(const Ink& ink, double greatest_width_px) {
    return StrokeTracer(ink, greatest_width_px).run();
}

std::vector<Chain> stroke_lines(const LabPicture& lab, double noise, double greatest_width_px) {
    return stroke_lines(without_grid(ink_of(lab, noise), greatest_width_px), greatest_width_px);
}

}  // namespace touchline
