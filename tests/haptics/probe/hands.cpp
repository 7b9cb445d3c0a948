#include "tests/haptics/probe/hands.h"

#include "tests/haptics/scenes.h"

namespace touchline {

Scene scene_of_outlines(std::vector<Outline> outlines) {
    return build_scene(scenes::map_of(std::move(outlines)), {}, 0.0).value();
}

ProbeShape shape_of(const Outline& outline, double radius_m) {
    return ProbeShape::build(probes::edges_of(outline), radius_m).value();
}

ProbeShape polygon(double radius_m, int edges) {
    return shape_of(scenes::circle(radius_m, edges));
}

ProbeShape any_shape(std::size_t number) {
    switch (number) {
        case 0:
            return probes::disc(0.002);
        case 1:
            return shape_of(probes::bar(0.02, 0.003));
        case 2:
            return shape_of(probes::ell(0.012, 0.002));
        case 3:
            return shape_of(probes::key(0.018));
        case 4:
            return shape_of(scenes::outline(
                {{-0.01, 0.0}, {-0.004, 0.004}, {0.0, -0.003}, {0.003, 0.005}, {0.01, 0.0}},
                false));
        default:
            return polygon(0.006, 24);
    }
}

ProbePose RestlessHand::step() {
    constexpr double dt_s = 1e-3;
    if (steps_left_-- <= 0) {
        const Position to = random_.place();
        const double speed = random_.unit() * random_.unit();  // m/s
        const Position by = to - pose_.place();
        steps_left_ = 1 + static_cast<int>(norm(by) / (speed * dt_s + 1e-6));
        if (steps_left_ > 300) steps_left_ = 300;
        const Direction along_way = direction_of(by);
        per_step_ = {along<Position>(along_way, speed * dt_s),
                     20.0 * (random_.unit() - 0.5) * random_.unit() * dt_s};
    }
    pose_ = pose_ + per_step_;
    return pose_;
}

}  // namespace touchline
