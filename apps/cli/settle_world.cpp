// SPDX-License-Identifier: Apache-2.0
#include "settle_world.h"

#include "record/commands.h"

#include <hawser/sea.h>
#include <hawser/system.h>
#include <hawser/winch.h>

#include <cmath>
#include <memory>
#include <string>
#include <string_view>

namespace hawser::cli {

namespace {

/// Drag on all moving bodies, in proportion to their masses and moments of inertia.
class Drag final : public System {
  public:
    explicit Drag(double stop_time) : rate_(1.0 / stop_time) {}

    [[nodiscard]] std::string_view name() const noexcept override { return "drag of settle"; }

    void prestep(Prestep& now, Loads& loads) noexcept override {
        for (const BodyId id : now.world.bodies()) {
            if (!moves(now.world, id)) continue;
            const BodyDef& def = now.world.body_def(id);
            Eigen::Matrix<double, 6, 6> drag = Eigen::Matrix<double, 6, 6>::Zero();
            drag.diagonal().head<3>().setConstant(rate_ * def.mass);
            if (def.kind == BodyKind::rigid) {
                const Mat3 turn = now.world.pose(id).orientation.toRotationMatrix();
                drag.bottomRightCorner<3, 3>() = rate_ * (turn * def.inertia * turn.transpose());
            }
            loads.add_damping(id, drag);  // components without a freedom of the body have no effect
        }
    }

    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<Drag>(1.0 / rate_);
    }

  private:
    double rate_;
};

/// Replace the sea by a sea without waves, gusts and tide.
void still_sea(World& world) {
    const SeaDef* found = find_sea(world);
    if (found == nullptr) return;
    SeaDef def = *found;
    const double tide = Sea(def, world.settings().gravity.norm()).tide(world.time());
    SeaInputs in{.current = world.system_signal("sea.current"),
                 .wind = world.system_signal("sea.wind"),
                 .wind_direction = world.system_signal("sea.wind_direction"),
                 .level = world.system_signal("sea.level")};
    def.wind.gusts = false;
    def.level = {{.time = 0.0, .level = tide}};
    (void)world.remove_system(*world.find_system("sea"));
    (void)define(world, def);
    world.set_system_signal("sea.waves", 0.0);
    world.set_system_signal("sea.current", in.current);
    world.set_system_signal("sea.wind", in.wind);
    world.set_system_signal("sea.wind_direction", in.wind_direction);
    world.set_system_signal("sea.level", in.level);
}

/// Hold all drums. A drum that pays out would not come to rest, and a state file does not contain
/// the wire on drums. A winch with an active motor is held by this motor at zero speed, because its
/// brake may be too weak. The other winches are held by their brakes.
void hold_winches(World& world) {
    for (const SystemSignal& s : world.system_signals()) {
        if (!s.input || record::signal_words(world, s).empty()) continue;
        const std::string mode = s.system + ".mode";
        const auto now = static_cast<WinchMode>(std::lround(world.system_signal(mode)));
        const bool motor = now == WinchMode::speed || now == WinchMode::tension ||
                           now == WinchMode::render || now == WinchMode::heave;
        world.set_system_signal(mode,
                                static_cast<double>(motor ? WinchMode::speed : WinchMode::brake));
        world.set_system_signal(s.system + (motor ? ".speed" : ".brake"), motor ? 0.0 : 1.0);
    }
}

/// Return a copy of a world without systems and with drag on its bodies, for any contact solver.
/// Ids are equal in both worlds, because no object of a scene file's world has been removed.
World with_dragged_bodies(const World& from, double stop_time) {
    World world(from.settings());
    for (const BodyId id : from.bodies()) {
        BodyDef def = from.body_def(id);
        const Pose pose = from.pose(id);
        def.position = pose.position;
        def.orientation = pose.orientation;
        if (moves(from, id)) {
            def.velocity.setZero();
            def.angular_velocity.setZero();
            def.linear_damping.array() += def.mass / stop_time;
            if (def.kind == BodyKind::rigid)
                def.angular_damping += def.inertia.diagonal() / stop_time;
        }
        world.add_body(def);
    }
    for (const InteractionId id : from.interactions()) {
        InteractionDef def = from.interaction_def(id);
        if (kind_info(def.kind).is(kWireElement)) {
            def.set("breaking_load", 1e30);  // No element breaks while the scene settles.
            // A compliance derived from EA continues to follow the length that a drum pays out.
            if (def.compliance[0] == def.get("length") / def.get("EA"))
                def.compliance[0] = kDefault;
        }
        world.add_interaction(def);
    }
    for (std::int32_t i = 1; i < from.material_count(); ++i)
        world.add_material(from.material_def({i}));  // material 0, the default, exists already
    for (const MaterialPairDef& pair : from.material_pairs()) world.add_material_pair(pair);
    for (const ShapeId id : from.shapes()) world.add_shape(from.shape_def(id));
    return world;
}

}  // namespace

bool moves(const World& world, BodyId body) {
    const BodyKind kind = world.body_def(body).kind;
    return kind == BodyKind::rigid || kind == BodyKind::lump || kind == BodyKind::scalar;
}

World still_world(const World& from) {
    World world = from.twin();
    for (const BodyId id : world.bodies())
        if (moves(world, id)) world.set_velocity(id, {});
    still_sea(world);
    hold_winches(world);
    return world;
}

World with_drag(const World& still, double stop_time) {
    if (still.system_count() == 0) return with_dragged_bodies(still, stop_time);
    World world = still.twin();
    (void)world.add_system(std::make_unique<Drag>(stop_time));
    return world;
}

}  // namespace hawser::cli
