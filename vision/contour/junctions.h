// Lines that meet: cuts them into arms, places the junction, and joins arms that continue each
// other again. Threads: one object, one thread.
#pragma once

#include "vision/contour/chain.h"

#include <utility>

namespace touchline {

/// A junction with a known place, and which of its arms are one line there.
struct SolvedJunction {
    struct Arm {
        EndId end;
        double bent_px;  // length of line before its end that a straight one replaces
    };

    cv::Point2d at;
    std::vector<Arm> arms;
    std::vector<std::pair<EndId, EndId>> through;
};

/// Collects which lines meet while they stay as they are; `assembled` then does all of it at once.
/// Ends and points are named by their place in the list of lines that `assembled` will get; an end
/// may be added once.
class JunctionSet {
  public:
    /// Smoothing bends lines within `blur_px` of a junction, so their course is taken from the next
    /// `span_px` of them.
    JunctionSet(double blur_px, double span_px) : blur_px_(blur_px), span_px_(span_px) {}

    /// Adds two ends that are one line, over a straight bridge.
    void add_joint(EndId a, EndId b) { joints_.emplace_back(a, b); }

    /// Adds three or more ends that meet near `centre`.
    void add_cluster(std::vector<EndId> ends, cv::Point2d centre);

    void add_solved(SolvedJunction junction) { solved_.push_back(std::move(junction)); }

    /// Adds an end that meets a line at one of its points.
    void add_meeting(EndId end, PointRef host);

    /// Returns the outlines. Each end at a junction becomes the junction's point, fixed, and the
    /// same for all, bit for bit; arms that continue each other within 30 degrees run through it.
    /// O(points + arms squared of each junction).
    [[nodiscard]] std::vector<Chain> assembled(std::vector<Chain> lines);

    /// The number of junctions, after `assembled`.
    [[nodiscard]] int size() const { return static_cast<int>(junctions_.size()); }

  private:
    struct Junction {
        cv::Point2d at;
        std::vector<EndId> arms;
        bool is_on_line = false;  // placed on the line that it meets
    };

    struct Cut {
        PointRef host;
        std::size_t junction = 0;
    };

    void cut_hosts();
    void cut(std::size_t host, const std::vector<Cut>& cuts);
    void place(Junction& junction);
    void pin_arms(const Junction& junction, bool is_moved);
    void pin(const SolvedJunction& junction);
    void join_through(const std::vector<EndId>& ends, const std::vector<Ray>& rays);
    [[nodiscard]] cv::Point2d place_of(const std::vector<Ray>& rays, cv::Point2d otherwise) const;
    [[nodiscard]] Ray ray_of(EndId end) const;
    [[nodiscard]] Chain walked(EndId start);
    void join(EndId a, EndId b);

    double blur_px_;
    double span_px_;
    std::vector<std::pair<EndId, EndId>> joints_;
    std::vector<Junction> junctions_;
    std::vector<SolvedJunction> solved_;
    std::vector<Cut> cuts_;

    // Used while assembling:
    std::vector<Chain> arms_;
    std::vector<std::pair<std::size_t, EndId>> host_arms_;  // junction, end of a piece cut there
    std::vector<EndId> moved_;    // where the back end of a line is after cutting
    std::vector<EndId> partner_;  // of each end
    std::vector<bool> is_walked_;
};

}  // namespace touchline
