// SPDX-License-Identifier: Apache-2.0
#include "random_cases.h"

#include "dice.h"

#include <hawser/math.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hawser::bench {
namespace {

using CaseJson = nlohmann::ordered_json;

constexpr double kCaseGravity = 9.81;

CaseJson list(const Vec3& v) { return CaseJson::array({v.x(), v.y(), v.z()}); }

/// Data of a body for later ones.
struct Placed {
    std::string name;
    Vec3 position;
    Quat orientation;
    Vec3 half;  ///< Half sizes [m].
    double mass = 0.0;
    [[nodiscard]] double size() const { return 2.0 * half.maxCoeff(); }
    [[nodiscard]] Vec3 local(const Vec3& world) const {
        return orientation.conjugate() * (world - position);
    }
    [[nodiscard]] Vec3 surface(Dice& dice) const {
        Vec3 p = dice.vector(1.0);
        p[dice.number(0, 2)] = dice.chance(0.5) ? 1.0 : -1.0;
        return position + orientation * half.cwiseProduct(p);
    }
};

struct Jointed {
    int a = 0, b = 0;
    std::string kind;
    Vec3 at, axis;
};

constexpr std::array<const char*, 7> kJoints{"ball",      "hinge", "prismatic", "cylindrical",
                                             "universal", "lock",  "distance"};

bool holds_point(const std::string& kind) {
    return kind == "ball" || kind == "hinge" || kind == "universal" || kind == "lock";
}

class Maker {
  public:
    Maker(std::uint64_t seed, std::uint64_t number) : dice_(seed, number) {
        result_.step = dice_.spread(1.0 / 240.0, 0.2);
        result_.repeated = dice_.chance(0.3);
        result_.contradictory = dice_.chance(0.25);
        result_.wires = dice_.chance(0.3);
        result_.extreme = dice_.chance(0.3);
        result_.loops = dice_.chance(0.4);
        doc_ = {{"version", 1}, {"name", fmt::format("random_{}_{}", seed, number)}};
        doc_["settings"] = {{"step", result_.step}, {"duration", 1.0}};
        for (const char* key : {"bodies", "interactions", "cables"}) doc_[key] = CaseJson::array();
        make_bodies();
        // Later choices depend on existing joints: additional ones come last.
        if (result_.loops) close_loops();
        if (result_.repeated) repeat_joints();
        if (result_.contradictory) add_inconsistent_joints();
        if (result_.wires) hang_wires();
        if (result_.extreme && !masses_) add_stiff_springs();
        if (doc_["cables"].empty()) doc_.erase("cables");
        result_.text = doc_.dump(1);
    }
    RandomCase take() { return std::move(result_); }

  private:
    Dice dice_;
    RandomCase result_;
    CaseJson doc_;
    std::vector<Placed> bodies_;
    std::vector<Jointed> joints_;
    bool grounded_ = false;  ///< Body 0 is fixed.
    bool masses_ = false;    ///< True if the extreme is a ratio of masses.

    void make_bodies() {
        grounded_ = dice_.chance(0.7);
        masses_ = result_.extreme && dice_.chance(0.5);
        const int count = dice_.number(masses_ ? 3 : 2, 10);
        // Large steps go with large bodies: a body on an arm of half their size rotates by about
        // 0.15 rad per step, links of whipping chains by more.
        const double least = 1000.0 * result_.step * result_.step;
        const double scale = std::max(dice_.spread(0.3, 3.0), least * dice_.from(1.0, 2.0));
        // A floating tree starts as one rigid body, which all joints allow.
        const Vec3 spin = grounded_ ? Vec3(Vec3::Zero()) : dice_.vector(2.0);
        const Vec3 speed = grounded_ ? Vec3(Vec3::Zero()) : dice_.vector(2.0);
        const double lightest = masses_ ? dice_.spread(0.01, 10.0) : 0.0;
        for (int i = 0; i < count; ++i) {
            Placed body{.name = fmt::format("b{}", i),
                        .position = Vec3::Zero(),
                        .orientation = dice_.turn(),
                        .half = scale * Vec3(dice_.from(0.1, 0.5), dice_.from(0.1, 0.5),
                                             dice_.from(0.1, 0.5))};
            const double volume = 8.0 * body.half.prod();
            body.mass = dice_.from(300.0, 8000.0) * volume;
            if (masses_ && i > 0)
                body.mass = i + 1 == count ? lightest * dice_.spread(1.1e6, 1e8)
                            : i == 1       ? lightest
                                           : lightest * dice_.spread(1.0, 1e6);
            Vec3 at = Vec3::Zero();
            const int parent = i > 0 ? dice_.number(std::max(0, i - 3), i - 1) : 0;
            if (i > 0) {
                at = bodies_[static_cast<std::size_t>(parent)].surface(dice_);
                body.position = at + dice_.direction() * body.half.norm();
            }
            bodies_.push_back(body);
            if (i > 0) join(parent, i, kJoints[static_cast<std::size_t>(dice_.number(0, 6))], at);
        }
        for (std::size_t i = 0; i < bodies_.size(); ++i) write_body(i, speed, spin);
    }

    void write_body(std::size_t i, const Vec3& speed, const Vec3& spin) {
        const Placed& b = bodies_[i];
        const Quat& q = b.orientation;
        CaseJson body{{"name", b.name}, {"position", list(b.position)}};
        body["orientation"] = CaseJson::array({q.w(), q.x(), q.y(), q.z()});
        if (i == 0 && grounded_) {
            body["kind"] = "fixed";
        } else {
            body["mass"] = b.mass;
            body["box"] = list(b.half);
            body["velocity"] = list(speed + spin.cross(b.position));
            body["angular_velocity"] = list(spin);
        }
        doc_["bodies"].push_back(std::move(body));
    }

    /// Add a joint that fits the initial poses of the bodies.
    void join(int a, int b, const std::string& kind, const Vec3& at) {
        join(Jointed{a, b, kind, at, dice_.direction()});
    }
    void join(const Jointed& j) {
        const Placed &a = body(j.a), &b = body(j.b);
        CaseJson joint = start_joint(j.kind, a, b);
        if (j.kind == "distance") {
            // From the far side of one body to the joint's position on the other.
            joint["points"] = CaseJson::array({list(-a.local(j.at)), list(b.local(j.at))});
        } else {
            joint["at"] = list(j.at);
            if (j.kind == "universal")
                joint["axes"] = CaseJson::array({list(j.axis), list(j.axis.unitOrthogonal())});
            else if (j.kind != "ball")
                joint["axis"] = list(j.axis);
        }
        doc_["interactions"].push_back(std::move(joint));
        joints_.push_back(j);
    }

    CaseJson start_joint(const std::string& kind, const Placed& a, const Placed& b) {
        return {{"name", fmt::format("j{}", doc_["interactions"].size())},
                {"kind", kind},
                {"bodies", {a.name, b.name}}};
    }

    [[nodiscard]] const Placed& body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] int moving() {
        return dice_.number(grounded_ ? 1 : 0, static_cast<int>(bodies_.size()) - 1);
    }

    void close_loops() {
        const int last = static_cast<int>(bodies_.size()) - 1;
        result_.loops = last > 1;
        if (last < 2) return;
        for (int n = dice_.number(1, 2); n > 0; --n) {
            const int a = dice_.number(0, last - 2), b = dice_.number(a + 2, last);
            join(a, b, kJoints[static_cast<std::size_t>(dice_.number(0, 6))],
                 0.5 * (body(a).position + body(b).position));
        }
    }

    /// Add a joint twice, or again at another point of its axis.
    void repeat_joints() {
        const int count = static_cast<int>(joints_.size());
        for (int n = dice_.number(1, 3); n > 0; --n) {
            Jointed again = joints_[static_cast<std::size_t>(dice_.number(0, count - 1))];
            if (again.kind != "ball" && again.kind != "distance" && again.kind != "universal")
                again.at += dice_.from(0.0, 1.0) * body(again.b).size() * again.axis;
            join(again);
        }
    }

    /// Add inconsistent joints: beside a joint at a point another one, at distances that differ
    /// between both bodies; or two rods of different lengths between the same points.
    void add_inconsistent_joints() {
        const int count = static_cast<int>(joints_.size());
        Jointed first = joints_[static_cast<std::size_t>(dice_.number(0, count - 1))];
        const Placed &a = body(first.a), &b = body(first.b);
        const double size = std::min(a.size(), b.size());
        const double off = std::max(0.05, size * dice_.from(0.1, 1.0));
        if (dice_.chance(0.2)) {
            const double length = std::max(0.5 * size, (b.position - a.position).norm());
            for (const double longer : {0.0, off}) {
                CaseJson rod = start_joint("distance", a, b);
                rod["length"] = length + longer;
                doc_["interactions"].push_back(std::move(rod));
            }
            return;
        }
        if (!holds_point(first.kind)) {
            first.kind = dice_.chance(0.5) ? "lock" : "ball";
            join(first);
        }
        CaseJson joint = start_joint(dice_.chance(0.5) ? "ball" : "lock", a, b);
        const Vec3 one = dice_.direction(), other = dice_.direction();
        const double arm = 0.5 * size;
        joint["points"] = CaseJson::array(
            {list(a.local(first.at) + arm * one), list(b.local(first.at) + (arm + off) * other)});
        doc_["interactions"].push_back(std::move(joint));
    }

    void hang_wires() {
        for (int n = dice_.number(1, 2); n > 0; --n) {
            const int i = moving();
            const Vec3 end = body(i).surface(dice_);
            const double span = dice_.spread(1.0, 50.0);
            Vec3 up = dice_.direction();
            up.z() = std::abs(up.z());
            const double load = body(i).mass * kCaseGravity * dice_.from(0.05, 2.0);
            const double EA = load * dice_.spread(20.0, 1e4), weight = dice_.spread(0.001, 0.1);
            CaseJson line{{"mass_per_length", std::max(1e-3, weight * load / kCaseGravity / span)},
                          {"EA", EA}};
            if (dice_.chance(0.7))
                line["axial_damping"] = dice_.chance(0.3) ? 0.0 : dice_.from(0.05, 1.0);
            CaseJson wire{{"name", fmt::format("w{}", doc_["cables"].size())},
                          {"line_type", std::move(line)},
                          {"elements", dice_.number(3, 24)}};
            wire["from"] = {{"at", list(end + span * up)}};
            wire["to"] = {{"body", body(i).name}, {"point", list(body(i).local(end))}};
            // A slack wire between ends on one vertical line would lie on itself.
            if (dice_.chance(0.5) && std::hypot(up.x(), up.y()) > 0.6) {
                wire["length"] = span * dice_.from(1.01, 1.2);
                wire["shape"] = "catenary";
            } else {
                wire["length"] = span / (1.0 + load / EA);
                wire["shape"] = "straight";
            }
            doc_["cables"].push_back(std::move(wire));
        }
    }

    /// Add springs so stiff that a soft one beside them differs by 1e6.
    void add_stiff_springs() {
        const double soft = dice_.spread(10.0, 1e3);
        for (const double k : {soft, soft * dice_.spread(1.1e6, 1e8)}) {
            const int i = moving();
            Vec3 up = dice_.direction();
            const Vec3 end = body(i).surface(dice_);
            const std::string anchor = fmt::format("a{}", doc_["bodies"].size());
            doc_["bodies"].push_back({{"name", anchor},
                                      {"kind", "fixed"},
                                      {"position", list(end + dice_.from(0.5, 3.0) * up)}});
            CaseJson spring{{"name", fmt::format("s{}", doc_["interactions"].size())},
                            {"kind", "distance"},
                            {"bodies", {anchor, body(i).name}}};
            spring["points"] = CaseJson::array({list(Vec3::Zero()), list(body(i).local(end))});
            spring["compliance"] = 1.0 / k;
            if (dice_.chance(0.5)) spring["damping_time"] = 0.0;
            doc_["interactions"].push_back(std::move(spring));
        }
    }
};

}  // namespace

RandomCase make_random_case(std::uint64_t seed, std::uint64_t number) {
    return Maker(seed, number).take();
}

}  // namespace hawser::bench
