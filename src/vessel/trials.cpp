// SPDX-License-Identifier: Apache-2.0
#include <hawser/vessel_trials.h>
#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace hawser {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180.0;

/// Track of a vessel in the frame of its start: x along the first heading, y to starboard.
class Track {
  public:
    Track(const World& world, const VesselDef& vessel) : world_(world), vessel_(vessel) {
        read();
        start_ = place_;
        first_ = course_;
        last_position_ = place_;
    }
    /// Record the position after a step.
    void step() {
        const double before = course_;
        last_position_ = place_;
        read();
        heading_ += std::remainder(course_ - before, 2.0 * std::numbers::pi);
        way_ += (place_ - last_position_).norm();
    }
    [[nodiscard]] double heading() const noexcept { return heading_; }  ///< Change [rad].
    [[nodiscard]] double roll() const noexcept { return roll_; }
    [[nodiscard]] double way() const noexcept { return way_; }
    [[nodiscard]] double forward_displacement(double share) const noexcept {
        return at(share).first;
    }
    [[nodiscard]] double lateral_displacement(double share) const noexcept {
        return at(share).second;
    }
    [[nodiscard]] double last_step_length() const noexcept {
        return (place_ - last_position_).norm();
    }

  private:
    void read() {
        const Pose pose = world_.pose(vessel_.body);
        const Mat3 axes = pose.orientation.toRotationMatrix();
        place_ = pose.position + axes * vessel_.origin;
        course_ = -std::atan2(axes(1, 0), axes(0, 0));
        roll_ = std::atan2(axes(2, 1), axes(2, 2));
    }
    /// Interpolate the position between the last two steps.
    [[nodiscard]] std::pair<double, double> at(double share) const noexcept {
        const Vec3 d = last_position_ + share * (place_ - last_position_) - start_;
        const double c = std::cos(first_), s = std::sin(first_);
        return {c * d.x() - s * d.y(), -s * d.x() - c * d.y()};
    }
    const World& world_;
    const VesselDef& vessel_;
    Vec3 place_{0.0, 0.0, 0.0}, last_position_{0.0, 0.0, 0.0}, start_{0.0, 0.0, 0.0};
    double course_ = 0.0, first_ = 0.0, heading_ = 0.0, roll_ = 0.0, way_ = 0.0;
};

void step_trial(World& world) {
    if (const Status status = world.step(); status != Status::ok)
        throw DefError("trial: a step ended with " + std::string(to_string(status)));
}

}  // namespace

TurningCircle turning_circle(World& world, const VesselDef& vessel, double rudder,
                             double duration) {
    const std::string name = vessel.name + ".";
    world.set_system_signal(name + "rudder", rudder);
    Track track(world, vessel);
    TurningCircle out;
    const double begin = world.time(), side = rudder < 0.0 ? -1.0 : 1.0;
    const long steps = std::lround(duration / world.settings().step);
    double before = 0.0;
    for (long i = 0; i < steps; ++i) {
        const double from = world.time() - begin;
        step_trial(world);
        track.step();
        const double now = side * track.heading();
        const auto passes = [&](double angle) { return before < angle && now >= angle; };
        const auto share = [&](double angle) { return (angle - before) / (now - before); };
        const auto time = [&](double angle) {
            return from + share(angle) * (world.time() - begin - from);
        };
        if (passes(10.0 * kOneDegree))
            out.track10 = track.way() - (1.0 - share(10.0 * kOneDegree)) * track.last_step_length();
        if (passes(90.0 * kOneDegree)) {
            out.advance = track.forward_displacement(share(90.0 * kOneDegree));
            out.transfer = side * track.lateral_displacement(share(90.0 * kOneDegree));
            out.time90 = time(90.0 * kOneDegree);
        }
        if (passes(180.0 * kOneDegree)) {
            out.tactical = side * track.lateral_displacement(share(180.0 * kOneDegree));
            out.time180 = time(180.0 * kOneDegree);
            out.turned = true;
        }
        out.most_roll = std::max(out.most_roll, std::abs(track.roll()));
        before = std::max(before, now);
    }
    out.speed = world.system_signal(name + "speed");
    out.turn_rate = world.system_signal(name + "turn_rate");
    out.drift = world.system_signal(name + "drift");
    out.roll = track.roll();
    return out;
}

ZigZagTrial zig_zag(World& world, const VesselDef& vessel, double rudder, double heading, int count,
                    double most) {
    const std::string name = vessel.name + ".rudder";
    Track track(world, vessel);
    ZigZagTrial out;
    const double begin = world.time();
    double order = rudder, before = 0.0, peak = 0.0;
    bool executed = false;
    world.set_system_signal(name, order);
    while (static_cast<int>(out.overshoots.size()) < count && world.time() - begin < most) {
        const double from = world.time() - begin;
        step_trial(world);
        track.step();
        // Heading change towards the side of the previous order.
        const double side = order < 0.0 ? -1.0 : 1.0;
        const double now = track.heading();
        out.most_roll = std::max(out.most_roll, std::abs(track.roll()));
        if (executed) {
            // The heading overshoots until the ship responds to the order.
            if (-side * now > peak) {
                peak = -side * now;
            } else if (-side * now < peak - 1e-6) {
                out.overshoots.push_back(peak - heading);
                executed = false;
            }
        }
        // The order is given in the step whose end is nearest to the crossing.
        const double soon = now + 0.5 * (now - before);
        if (!executed && side * soon >= heading && side * before < heading) {
            const double share = (heading - side * before) / (side * (now - before));
            out.executes.push_back(from + share * (world.time() - begin - from));
            order = -order;
            peak = side * now;
            executed = true;
            world.set_system_signal(name, order);
        }
        before = now;
    }
    return out;
}

std::vector<ImoCriterion> imo_criteria(double length, double speed, const TurningCircle& turn,
                                       const ZigZagTrial& small, const ZigZagTrial& large) {
    std::vector<ImoCriterion> out;
    const auto degrees = [](double x) { return x / kOneDegree; };
    if (turn.turned) {
        out.push_back({"advance", turn.advance / length, 4.5, "L"});
        out.push_back({"tactical diameter", turn.tactical / length, 5.0, "L"});
    }
    // The criterion depends on the time in which the ship moves by its length.
    const double t = length / speed;
    const double first = t < 10.0 ? 10.0 : t >= 30.0 ? 20.0 : 5.0 + 0.5 * t;
    const double second = t < 10.0 ? 25.0 : t >= 30.0 ? 40.0 : 17.5 + 0.75 * t;
    if (!small.overshoots.empty())
        out.push_back({"10/10 first overshoot", degrees(small.overshoots[0]), first, "deg"});
    if (small.overshoots.size() > 1)
        out.push_back({"10/10 second overshoot", degrees(small.overshoots[1]), second, "deg"});
    if (!large.overshoots.empty())
        out.push_back({"20/20 first overshoot", degrees(large.overshoots[0]), 25.0, "deg"});
    return out;
}

}  // namespace hawser
