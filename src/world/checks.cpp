// SPDX-License-Identifier: Apache-2.0
#include "world/checks.h"

#include <hawser/body_fields.h>
#include <hawser/settings.h>

#include "base/dense.h"
#include "base/index.h"
#include "model/line_ends.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace hawser::world {
namespace {

void check_finite(const Where& where, const char* field, double value, double limit = 1e300) {
    if (!std::isfinite(value))
        throw_def_error(where, std::string(field) + " = " + number(value) +
                                   " is not a finite number; give one up to " + number(limit));
    if (std::abs(value) > limit)
        throw_def_error(where, std::string(field) + " = " + number(value) +
                                   " is out of range; give one up to " + number(limit));
}

void check_finite(const Where& where, const char* field, const Vec3& v, double limit = 1e300) {
    for (int i = 0; i < 3; ++i) check_finite(where, field, v[i], limit);
}

void range(const Where& where, const char* field, double value, double low, double high,
           const std::string& unit) {
    if (!(value >= low && value <= high))
        throw_def_error(where, std::string(field) + " must be " + number(low) + " to " +
                                   number(high) + unit + ", not " + number(value));
}

void unit_quaternion(const Where& where, const char* field, const Quat& q) {
    const double n = q.norm();
    if (!std::isfinite(n) || n < 0.5 || n > 2.0)
        throw_def_error(where, std::string(field) + " is not a unit quaternion (norm " + number(n) +
                                   "); give [w, x, y, z] of length 1");
}

void check_inertia(const Where& where, const Mat3& inertia) {
    for (int i = 0; i < 9; ++i) check_finite(where, "inertia", inertia(i / 3, i % 3), 1e20);
    const double scale = inertia.cwiseAbs().maxCoeff();
    if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > 1e-9 * scale)
        throw_def_error(where, "inertia is not symmetric");
    const Vec3 e = base::symmetric_eigenvalues(inertia);
    if (!(e[0] > 1e-12 * e[2]) || !(e[0] > 0.0))
        throw_def_error(
            where, "inertia is not positive definite (smallest principal moment " + number(e[0]) +
                       " kg m²); a rigid body needs three positive moments of inertia; a body "
                       "without them is a point mass (kind lump)");
    if (e[0] + e[1] < e[2] * (1.0 - 1e-6))
        throw_def_error(where, "inertia breaks the triangle inequality: no body has such moments");
}

}  // namespace

void throw_def_error(const Where& where, const std::string& what) {
    throw DefError(where.text() + ": " + what);
}

std::string number(double value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.9g", value + 0.0);  // −0 is 0
    return text.data();
}

std::string Where::text() const { return kind_ == nullptr ? *name_ : label(kind_, *name_); }

std::string label(const char* what, const std::string& name) {
    return name.empty() ? std::string(what) + " (unnamed)" : std::string(what) + " '" + name + "'";
}

void check(const WorldDef& def) {
    const std::string where = "world";
    for (const SettingInfo& s : setting_infos()) {
        const int components = s.type == SettingType::vector ? 3 : 1;
        for (int i = 0; i < components; ++i) {
            const double value = s.get(def, i);
            if (s.type == SettingType::vector) check_finite(where, s.name, value, s.max);
            if (s.type == SettingType::word && !(value < static_cast<double>(s.words.size())))
                throw_def_error(where, std::string("unknown ") + s.name);
            if (s.type == SettingType::word) continue;
            const bool plain = s.unit[0] == 0 || std::string_view(s.unit) == "1";
            range(where, s.name, value, s.min, s.max, plain ? "" : std::string(" ") + s.unit);
        }
    }
    if (def.coupling != Coupling::exact && def.sleep_after > 0.0)
        throw_def_error(
            where,
            "a coupling other than exact needs sleep_after 0: the parts of a split cannot wake "
            "each other");
    if ((def.budget > 0.0 || def.budget_work > 0.0) && def.nonsmooth != Nonsmooth::newton)
        throw_def_error(where, "a budget needs the nonsmooth method newton");
}

void check_pose(const Where& where, const Vec3& position, const Quat& orientation) {
    check_finite(where, "position", position, kMaxBodyLength);
    unit_quaternion(where, "orientation", orientation);
}

void check_velocity(const Where& where, const Vec3& linear, const Vec3& angular) {
    check_finite(where, "velocity", linear, kMaxBodySpeed);
    check_finite(where, "angular_velocity", angular, kMaxBodySpeed);
}

void check_force(const Where& where, const Vec3& force, const Vec3& torque) {
    check_finite(where, "force", force);
    check_finite(where, "torque", torque);
}

namespace {

void in_range(const Where& where, const FieldInfo<BodyDef>& row, double value) {
    check_finite(where, row.key, value, row.most);
    if (value >= row.least) return;
    const std::string key = row.key;
    throw_def_error(where, row.least == 0.0
                               ? key + " is negative"
                               : key + " = " + number(value) + " is out of range; give " +
                                     number(row.least) + " or more");
}

/// Check the members of the table, except those that only some kinds need.
void check_fields(const Where& where, const BodyDef& def) {
    for (const FieldInfo<BodyDef>& row : kBodyFields) {
        if (row.is(kMayBeMissing)) continue;
        std::visit(
            [&]<class T>(T BodyDef::* member) {
                if constexpr (std::is_same_v<T, Vec3>)
                    for (int i = 0; i < 3; ++i) in_range(where, row, (def.*member)[i]);
                else if constexpr (std::is_same_v<T, Quat>)
                    unit_quaternion(where, row.key, def.*member);
                else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)
                    in_range(where, row, static_cast<double>(def.*member));
            },
            row.member);
    }
}

}  // namespace

void check(const BodyDef& def) {
    const Where where("body", def.name);
    if (def.kind > BodyKind::kinematic) throw_def_error(where, "unknown kind");
    check_fields(where, def);
    const bool moves =
        def.kind == BodyKind::rigid || def.kind == BodyKind::lump || def.kind == BodyKind::scalar;
    if (!moves) return;
    check_finite(where, "mass", def.mass, kMaxBodyMass);
    if (!(def.mass > 0.0))
        throw_def_error(where,
                        "mass = " + number(def.mass) +
                            " kg; a moving body needs a positive mass (a body that does not move "
                            "is 'fixed' or 'kinematic')");
    if (def.mass < 1e-12) throw_def_error(where, "mass is below 1e-12 kg");
    if (def.kind == BodyKind::rigid) check_inertia(where, def.inertia);
}

namespace {

/// Check that the nodes of an element have at least half of its mass.
void check_mass(const InteractionDef& def, const model::Bodies& bodies) {
    const double half = 0.5 * def.params[at(kind_info(def.kind).mass_param)];
    constexpr double kRounding = 1e-9;
    for (std::size_t b = 0; half > 0.0 && b < 2; ++b) {
        const auto body = static_cast<std::size_t>(def.body[b].index);
        if (bodies.kind[body] == BodyKind::lump && bodies.mass[body] < (1.0 - kRounding) * half)
            throw_def_error(label("interaction", def.name),
                            "a node at its end has less than half of its mass");
    }
}

}  // namespace

void check(const InteractionDef& def, const model::Bodies& bodies, int count,
           std::span<const InteractionDef> before, const base::Slots& slots) {
    const Where where("interaction", def.name);
    if (static_cast<int>(def.kind) >= kInteractionKindCount) throw_def_error(where, "unknown kind");
    const KindInfo& info = kind_info(def.kind);
    bool moves = false;
    for (int b = 0; b < info.bodies; ++b) {
        const auto slot = static_cast<std::size_t>(b);
        const std::int32_t index = def.body[slot].index;
        const std::string which = "body " + std::to_string(b);
        if (index < 0 || index >= count)
            throw_def_error(where, which + " does not exist; a " + info.name + " couples " +
                                       std::to_string(info.bodies) + " bodies");
        if (!bodies.slots.names(def.body[slot]))
            throw_def_error(where, which + " has been removed");
        for (int c = 0; c < b; ++c)
            if (def.body[static_cast<std::size_t>(c)] == def.body[slot])
                throw_def_error(where, "couples a body with itself");
        const BodyKind kind = bodies.kind[static_cast<std::size_t>(index)];
        const bool scalar = kind == BodyKind::scalar;
        if (scalar != info.takes_scalar(b))
            throw_def_error(where, which +
                                       (scalar ? " is a scalar body, which a "
                                               : " must be a scalar body "
                                                 "(drum, spool) for a ") +
                                       info.name + (scalar ? " does not take there" : ""));
        // A span needs an orientation only for its wheels.
        const bool wheel = info.is(kRouted) && b < 2 && info.uses_points &&
                           std::fabs(model::wheel_at(def, static_cast<std::size_t>(b))) > 0.0;
        if (info.uses_frames && kind == BodyKind::lump && (wheel || !info.is(kRouted)))
            throw_def_error(where, which + " is a lump, which has no orientation; a " + info.name +
                                       " needs rigid bodies");
        if (info.is(kRigidOnly) && kind != BodyKind::rigid)
            throw_def_error(where, "hydrostatics act on a rigid body");
        moves = moves || model::dof_of(kind) > 0;
        check_finite(where, "point", def.point[slot], kMaxBodyLength);
        if (info.uses_frames) unit_quaternion(where, "frame", def.frame[slot]);
    }
    if (!moves) throw_def_error(where, "couples no body that moves");
    if (info.mass_param >= 0) check_mass(def, bodies);
    for (const FrictionLoad& load : def.load) {
        if (!load.interaction.valid()) continue;
        if (load.interaction.index >= static_cast<int>(before.size()))
            throw_def_error(where,
                            "its load does not exist; interactions that load it are added before");
        if (!slots.names(load.interaction)) throw_def_error(where, "its load has been removed");
        check_load(def, load, before[static_cast<std::size_t>(load.interaction.index)]);
    }
    for (int r = 0; r < info.rows; ++r) {
        const double e = def.compliance[static_cast<std::size_t>(r)];
        const double t = def.damping_time[static_cast<std::size_t>(r)];
        if (!std::isnan(e) && !(e >= 0.0 && e <= 1e12))
            throw_def_error(where, "compliance must be 0 to 1e12");
        if (!std::isnan(t) && !(t >= 0.0 && t <= 1e9))
            throw_def_error(where, "damping_time must be 0 to 1e9 s");
    }
}

void check_load(const InteractionDef& def, const FrictionLoad& load, const InteractionDef& other) {
    const Where where("interaction", def.name);
    if (!kind_info(def.kind).takes_loads)
        throw_def_error(where, std::string("a ") + kind_info(def.kind).name + " takes no loads");
    if (kind_info(other.kind).row_units[0] != 'm')
        throw_def_error(where, std::string("a ") + kind_info(other.kind).name +
                                   " carries no force that could load it");
    if (!(load.factor >= 0.0 && load.factor <= 1e6))
        throw_def_error(where, "factor of a load must be 0 to 1e6");
}

void check_params(const InteractionDef& def) {
    const Where where("interaction", def.name);
    const KindInfo& info = kind_info(def.kind);
    for (std::size_t i = 0; i < info.params.size(); ++i) {
        const ParamInfo& p = info.params[i];
        const double value = def.params[i];
        if (std::isnan(value))
            throw_def_error(where, std::string("parameter '") + p.name + "' [" + p.unit +
                                       "] of a " + info.name + " must be given");
        if (!(value >= p.min && value <= p.max))
            throw_def_error(where, std::string("parameter '") + p.name + "' = " + number(value) +
                                       " " + p.unit + " is outside " + number(p.min) + " … " +
                                       number(p.max));
    }
    for (const char* low : {"min", "force_min"}) {
        const std::string high = std::string(low) == "min" ? "max" : "force_max";
        double a = 0.0, b = 0.0;
        for (std::size_t i = 0; i < info.params.size(); ++i) {
            if (std::string(low) == info.params[i].name) a = def.params[i];
            if (high == info.params[i].name) b = def.params[i];
        }
        if (a > b) throw_def_error(where, std::string(low) + " is above " + high);
    }
}

void check_end(const std::string& where, double mass, double carried) {
    if (carried < 0.0)
        throw_def_error(
            where,
            "its drum has hauled in all wire, so that no end can be released; pay out some wire "
            "first");
    if (!(mass > 0.0))
        throw_def_error(
            where,
            "neither it nor a node has the mass of the wire at this end; give the wire more "
            "elements");
}

}  // namespace hawser::world
