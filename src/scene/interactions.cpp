// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

#include <fmt/format.h>

#include <cmath>

namespace hawser::scene {
namespace {

/// Largest distance of a node from its point of attachment [m]. It allows for coordinates with six
/// decimals.
constexpr double kNodeTolerance = 2e-6;

/// True if the kind connects two points that the scene must define. A joint's point has no default.
bool needs_points(const KindInfo& kind) {
    return kind.uses_points && kind.bodies == 2 && kind.rows >= 3;
}

/// True if the kind requires an axis. All kinds with frames do, except the lock, which keeps the
/// orientations of the bodies, and the span, which has axes only at wheels.
bool needs_axis(const KindInfo& kind) {
    return kind.uses_frames && !kind.is(kAxisFree) && !kind.is(kRouted);
}

/// True if the rows are rigid by default, unlike those of motors and springs.
bool is_constraint(const KindInfo& kind) {
    if (std::string_view(kind.row_units).find('v') != std::string_view::npos) {
        return false;
    }
    for (const ParamInfo& param : kind.params) {
        if (param.unit[0] == 'N') {
            return false;  // A stiffness: the compliance follows from it.
        }
    }
    return true;
}

Quat with_z_along(const Vec3& direction) {
    // Rotate about the shortest arc from z; for −z by half a turn about x.
    const Vec3 z = direction.normalized();
    const double w = 1.0 + z.z();
    if (w < 1e-9) {
        return Quat(0.0, 1.0, 0.0, 0.0);
    }
    return Quat(w, -z.y(), z.x(), 0.0).normalized();
}

Vec3 world_direction(const Json& value, const Scope& scope, const SourceLocation& location) {
    const Vec3 axis = vector_of(value);
    if (!(axis.norm() > 1e-9)) {
        throw_error(location, "a direction must not be zero");
    }
    return scope.frame.direction(axis);
}

/// Reads one interaction from JSON to InteractionDef.
class Reader {
  public:
    Reader(Description& out, const Scope& scope, const Json& json, SourceLocation location)
        : out_(out),
          scope_(scope),
          json_(json),
          location_(std::move(location)),
          kind_(*find_kind(json["kind"].get_ref<const std::string&>())) {}

    InteractionDef read() {
        def_.kind = kind_.kind;
        if (json_.contains("name")) {
            def_.name = scope_.prefix + json_["name"].get<std::string>();
        }
        read_bodies();
        if (kind_.uses_points) {
            read_points();
        }
        if (kind_.uses_frames) {
            read_frames();
        }
        read_rows("compliance", def_.compliance, out_.default_compliance);
        read_rows("damping_time", def_.damping_time, out_.default_damping_time);
        read_params();
        read_loads();
        return def_;
    }

  private:
    void read_bodies() {
        const Json& names = json_["bodies"];
        for (std::size_t i = 0; i < names.size(); ++i) {
            const SourceLocation at = location_ / "bodies" / i;
            def_.body[i] = resolve_body(out_, scope_, names[i].get<std::string>(), at);
            for (std::size_t j = 0; j < i; ++j) {
                if (def_.body[j] == def_.body[i]) {
                    throw_error(at, "the body " + describe(names[i]) + " is named twice");
                }
            }
        }
    }

    void read_points() {
        const bool at = json_.contains("at");
        const bool points = json_.contains("points");
        if (needs_points(kind_) && !at && !points) {
            throw_error(location_, std::string("a ") + kind_.name +
                                       " needs \"at\" (a world point) or \"points\" (one a body)");
        }
        for (std::size_t i = 0; i < bodies(); ++i) {
            const BodyDef& body = out_.body(def_.body[i]);
            if (body.kind == BodyKind::scalar) {
                continue;  // A scalar body has no position.
            }
            const SourceLocation where = at ? location_ / "at" : location_ / "points" / i;
            if (at) {
                const Vec3 world = scope_.frame.point(vector_of(json_["at"]));
                def_.point[i] = body.orientation.conjugate() * (world - body.position);
            } else if (points) {
                def_.point[i] = vector_of(json_["points"][i]);
            }
            if (body.kind == BodyKind::lump) {
                if (def_.point[i].norm() > kNodeTolerance) {
                    throw_error(where,
                                fmt::format("the point mass {} is {:.6g} m away from this point; "
                                            "attach it at its position",
                                            in_quotes(body.name), def_.point[i].norm()));
                }
                def_.point[i].setZero();
            }
        }
    }

    void read_frames() {
        if (const auto frames = json_.find("frames"); frames != json_.end()) {
            for (std::size_t i = 0; i < bodies(); ++i) {
                def_.frame[i] = quaternion_of((*frames)[i], location_ / "frames" / i);
            }
            return;
        }
        const bool axis = json_.contains("axis");
        const bool axes = json_.contains("axes");
        if (needs_axis(kind_) && !axis && !axes) {
            throw_error(location_,
                        std::string("a ") + kind_.name +
                            " needs \"axis\" (a world direction), \"axes\" (one a body) or "
                            "\"frames\"");
        }
        if (axis && kind_.is(kTwoAxes)) {
            throw_error(location_ / "axis",
                        "the two axes of a universal joint differ; give \"axes\", one a body");
        }
        for (std::size_t i = 0; i < bodies(); ++i) {
            Quat world = scope_.frame.orientation;
            if (axis) {
                world = with_z_along(world_direction(json_["axis"], scope_, location_ / "axis"));
            } else if (axes) {
                world =
                    with_z_along(world_direction(json_["axes"][i], scope_, location_ / "axes" / i));
            }
            def_.frame[i] = (out_.body(def_.body[i]).orientation.conjugate() * world).normalized();
        }
    }

    void read_rows(const char* key, std::array<double, kMaxInteractionRows>& rows,
                   double fallback) {
        const auto value = json_.find(key);
        for (std::size_t r = 0; r < static_cast<std::size_t>(kind_.rows); ++r) {
            if (value == json_.end()) {
                rows[r] = is_constraint(kind_) ? fallback : kDefault;
            } else {
                rows[r] = value->is_array() ? (*value)[r].get<double>() : value->get<double>();
            }
        }
    }

    void read_params() {
        for (std::size_t p = 0; p < kind_.params.size(); ++p) {
            const char* name = kind_.params[p].name;
            if (json_.contains(name)) {
                def_.params[p] = json_[name].get<double>();
            } else if (is_taken_from_pose(kind_, name)) {
                def_.params[p] = value_of_pose(name);
            }
        }
        if (json_.contains("min") && json_.contains("max") &&
            json_["min"].get<double>() > json_["max"].get<double>()) {
            throw_error(location_ / "min", "must not be greater than \"max\"");
        }
    }

    void read_loads() {
        const auto list = json_.find("loads");
        if (list == json_.end()) {
            return;
        }
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Json& load = (*list)[i];
            def_.load[i].interaction =
                resolve_interaction(out_, scope_, load["interaction"].get<std::string>(),
                                    location_ / "loads" / i / "interaction");
            def_.load[i].factor = load["factor"].get<double>();
        }
    }

    /// Compute the default of a parameter from the poses in the scene's text. A stored state does
    /// not change it.
    double value_of_pose(std::string_view param) {
        if (param == "rest_height") {
            return out_.body(def_.body[0]).position.z();
        }
        if (param == "target") {
            return out_.body(def_.body[0]).position.x();
        }
        const double length = (out_.world_point(def_.body[1], def_.point[1]) -
                               out_.world_point(def_.body[0], def_.point[0]))
                                  .norm();
        // Least length that the kinds accept.
        if (length < 1e-9) {
            throw_error(location_, "the two points coincide; give \"length\"");
        }
        return length;
    }

    [[nodiscard]] std::size_t bodies() const { return static_cast<std::size_t>(kind_.bodies); }

    Description& out_;
    const Scope& scope_;
    const Json& json_;
    SourceLocation location_;
    const KindInfo& kind_;
    InteractionDef def_;
};

}  // namespace

void expand_interactions(Description& out, const Scope& scope) {
    const auto list = scope.content->find("interactions");
    if (list == scope.content->end()) {
        return;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) {
            continue;  // Left out: mistakes.h.
        }
        const SourceLocation location = scope.location / "interactions" / i;
        const bool read = attempt(out.mistakes, [&] {
            InteractionDef def = Reader(out, scope, json, location).read();
            out.add_interaction(std::move(def), out.store_location(location));
        });
        if (!read && json.contains("name")) {
            out.mistakes->record_omitted(OmittedPart::interaction,
                                         scope.prefix + json["name"].get<std::string>());
        }
    }
}

}  // namespace hawser::scene
