#include "app/force/servo/scene_order.h"

#include "app/visit/proxy_radius.h"

namespace touchline {
namespace {

bool is_sound(const SceneOrder& order) {
    return order.device_step_m >= 1e-7 && order.device_step_m <= 0.01 && order.radius_m >= 0.0 &&
           order.radius_m <= 0.02 && order.resample <= 1;
}

}  // namespace

SceneOrder felt_order(const DeviceProfile& profile, int detail) {
    return {encoder_step_m(profile), proxy_radius_m, 1, detail};
}

Result<Scene> build_scene(const TactileMap& map, const SceneOrder& order) {
    if (!is_sound(order)) return failure("the order for a scene is out of range");
    CurveOptions options;
    options.resample = order.resample == 1;
    options.device_step_m = order.device_step_m;
    return build_scene(map, options, order.radius_m);
}

}  // namespace touchline
