// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

namespace hawser::scene {
namespace {

/// One use of a template with its parameters put in; owns its content.
struct InstanceScope {
    Scope scope;
    std::unique_ptr<Json> content;
    std::string note;  ///< Ending of messages about it.
};

/// Run `work`; a mistake found in it says in which instance it showed.
template <class Work>
void with_note(const std::string& note, const Work& work) {
    if (note.empty()) {
        work();
        return;
    }
    try {
        work();
    } catch (const SceneError& error) {
        throw SceneError(error.file, error.path, error.message + note);
    }
}

class Expander {
  public:
    Expander(Description& out, const Document& document) : out_(out), document_(document) {}

    void run() {
        InstanceScope root;
        root.scope.content = &document_.root;
        root.scope.place = document_.place;
        add_bodies(std::move(root), 0);
        for (const InstanceScope& item : scopes_) {
            with_note(item.note, [&] {
                expand_segments(out_, item.scope);
                expand_interactions(out_, item.scope);
                expand_inputs(out_, item.scope);
            });
        }
    }

  private:
    static constexpr std::size_t kMaxInstances = 100'000;

    void add_bodies(InstanceScope item, int depth) {
        const std::size_t index = scopes_.size();
        scopes_.push_back(std::move(item));
        // A copy: the list of scopes grows below.
        const Scope scope = scopes_[index].scope;
        const std::string note = scopes_[index].note;
        with_note(note, [&] { expand_bodies(out_, scope); });
        if (const auto list = scope.content->find("instances"); list != scope.content->end()) {
            for (std::size_t i = 0; i < list->size(); ++i) {
                InstanceScope inner;
                with_note(note, [&] {
                    inner = open((*list)[i], scope, depth, scope.place / "instances" / i);
                });
                open_.push_back((*list)[i]["template"].get<std::string>());
                add_bodies(std::move(inner), depth + 1);
                open_.pop_back();
            }
        }
        with_note(note, [&] { add_cables(scope); });
    }

    void add_cables(const Scope& scope) {
        const auto list = scope.content->find("cables");
        if (list == scope.content->end()) {
            return;
        }
        for (std::size_t i = 0; i < list->size(); ++i) {
            expand_cable(out_, scope, scope, (*list)[i], document_, scope.place / "cables" / i);
        }
    }

    InstanceScope open(const Json& instance, const Scope& outer, int depth, const Place& place) {
        const auto& name = instance["template"].get_ref<const std::string&>();
        const Json& definition = find_template(name, place / "template");
        if (std::find(open_.begin(), open_.end(), name) != open_.end()) {
            refuse(place / "template",
                   "the template " + in_quotes(name) + " uses itself, directly or through others");
        }
        if (depth >= kMaxInstanceDepth) {
            refuse(place, fmt::format("templates are nested more than {} deep", kMaxInstanceDepth));
        }
        if (scopes_.size() >= kMaxInstances) {
            refuse(place, fmt::format("the scene has more than {} instances", kMaxInstances));
        }
        InstanceScope inner;
        Scope& scope = inner.scope;
        scope.prefix = outer.prefix + instance["name"].get<std::string>() + "/";
        if (!prefixes_.insert(scope.prefix).second) {
            refuse(place / "name",
                   "the instance " + describe(instance["name"]) + " exists already");
        }
        const auto elsewhere = document_.templates.find(name);
        scope.place = elsewhere != document_.templates.end() ? elsewhere->second
                                                             : document_.place / "templates" / name;
        inner.note = fmt::format(" (in the instance {})",
                                 in_quotes(scope.prefix.substr(0, scope.prefix.size() - 1)));
        inner.content =
            std::make_unique<Json>(fill_in(definition, instance, scope.place, place, inner.note));
        scope.content = inner.content.get();
        set_frame(scope, instance, outer, place);
        bind(scope, instance, outer, place);
        return inner;
    }

    const Json& find_template(const std::string& name, const Place& place) {
        std::vector<std::string> known;
        if (const auto all = document_.root.find("templates"); all != document_.root.end()) {
            if (const auto entry = all->find(name); entry != all->end()) {
                return *entry;
            }
            for (const auto& [key, value] : all->items()) {
                known.push_back(key);
            }
        }
        refuse(place, "there is no template " + in_quotes(name) + suggestion(name, known));
    }

    /// The lists of the template with parameters in place, checked again.
    static Json fill_in(const Json& definition, const Json& instance, const Place& template_place,
                        const Place& instance_place, const std::string& note) {
        Json parameters = definition.value("parameters", Json::object());
        if (const auto given = instance.find("parameters"); given != instance.end()) {
            std::vector<std::string> known;
            for (const auto& [key, value] : parameters.items()) {
                known.push_back(key);
            }
            for (const auto& [key, value] : given->items()) {
                const Place at = instance_place / "parameters" / key;
                if (!parameters.contains(key)) {
                    refuse(at, "the template has no parameter " + in_quotes(key) +
                                   suggestion(key, known));
                }
                const Json& fallback = parameters[key];
                const bool same =
                    fallback.is_number() ? value.is_number() : fallback.type() == value.type();
                if (!same) {
                    refuse(at, "expected a value like the default " + describe(fallback) +
                                   ", found " + describe(value));
                }
                parameters[key] = value;
            }
        }
        Json content = Json::object();
        const Format& f = format();
        const std::pair<const char*, const Shape*> lists[] = {
            {"bodies", f.bodies.get()},
            {"instances", f.instances.get()},
            {"cables", f.cables.get()},
            {"interactions", f.interactions.get()},
            {"inputs", f.inputs.get()}};
        with_note(note, [&] {
            for (const auto& [key, shape] : lists) {
                if (definition.contains(key)) {
                    const Place at = template_place / key;
                    content[key] = substitute(definition[key], parameters, at);
                    check_shape(content[key], *shape, at);
                }
            }
        });
        return content;
    }

    void set_frame(Scope& scope, const Json& instance, const Scope& outer, const Place& place) {
        Frame base = outer.frame;
        if (instance.contains("on")) {
            const BodyId on =
                resolve_body(out_, outer, instance["on"].get<std::string>(), place / "on");
            if (out_.body(on).kind == BodyKind::scalar) {
                refuse(place / "on", "a scalar body has no place");
            }
            base = out_.frame_of(on);
        }
        Frame& frame = scope.frame;
        frame.position = base.point(vector_or(instance, "position", Vec3::Zero()));
        frame.orientation = (base.orientation * orientation_of(instance, place)).normalized();
        frame.velocity = base.velocity_at(frame.position);
        frame.angular_velocity = base.angular_velocity;
    }

    void bind(Scope& scope, const Json& instance, const Scope& outer, const Place& place) {
        const auto names = instance.find("bind");
        if (names == instance.end()) {
            return;
        }
        for (const auto& [local, value] : names->items()) {
            const Place at = place / "bind" / local;
            if (local == "world") {
                refuse(at, "the name \"world\" always stands for the world");
            }
            const BodyId id = resolve_body(out_, outer, value.get<std::string>(), at);
            scope.bound.emplace(local, out_.body(id).name);
        }
    }

    Description& out_;
    const Document& document_;
    std::vector<InstanceScope> scopes_;
    std::vector<std::string> open_;  ///< Templates being expanded, outermost first.
    std::set<std::string> prefixes_;
};

Nonsmooth nonsmooth_from(const std::string& word) {
    return word == "pivoting" ? Nonsmooth::pivoting
           : word == "split"  ? Nonsmooth::split
           : word == "pgs"    ? Nonsmooth::pgs
           : word == "convex" ? Nonsmooth::convex
                              : Nonsmooth::newton;
}

Coupling coupling_from(const std::string& word) {
    return word == "kinematic"   ? Coupling::kinematic
           : word == "compliant" ? Coupling::compliant
           : word == "deadline"  ? Coupling::deadline
                                 : Coupling::exact;
}

Predictor predictor_from(const std::string& word) {
    return word == "forces"   ? Predictor::forces
           : word == "clique" ? Predictor::clique
                              : Predictor::hold;
}

void read_settings(Description& out, const Json& root) {
    const Json settings = root.value("settings", Json::object());
    WorldDef& def = out.settings;
    def.step = number_or(settings, "step", def.step);
    def.gravity = vector_or(settings, "gravity", def.gravity);
    const std::string form = text_or(settings, "form", "auto");
    def.form = form == "saddle"      ? Form::saddle
               : form == "condensed" ? Form::condensed
                                     : Form::automatic;
    def.geometric_stiffness = number_or(settings, "geometric_stiffness", def.geometric_stiffness);
    def.rotation_damping = number_or(settings, "rotation_damping", def.rotation_damping);
    def.staggered_start = settings.value("staggered_start", def.staggered_start);
    def.contact_margin = number_or(settings, "contact_margin", def.contact_margin);
    def.sleep_after = number_or(settings, "sleep_after", def.sleep_after);
    def.sleep_speed = number_or(settings, "sleep_speed", def.sleep_speed);
    def.nonsmooth = nonsmooth_from(text_or(settings, "nonsmooth", "newton"));
    def.coupling = coupling_from(text_or(settings, "coupling", "exact"));
    def.predictor = predictor_from(text_or(settings, "predictor", "hold"));
    if (settings.contains("parts")) out.parts = settings["parts"].get<int>();
    def.regroup_every = settings.value("regroup_every", def.regroup_every);
    def.contact_tolerance = number_or(settings, "contact_tolerance", def.contact_tolerance);
    def.contact_iterations = settings.value("contact_iterations", def.contact_iterations);
    def.nonsmooth_sweeps = settings.value("nonsmooth_sweeps", def.nonsmooth_sweeps);
    def.refinements = settings.value("refinements", def.refinements);
    def.solution_tolerance = number_or(settings, "solution_tolerance", def.solution_tolerance);
    def.max_bodies = settings.value("max_bodies", std::int32_t{kMaxElements});
    def.max_interactions = settings.value("max_interactions", std::int32_t{2 * kMaxElements});
    def.max_contacts = settings.value("max_contacts", def.max_contacts);
    def.max_memory = number_or(settings, "max_memory", def.max_memory);
    out.duration = number_or(settings, "duration", out.duration);
    out.copies = root.contains("repeat") ? root["repeat"].value("copies", std::size_t{1}) : 1;
    const Json defaults = root.value("defaults", Json::object());
    out.default_compliance = number_or(defaults, "compliance", kDefault);
    out.default_damping_time = number_or(defaults, "damping_time", kDefault);
}

}  // namespace

void expand(Description& out, const Document& document) {
    read_settings(out, document.root);
    expand_materials(out, document);
    Expander(out, document).run();
    out.check_groups();
    apply_state(out, document);
    expand_copies(out, document);
}

}  // namespace hawser::scene
