#include "tests/lab/bench/collision/peers.h"

#include <vector>

#include <box2d/box2d.h>

namespace touchline::bench {
namespace {

constexpr float step_s = 1e-3F;
constexpr double tool_radius_m = 0.0005;
constexpr float coupling_Hz = 100.0F;
constexpr float critical = 1.0F;

class NearestHit : public b2RayCastCallback {
  public:
    float ReportFixture(b2Fixture* /*fixture*/, const b2Vec2& point, const b2Vec2& /*normal*/,
                        float fraction) override {
        hit_ = point;
        return fraction;  // nothing farther counts
    }

    [[nodiscard]] const std::optional<b2Vec2>& hit() const { return hit_; }

  private:
    std::optional<b2Vec2> hit_;
};

b2Vec2 in_units(Position p, double unit_m) {
    return {static_cast<float>(p.x / unit_m), static_cast<float>(p.y / unit_m)};
}

Position in_metres(b2Vec2 p, double unit_m) {
    return {static_cast<double>(p.x) * unit_m, static_cast<double>(p.y) * unit_m};
}

}  // namespace

double box2d_unit_m(std::size_t edges) {
    if (edges <= 4096) return 1e-3;
    return edges <= 65536 ? 1e-4 : 1e-5;
}

bool can_box2d_follow(std::size_t edges) {
    return edges <= 65536;
}

struct Box2dScene::World {
    b2World world{b2Vec2(0.0F, 0.0F)};
    b2Body* tool = nullptr;
    b2MouseJoint* joint = nullptr;
};

Box2dScene::Box2dScene(ClosedCurve curve)
    : unit_m_(box2d_unit_m(curve.size())), world_(std::make_unique<World>()) {
    b2World& world = world_->world;
    std::vector<b2Vec2> corners;
    corners.reserve(curve.size());
    for (const Position p : curve) corners.push_back(in_units(p, unit_m_));
    b2ChainShape chain;
    chain.CreateLoop(corners.data(), static_cast<int>(corners.size()));
    const b2BodyDef fixed;
    b2Body* const ground = world.CreateBody(&fixed);
    ground->CreateFixture(&chain, 0.0F);

    b2BodyDef moving;
    moving.type = b2_dynamicBody;
    moving.bullet = true;
    moving.allowSleep = false;
    moving.fixedRotation = true;
    // Starts outside the curve, until the first reset().
    moving.position = in_units({0.1, 0.1}, unit_m_);
    world_->tool = world.CreateBody(&moving);
    b2CircleShape disc;
    disc.m_radius = static_cast<float>(tool_radius_m / unit_m_);
    b2FixtureDef fixture;
    fixture.shape = &disc;
    fixture.density = 1.0F;
    fixture.friction = 0.0F;
    world_->tool->CreateFixture(&fixture);

    b2MouseJointDef joint;
    joint.bodyA = ground;
    joint.bodyB = world_->tool;
    joint.target = moving.position;
    joint.collideConnected = true;  // the joint is attached to the body of the chain
    joint.maxForce = 1e12F;
    b2LinearStiffness(joint.stiffness, joint.damping, coupling_Hz, critical, ground, world_->tool);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-static-cast-downcast): the type of its definition
    world_->joint = static_cast<b2MouseJoint*>(world.CreateJoint(&joint));
}

Box2dScene::Box2dScene(Box2dScene&&) noexcept = default;
Box2dScene::~Box2dScene() = default;

std::optional<Position> Box2dScene::first_crossing(Position from, Position to) const {
    const b2Vec2 a = in_units(from, unit_m_);
    const b2Vec2 b = in_units(to, unit_m_);
    if (!((b - a).LengthSquared() > 0.0F)) return std::nullopt;  // the library asserts on it
    NearestHit nearest;
    world_->world.RayCast(&nearest, a, b);
    if (!nearest.hit()) return std::nullopt;
    return in_metres(*nearest.hit(), unit_m_);
}

Position Box2dScene::step(Position hand) {
    constexpr int velocity_iterations = 8;
    constexpr int position_iterations = 3;
    world_->joint->SetTarget(in_units(hand, unit_m_));
    world_->world.Step(step_s, velocity_iterations, position_iterations);
    return in_metres(world_->tool->GetPosition(), unit_m_);
}

void Box2dScene::reset(Position hand) {
    world_->tool->SetTransform(in_units(hand, unit_m_), 0.0F);
    world_->tool->SetLinearVelocity({0.0F, 0.0F});
    world_->joint->SetTarget(in_units(hand, unit_m_));
}

}  // namespace touchline::bench
