// SPDX-License-Identifier: Apache-2.0
/// Cranes of a scene. Their parts become bodies and interactions, which inputs, outputs and cables
/// find by name. Their drives are added after the world is built.
#include "scene/cranes.h"

#include "scene/field_reader.h"

#include "scene/deck.h"
#include "scene/description.h"
#include "scene/timeline.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

template <class T>
void read_crane_part(T& out, const Json& json) {
    using Table = CraneTable<T>;
    read_fields(out, json, Table::kNumbers);
    for (const CranePoint<T>& p : std::span(Table::kPoints).first(Table::kPointCount))
        out.*p.value = vector_or(json, p.key, out.*p.value);
}

void read_tackle(CraneTackle& out, const Json& json) {
    read_crane_part(out, json);
    out.falls = json["falls"].get<int>();
}

CraneRating read_rating(const Json& json) {
    CraneRating rating;
    read_crane_part(rating, json);
    for (const Json& point : json["curve"])
        rating.curve.push_back({point[0].get<double>(), point[1].get<double>()});
    if (const auto cut = json.find("cut_out"); cut != json.end()) rating.cut_out = cut->get<bool>();
    return rating;
}

CraneLoad read_load(Description& out, const Scope& scope, const Json& json,
                    const SourceLocation& location) {
    CraneLoad load;
    load.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    read_crane_part(load, json);
    if (const auto eyes = json.find("eyes"); eyes != json.end())
        for (const Json& eye : *eyes) load.eyes.push_back(vector_of(eye));
    else
        load.eyes.push_back(Vec3::Zero());
    return load;
}

/// Return the number of the load that a crane carries at the start; 0: none.
int first_load(const Description& out, const Scope& scope, const std::vector<CraneLoad>& loads,
               const Json& json, const SourceLocation& location) {
    const auto take = json.find("take");
    if (take == json.end()) return 0;
    const std::string name = take->get<std::string>();
    std::vector<std::string> known;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const std::string& full = out.body(loads[i].body).name;
        if (full == scope.prefix + name) return static_cast<int>(i) + 1;
        known.push_back(full.starts_with(scope.prefix) ? full.substr(scope.prefix.size()) : full);
    }
    throw_error(location / "take",
                "none of its loads is the body " + in_quotes(name) + suggestion(name, known));
}

template <class Def>
void read_common(Def& def, Description& out, const Scope& scope, const Json& json,
                 const SourceLocation& location) {
    def.name = scope.prefix + json["name"].get<std::string>();
    def.mount.on = resolve_body(out, scope, json["on"].get<std::string>(), location / "on");
    def.mount.point = vector_or(json, "point", def.mount.point);
    def.mount.orientation = orientation_of(json, location).normalized();
    read_crane_part(def, json);
    read_crane_part(def.slew, json["slew"]);
    read_crane_part(def.column, json["column"]);
    read_crane_part(def.boom, json["boom"]);
    read_tackle(def.hoist, json["hoist"]);
    read_crane_part(def.hook, json["hook"]);
    if (const auto rating = json.find("rating"); rating != json.end())
        def.rating = read_rating(*rating);
    read_loads(out, scope, json, location, def.loads, def.take);
}

/// Adds parts to the lists of a scene.
class SceneSite final : public CraneSite {
  public:
    SceneSite(Description& out, int at) : out_(out), at_(at) {}
    ~SceneSite() = default;
    BodyId add(const BodyDef& def) override { return out_.add_body(def, at_); }
    InteractionId add(const InteractionDef& def) override { return out_.add_interaction(def, at_); }
    [[nodiscard]] CraneBody find(BodyId id) const override {
        const BodyDef& b = out_.body(id);
        return {{b.position, b.orientation.normalized()},
                {b.velocity, b.angular_velocity},
                b.kind,
                b.mass};
    }
    [[nodiscard]] Vec3 gravity() const override { return out_.settings.gravity; }

  private:
    Description& out_;
    int at_;
};

/// Throw an error of a crane definition at its position in the scene. Field names of the library
/// (mount/point, boom_angle [rad]) are converted to those of the scene (point, boom_angle_deg).
[[noreturn]] void throw_crane_error(const SourceLocation& location, const DefError& error) {
    FieldWords said = field_words(error);
    constexpr std::string_view kMountPath = "mount/";
    if (said.path.starts_with(kMountPath)) said.path = said.path.substr(kMountPath.size());
    if (said.path == "orientation") said.path = "euler_deg";
    if (said.path.ends_with("angle")) said.path += "_deg";
    throw_field_error(location, said);
}

void read_crane(Description& out, const Scope& scope, const Json& json,
                const SourceLocation& location) {
    Crane crane;
    if (json["kind"] == "lattice") {
        LatticeCraneDef& def = crane.def.emplace<LatticeCraneDef>();
        read_common(def, out, scope, json, location);
        read_tackle(def.luffing, json["luffing"]);
    } else {
        KnuckleCraneDef& def = crane.def.emplace<KnuckleCraneDef>();
        read_common(def, out, scope, json, location);
        read_crane_part(def.boom_cylinder, json["boom_cylinder"]);
        read_crane_part(def.jib, json["jib"]);
        read_crane_part(def.jib_cylinder, json["jib_cylinder"]);
    }
    crane.location = out.store_location(location);
    try {
        SceneSite site(out, crane.location);
        std::visit([&](const auto& def) { build_crane(site, def); }, crane.def);
    } catch (const DefError& error) {
        throw_crane_error(location, error);
    }
    out.cranes.push_back(std::move(crane));
}

}  // namespace

void expand_cranes(Description& out, const Scope& scope) {
    const auto list = scope.content->find("cranes");
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const bool made = attempt(
            out.mistakes, [&] { read_crane(out, scope, json, scope.location / "cranes" / i); });
        if (made) continue;
        for (const OmittedPart what : {OmittedPart::body, OmittedPart::interaction})
            out.mistakes->record_omitted(what, scope.prefix + json["name"].get<std::string>());
    }
}

void read_loads(Description& out, const Scope& scope, const Json& json,
                const SourceLocation& location, std::vector<CraneLoad>& loads, int& take) {
    if (const auto list = json.find("loads"); list != json.end())
        for (std::size_t i = 0; i < list->size(); ++i)
            loads.push_back(read_load(out, scope, (*list)[i], location / "loads" / i));
    take = first_load(out, scope, loads, json, location);
}

InputWords loads_by_word(const Description& description) {
    InputWords words;
    for (const auto& hook : description.deck.hooks)
        for (const CraneLoad& load : hook.def.loads)
            words[hook.def.name + ".take"].push_back(description.body(load.body).name);
    for (const Crane& crane : description.cranes)
        std::visit(
            [&](const auto& def) {
                std::vector<std::string>& known = words[def.name + ".take"];
                for (const CraneLoad& load : def.loads)
                    known.push_back(description.body(load.body).name);
            },
            crane.def);
    return words;
}

}  // namespace hawser::scene
