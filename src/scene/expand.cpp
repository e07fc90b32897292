// SPDX-License-Identifier: Apache-2.0
#include "scene/anchors.h"
#include "scene/checks.h"
#include "scene/counts.h"
#include "scene/deck.h"
#include "scene/description.h"
#include "scene/vessels.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <span>
#include <utility>

namespace hawser::scene {
namespace {

/// One use of a template with the values of its parameters; owns its content.
struct InstanceScope {
    Scope scope;
    std::unique_ptr<Json> content;
    std::string note;  ///< Ending of messages about it.
};

/// Run `work`. If it finds a mistake, append the note, which names the instance. @return the result
/// of attempt().
template <class Work>
bool append_note(Mistakes* mistakes, const std::string& note, const Work& work) {
    if (mistakes != nullptr) {
        const std::string outer = std::exchange(mistakes->note, note);
        const bool done = attempt(mistakes, work);
        mistakes->note = outer;
        return done;
    }
    try {
        work();
        return true;
    } catch (const SceneError& error) {
        throw SceneError(error.file, error.path, error.message + note);
    }
}

class Expander {
  public:
    Expander(Description& out, const Document& document) : out_(out), document_(document) {}

    void run() {
        out_.version = document_.root.value("version", 1);
        InstanceScope root;
        root.scope.content = &document_.root;
        root.scope.location = document_.location;
        add_bodies(std::move(root), 0);
        for (const InstanceScope& item : scopes_) {
            (void)append_note(out_.mistakes, item.note, [&] {
                expand_winches(out_, item.scope);
                expand_guides(out_, item.scope);
                expand_posts(out_, item.scope);
                expand_deck(out_, item.scope);
                expand_vessels(out_, item.scope);
                expand_anchors(out_, item.scope);
                expand_routes(out_, item.scope);
                expand_segments(out_, item.scope);
                expand_interactions(out_, item.scope);
                expand_inputs(out_, item.scope);
                expand_sections(out_, item.scope);
            });
        }
        // Outputs of the scene itself may name parts of its instances.
        for (const InstanceScope& item : scopes_) {
            (void)append_note(out_.mistakes, item.note, [&] { expand_outputs(out_, item.scope); });
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
        (void)append_note(out_.mistakes, note, [&] { expand_bodies(out_, scope); });
        if (const auto list = scope.content->find("instances"); list != scope.content->end()) {
            for (std::size_t i = 0; i < list->size(); ++i) {
                InstanceScope inner;
                if ((*list)[i].is_null()) {
                    continue;  // Left out: mistakes.h.
                }
                (void)append_note(out_.mistakes, note, [&] {
                    inner = open((*list)[i], scope, depth, scope.location / "instances" / i);
                });
                if (!inner.content) {
                    omit_instance(scope.prefix + (*list)[i]["name"].get<std::string>());
                    continue;
                }
                open_.push_back((*list)[i]["template"].get<std::string>());
                add_bodies(std::move(inner), depth + 1);
                open_.pop_back();
            }
        }
        (void)append_note(out_.mistakes, note, [&] {
            expand_cranes(out_, scope);
            add_cables(scope);
        });
    }

    void add_cables(const Scope& scope) {
        const auto list = scope.content->find("cables");
        if (list == scope.content->end()) {
            return;
        }
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Json& cable = (*list)[i];
            if (cable.is_null()) {
                continue;  // Left out: mistakes.h.
            }
            const bool laid = attempt(out_.mistakes, [&] {
                expand_cable(out_, scope, scope, cable, document_, scope.location / "cables" / i);
            });
            if (!laid) {
                omit_instance(scope.prefix + cable["name"].get<std::string>());
            }
        }
    }

    /// Record that a cable or an instance was omitted because of mistakes.
    void omit_instance(const std::string& name) {
        for (const OmittedPart what :
             {OmittedPart::body, OmittedPart::interaction, OmittedPart::cable}) {
            out_.mistakes->record_omitted(what, name);
        }
    }

    InstanceScope open(const Json& instance, const Scope& outer, int depth,
                       const SourceLocation& location) {
        const auto& name = instance["template"].get_ref<const std::string&>();
        const Json& definition = find_template(name, location / "template");
        if (std::find(open_.begin(), open_.end(), name) != open_.end()) {
            throw_error(location / "template", "the template " + in_quotes(name) +
                                                   " uses itself, directly or through others");
        }
        if (depth >= kMaxInstanceDepth) {
            throw_error(location,
                        fmt::format("templates are nested more than {} deep", kMaxInstanceDepth));
        }
        if (scopes_.size() >= kMaxInstances) {
            throw_error(location,
                        fmt::format("the scene has more than {} instances", kMaxInstances));
        }
        InstanceScope inner;
        Scope& scope = inner.scope;
        scope.prefix = outer.prefix + instance["name"].get<std::string>() + "/";
        if (!prefixes_.insert(scope.prefix).second) {
            throw_error(location / "name",
                        "the instance " + describe(instance["name"]) + " exists already");
        }
        const auto elsewhere = document_.templates.find(name);
        scope.location = elsewhere != document_.templates.end()
                             ? elsewhere->second
                             : document_.location / "templates" / name;
        inner.note = fmt::format(" (in the instance {})",
                                 in_quotes(scope.prefix.substr(0, scope.prefix.size() - 1)));
        inner.content = std::make_unique<Json>(fill_in(definition, instance, inner, location));
        scope.content = inner.content.get();
        set_frame(scope, instance, outer, location);
        bind_parameters(scope, instance, outer, location);
        return inner;
    }

    const Json& find_template(const std::string& name, const SourceLocation& location) {
        std::vector<std::string> known;
        if (const auto all = document_.root.find("templates"); all != document_.root.end()) {
            if (const auto entry = all->find(name); entry != all->end()) {
                return *entry;
            }
            for (const auto& [key, value] : all->items()) {
                known.push_back(key);
            }
        }
        report_missing(out_.mistakes, OmittedPart::instance_template, name, location,
                       "there is no template " + in_quotes(name) + suggestion(name, known));
    }

    /// Return the lists of a template with the parameters of an instance inserted. The result is
    /// checked again.
    Json fill_in(const Json& definition, const Json& instance, const InstanceScope& inner,
                 const SourceLocation& instance_location) {
        Json parameters = definition.value("parameters", Json::object());
        if (const auto given = instance.find("parameters"); given != instance.end()) {
            std::vector<std::string> known;
            for (const auto& [key, value] : parameters.items()) {
                known.push_back(key);
            }
            for (const auto& [key, value] : given->items()) {
                const SourceLocation at = instance_location / "parameters" / key;
                if (!parameters.contains(key)) {
                    throw_error(at, "the template has no parameter " + in_quotes(key) +
                                        suggestion(key, known));
                }
                const Json& fallback = parameters[key];
                const bool same =
                    fallback.is_number() ? value.is_number() : fallback.type() == value.type();
                if (!same) {
                    throw_error(at, "expected a value like the default " + describe(fallback) +
                                        ", found " + describe(value));
                }
                parameters[key] = value;
            }
        }
        return filled_lists(definition, parameters, inner);
    }

    Json filled_lists(const Json& definition, const Json& parameters, const InstanceScope& inner) {
        Json content = Json::object();
        const std::span<const ListFormat> lists = list_formats();
        const bool filled = append_note(out_.mistakes, inner.note, [&] {
            for (std::size_t i = 0; i < lists.size(); ++i) {
                const char* key = lists[i].key;
                if (!definition.contains(key)) continue;
                const SourceLocation at = inner.scope.location / key;
                content[key] = substitute(definition[key], parameters, at);
                check_list(content, key, *format().lists[i], at, inner.scope.prefix, out_.mistakes);
            }
        });
        if (!filled) {
            omit_instance(inner.scope.prefix.substr(0, inner.scope.prefix.size() - 1));
        }
        return content;
    }

    void set_frame(Scope& scope, const Json& instance, const Scope& outer,
                   const SourceLocation& location) {
        Frame base = outer.frame;
        if (instance.contains("on")) {
            const BodyId on =
                resolve_body(out_, outer, instance["on"].get<std::string>(), location / "on");
            if (out_.body(on).kind == BodyKind::scalar) {
                throw_error(location / "on", "a scalar body has no position");
            }
            base = out_.frame_of(on);
        }
        Frame& frame = scope.frame;
        frame.position = base.point(vector_or(instance, "position", Vec3::Zero()));
        frame.orientation = (base.orientation * orientation_of(instance, location)).normalized();
        frame.velocity = base.velocity_at(frame.position);
        frame.angular_velocity = base.angular_velocity;
    }

    void bind_parameters(Scope& scope, const Json& instance, const Scope& outer,
                         const SourceLocation& location) {
        const auto names = instance.find("bind");
        if (names == instance.end()) {
            return;
        }
        for (const auto& [local, value] : names->items()) {
            const SourceLocation at = location / "bind" / local;
            if (local == "world") {
                throw_error(at, "the name \"world\" is reserved for the world");
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

}  // namespace

void expand(Description& out, const Document& document) {
    out.mistakes = document.mistakes;
    read_settings(out, document.root);
    // Read no further part of a document that exceeds the limits.
    if (!attempt(out.mistakes, [&] {
            check_counts(document, out.settings.max_bodies, out.settings.max_interactions);
        })) {
        for (const OmittedPart what :
             {OmittedPart::body, OmittedPart::interaction, OmittedPart::cable})
            out.mistakes->record_omitted_unnamed(what);
        return;
    }
    expand_materials(out, document);
    Expander(out, document).run();
    const bool complete = out.mistakes == nullptr || !out.mistakes->has_omitted_parts();
    if (complete) {
        out.check_groups();
    }
    // A state and copies are of a whole scene.
    if (out.mistakes == nullptr || out.mistakes->is_empty()) {
        (void)attempt(out.mistakes, [&] {
            apply_state(out, document);
            const std::size_t waters = out.waters.size();
            expand_copies(out, document);
            expand_sea(out, document, waters);
        });
    }
}

}  // namespace hawser::scene
