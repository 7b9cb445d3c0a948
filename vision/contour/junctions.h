// Lines that meet: cutting them into arms, placing the junction, and putting arms that continue
// each other together again. Threads: one object, one thread.
#pragma once

#include "vision/contour/ends.h"

#include <utility>

namespace touchline {

/// A junction whose place is known, and which of its arms are one line there.
struct SolvedJunction {
    struct Arm {
        EndId end;
        double bent_px;  // so much of the line before its end gives way to a straight one
    };

    cv::Point2d at;
    std::vector<Arm> arms;
    std::vector<std::pair<EndId, EndId>> through;
};

/// Collects who meets whom while the lines stay as they are; `assembled` then does all of it at
/// once. Ends and points are named by their place in the list of lines that `assembled` will get;
/// an end may be added once.
class JunctionSet {
  public:
    /// Within `blur_px` of a junction lines are bent by smoothing: their course is taken from the
    /// next `span_px` of them.
    JunctionSet(double blur_px, double span_px) : blur_px_(blur_px), span_px_(span_px) {}

    /// Two ends that are one line, over a straight bridge.
    void add_joint(EndId a, EndId b) { joints_.emplace_back(a, b); }

    /// Three or more ends that meet near `centre`.
    void add_cluster(std::vector<EndId> ends, cv::Point2d centre);

    void add_solved(SolvedJunction junction) { solved_.push_back(std::move(junction)); }

    /// An end that meets a line at one of its points.
    void add_meeting(EndId end, PointRef host);

    /// The outlines. Each end at a junction becomes the junction's point, fixed, bit for bit the
    /// same for all; arms that continue each other within 30 degrees run through it. O(points +
    /// arms squared of each junction).
    [[nodiscard]] std::vector<Chain> assembled(std::vector<Chain> lines);

    /// Junctions, after `assembled`.
    [[nodiscard]] int size() const { return static_cast<int>(junctions_.size()); }

  private:
    struct Junction {
        cv::Point2d at;
        std::vector<EndId> arms;
        bool is_on_line = false;  // placed on the line that is met
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

    // While assembling:
    std::vector<Chain> arms_;
    std::vector<std::pair<std::size_t, EndId>> host_arms_;  // junction, end of a piece cut there
    std::vector<EndId> moved_;    // where the back end of a line is after cutting
    std::vector<EndId> partner_;  // of each end
    std::vector<bool> is_walked_;
};

}  // namespace touchline
