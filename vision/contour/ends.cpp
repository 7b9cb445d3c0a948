#include "vision/contour/ends.h"

#include <algorithm>
#include <cmath>

namespace touchline {

Ray ray_at(const std::vector<EdgePoint>& line, bool at_back, double skip_px, double span_px) {
    const std::size_t n = line.size();
    const auto at = [&](std::size_t i) { return line[at_back ? n - 1 - i : i].at; };
    std::size_t near = 0;
    std::size_t far = 0;
    double passed = 0.0;
    for (std::size_t i = 1; i < n && passed < skip_px + span_px; ++i) {
        passed += distance(at(i - 1), at(i));
        far = i;
        near = passed <= skip_px ? i : near;
    }
    if (near == far && near > 0) {  // shorter than the skip: its whole length
        near = 0;
    }
    const cv::Point2d along = at(near) - at(far);
    const double length = cv::norm(along);
    return {at(near), length > 0.0 ? along / length : cv::Point2d(1.0, 0.0)};
}

double angle_between(const cv::Point2d& a, const cv::Point2d& b) {
    return std::abs(std::atan2(a.cross(b), a.dot(b)));
}

double turn(const Ray& in, const Ray& out) {
    return angle_between(in.direction, -out.direction);
}

std::optional<cv::Point2d> crossing_of(const std::vector<Ray>& rays, double least) {
    cv::Matx22d a = cv::Matx22d::zeros();
    cv::Vec2d b(0.0, 0.0);
    for (const Ray& ray : rays) {
        const cv::Vec2d d(ray.direction.x, ray.direction.y);
        const cv::Matx22d across = cv::Matx22d::eye() - d * d.t();
        a += across;
        b += across * cv::Vec2d(ray.from.x, ray.from.y);
    }
    if (!(cv::determinant(a) >= least)) {
        return std::nullopt;
    }
    const cv::Vec2d solution = a.inv() * b;
    return cv::Point2d(solution[0], solution[1]);
}

PointGrid::PointGrid(const std::vector<Chain>& chains, cv::Size picture, double cell_px)
    : cell_px_(cell_px),
      columns_(static_cast<int>(picture.width / cell_px) + 1),
      rows_(static_cast<int>(picture.height / cell_px) + 1),
      start_(static_cast<std::size_t>(columns_ * rows_) + 1, 0) {
    for (const Chain& chain : chains) {
        for (const EdgePoint& point : chain.points) {
            ++start_[cell_of(point.at) + 1];
        }
    }
    for (std::size_t i = 1; i < start_.size(); ++i) {
        start_[i] += start_[i - 1];
    }
    refs_.resize(start_.back());
    std::vector<std::size_t> next = start_;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        for (std::size_t i = 0; i < chains[c].points.size(); ++i) {
            refs_[next[cell_of(chains[c].points[i].at)]++] = {c, i};
        }
    }
}

int PointGrid::column(double x) const {
    return std::clamp(static_cast<int>(std::floor(x / cell_px_)), 0, columns_ - 1);
}

int PointGrid::row(double y) const {
    return std::clamp(static_cast<int>(std::floor(y / cell_px_)), 0, rows_ - 1);
}

std::size_t PointGrid::cell_of(const cv::Point2d& p) const {
    return static_cast<std::size_t>(row(p.y) * columns_ + column(p.x));
}

}  // namespace touchline
