// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

/// Size of each list of the description in the first copy of the scene (copy 0).
struct Extent {
    std::size_t bodies, interactions, inputs, outputs, cables, shapes, winches, guides, posts,
        stoppers, pins, hooks, chasers, resolutions, cranes, levers, vessels, anchors, gauges,
        sections;
};

std::string copy_prefix(int copy) { return std::to_string(copy) + ":"; }

void rename(std::string& name, const std::string& prefix) {
    if (!name.empty()) {
        name = prefix + name;
    }
}

/// Return the stored state of a body of a copy; null if no state is stored under this name. The
/// stored state replaces the shifted state of the same body in the first copy.
const Json* stored_state(const Document& document, const std::string& name) {
    const auto state = document.root.find("state");
    if (state == document.root.end()) {
        return nullptr;
    }
    const auto entry = (*state)["bodies"].find(name);
    return entry == (*state)["bodies"].end() ? nullptr : &*entry;
}

void apply_stored_state(BodyDef& def, const Document& document) {
    const Json* state = stored_state(document, def.name);
    if (state == nullptr || def.kind == BodyKind::fixed) {
        return;
    }
    def.position = vector_of((*state)["p"]);
    def.velocity = vector_or(*state, "v", Vec3::Zero());
    if (def.kind == BodyKind::rigid || def.kind == BodyKind::kinematic) {
        def.angular_velocity = vector_or(*state, "w", Vec3::Zero());
        if (state->contains("q")) {
            def.orientation = quaternion_of((*state)["q"], document.state / def.name / "q");
        }
    }
}

class Copier {
  public:
    Copier(Description& out, const Document& document, const Json& repeat)
        : out_(out),
          document_(document),
          location_(document.location / "repeat"),
          repeat_(repeat),
          copy_offset_(vector_of(repeat["offset"])),
          first_extent_{out.bodies.size(),        out.interactions.size(), out.inputs.size(),
                        out.outputs.size(),       out.cables.size(),       out.shapes.size(),
                        out.winches.size(),       out.guides.size(),       out.posts.size(),
                        out.deck.stoppers.size(), out.deck.pins.size(),    out.deck.hooks.size(),
                        out.deck.chasers.size(),  out.resolutions.size(),  out.cranes.size(),
                        out.levers.size(),        out.vessels.size(),      out.anchors.size(),
                        out.gauges.size(),        out.sections.size()} {}

    void run(int copies) {
        const auto check = [&](std::size_t each, std::int64_t most, const char* what) {
            if (static_cast<std::int64_t>(each) * copies > most) {
                throw_error(location_, fmt::format("{} copies of {} {} are more than {}", copies,
                                                   each, what, most));
            }
        };
        check(first_extent_.bodies, out_.settings.max_bodies, "bodies (settings.max_bodies)");
        check(first_extent_.interactions, out_.settings.max_interactions,
              "interactions (settings.max_interactions)");
        check(first_extent_.shapes, kMaxElements, "shapes");
        if (copy_offset_.isZero(0.0) && copies > 1) {
            throw_error(location_ / "offset", "must not be zero");
        }
        copy_number_ = out_.store_location(location_);
        for (int copy = 1; copy < copies; ++copy) {
            add_copy(copy);
        }
        out_.copies = 1;  // The copies exist now, so that later items count once.
        for (int copy = 0; copy + 1 < copies; ++copy) {
            add_joins(copy);
        }
    }

  private:
    void add_copy(int copy) {
        const std::string prefix = copy_prefix(copy);
        const Vec3 shift = copy * copy_offset_;
        first_ = static_cast<std::int32_t>(out_.interactions.size());
        add_bodies(prefix, shift);
        add_interactions(prefix, shift);
        add_inputs(prefix);
        add_signal_inputs(prefix);
        add_outputs(prefix, shift);
        add_cables(prefix, shift);
        add_winches(prefix);
        add_guides(prefix);
        add_posts(prefix);
        add_gear(out_.deck.stoppers, first_extent_.stoppers, prefix);
        add_gear(out_.deck.pins, first_extent_.pins, prefix);
        add_gear(out_.deck.hooks, first_extent_.hooks, prefix);
        add_gear(out_.deck.chasers, first_extent_.chasers, prefix);
        add_gear(out_.vessels, first_extent_.vessels, prefix);
        add_section_items(prefix);
        add_gear(out_.anchors, first_extent_.anchors, prefix);
        add_gear(out_.gauges, first_extent_.gauges, prefix);
        add_resolutions(prefix);
        add_cranes(prefix, shift);
        add_shapes(prefix, shift);
    }

    /// Return the counterpart of a body or interaction of copy 0 in this copy.
    [[nodiscard]] BodyId counterpart(BodyId id) const {
        return id.valid() ? bodies_[static_cast<std::size_t>(id.index)] : id;
    }
    [[nodiscard]] InteractionId counterpart(InteractionId id) const {
        return id.valid() ? InteractionId{first_ + id.index} : id;
    }
    [[nodiscard]] bool is_world(BodyId id) const {
        return id.valid() && id == out_.world_body_if_any();
    }

    void add_bodies(const std::string& prefix, const Vec3& shift) {
        bodies_.assign(first_extent_.bodies, BodyId{});
        for (std::size_t i = 0; i < first_extent_.bodies; ++i) {
            const BodyId old{static_cast<std::int32_t>(i)};
            if (is_world(old)) {
                bodies_[i] = old;
                continue;
            }
            BodyDef def = out_.bodies[i];
            rename(def.name, prefix);
            if (def.kind != BodyKind::scalar) {
                def.position += shift;
            }
            apply_stored_state(def, document_);
            bodies_[i] = out_.add_body(std::move(def), copy_number_);
        }
    }

    void add_interactions(const std::string& prefix, const Vec3& shift) {
        for (std::size_t i = 0; i < first_extent_.interactions; ++i) {
            InteractionDef def = out_.interactions[i];
            rename(def.name, prefix);
            for (std::size_t b = 0; b < def.body.size(); ++b) {
                // The world does not move along: shift the point on it instead.
                if (is_world(def.body[b])) {
                    def.point[b] += shift;
                }
                def.body[b] = counterpart(def.body[b]);
            }
            for (FrictionLoad& load : def.load) {
                load.interaction = counterpart(load.interaction);
            }
            out_.add_interaction(std::move(def), copy_number_);
        }
    }

    void add_cables(const std::string& prefix, const Vec3& shift) {
        for (std::size_t i = 0; i < first_extent_.cables; ++i) {
            Cable cable = out_.cables[i];
            rename(cable.name, prefix);
            if (is_world(cable.nodes.front())) cable.from_point += shift;
            if (is_world(cable.nodes.back())) cable.to_point += shift;
            for (BodyId& node : cable.nodes) {
                node = counterpart(node);
            }
            for (InteractionId& element : cable.stretch) {
                element = counterpart(element);
            }
            out_.add_cable(std::move(cable), location_);
        }
    }

    void add_winches(const std::string& prefix) {
        for (std::size_t i = 0; i < first_extent_.winches; ++i) {
            Winch winch = out_.winches[i];
            rename(winch.def.name, prefix);
            rename(winch.cable, prefix);
            winch.def.drum = counterpart(winch.def.drum);
            winch.def.chain = counterpart(winch.def.chain);
            winch.def.heave_body = counterpart(winch.def.heave_body);
            winch.location = copy_number_;
            out_.winches.push_back(std::move(winch));
        }
    }

    void add_guides(const std::string& prefix) {
        for (std::size_t i = 0; i < first_extent_.guides; ++i) {
            GuideItem guide = out_.guides[i];
            rename(guide.def.name, prefix);
            rename(guide.cable, prefix);
            guide.def.body = counterpart(guide.def.body);
            guide.def.slide = counterpart(guide.def.slide);
            guide.location = copy_number_;
            out_.guides.push_back(std::move(guide));
        }
    }

    void add_posts(const std::string& prefix) {
        for (std::size_t i = 0; i < first_extent_.posts; ++i) {
            PostItem post = out_.posts[i];
            rename(post.def.name, prefix);
            post.location = copy_number_;
            out_.posts.push_back(std::move(post));
        }
    }

    template <class Items>
    void add_gear(Items& items, std::size_t count, const std::string& prefix) {
        for (std::size_t i = 0; i < count; ++i) {
            auto item = items[i];
            rename(item.def.name, prefix);
            item.def.body = counterpart(item.def.body);
            if constexpr (requires { item.def.loads; })
                for (CraneLoad& load : item.def.loads) load.body = counterpart(load.body);
            if constexpr (requires { item.cable; }) rename(item.cable, prefix);  // empty: none
            if constexpr (requires { item.other_names; })
                for (std::string& other : item.other_names) rename(other, prefix);
            items.push_back(std::move(item));
        }
    }

    void add_section_items(const std::string& prefix) {
        for (std::size_t i = 0; i < first_extent_.sections; ++i) {
            SectionItem item = out_.sections[i];
            item.prefix = prefix;
            out_.sections.push_back(std::move(item));
        }
    }

    void add_resolutions(const std::string& prefix) {
        for (std::size_t i = 0; i < first_extent_.resolutions; ++i) {
            Resolution one = out_.resolutions[i];
            rename(one.def.name, prefix);
            rename(one.cable, prefix);
            one.location = copy_number_;
            out_.resolutions.push_back(std::move(one));
        }
    }

    void add_cranes(const std::string& prefix, const Vec3& shift) {
        for (std::size_t i = 0; i < first_extent_.cranes; ++i) {
            Crane crane = out_.cranes[i];
            std::visit(
                [&](auto& def) {
                    rename(def.name, prefix);
                    if (is_world(def.mount.on)) def.mount.point += shift;
                    def.mount.on = counterpart(def.mount.on);
                    for (CraneLoad& load : def.loads) load.body = counterpart(load.body);
                },
                crane.def);
            crane.location = copy_number_;
            out_.cranes.push_back(std::move(crane));
        }
    }

    void add_shapes(const std::string& prefix, const Vec3& shift) {
        for (std::size_t i = 0; i < first_extent_.shapes; ++i) {
            if (is_common_to_copies(out_.shapes[i])) {
                continue;
            }
            ShapeDef def = out_.shapes[i];
            rename(def.name, prefix);
            // point at which a body "world" holds a wire
            if (def.body_b.valid() && (is_world(def.body) || is_world(def.body_b)))
                def.position += shift;
            def.body = counterpart(def.body);
            def.body_b = counterpart(def.body_b);
            out_.add_shape(std::move(def), copy_number_);
        }
    }

    void add_inputs(const std::string& prefix) {
        for (std::size_t i = 0; i < first_extent_.inputs; ++i) {
            InputDef def = out_.inputs[i];
            rename(def.name, prefix);
            def.interaction = counterpart(def.interaction);
            def.body = counterpart(def.body);
            out_.add_input(std::move(def), copy_number_);
        }
    }

    void add_signal_inputs(const std::string& prefix) {
        for (std::size_t i = 0; i < first_extent_.levers; ++i) {
            SignalInput input = out_.levers[i].input;
            if (input.signal.starts_with("sea.")) continue;  // Of all copies together.
            rename(input.name, prefix);
            rename(input.signal, prefix);
            out_.add_signal_input(std::move(input), copy_number_);
        }
    }

    void add_outputs(const std::string& prefix, const Vec3& shift) {
        for (std::size_t i = 0; i < first_extent_.outputs; ++i) {
            OutputDef def = out_.outputs[i];
            if (output_kind_info(def.kind).target == OutputTarget::world) {
                continue;  // Of all copies together.
            }
            rename(def.name, prefix);
            for (const auto& [body, point] :
                 {std::pair(&def.body, &def.point), std::pair(&def.body_b, &def.point_b)}) {
                if (is_world(*body)) {
                    *point += shift;
                }
                *body = counterpart(*body);
            }
            def.interaction = counterpart(def.interaction);
            for (InteractionId& element : def.line) {
                element = counterpart(element);
            }
            out_.add_output(std::move(def), copy_number_);
        }
    }

    /// @return true for a plane of a fixed body that is parallel to the offset: one plane serves
    ///        all copies.
    [[nodiscard]] bool is_common_to_copies(const ShapeDef& def) const {
        const BodyDef& body = out_.body(def.body);
        const Vec3 normal = body.orientation * (def.orientation * Vec3::UnitZ());
        return def.kind == ShapeKind::plane && body.kind == BodyKind::fixed &&
               std::abs(normal.dot(copy_offset_)) <= 1e-9 * copy_offset_.norm();
    }

    /// Add the cables from copy `copy` to the next.
    void add_joins(int copy) {
        const auto list = repeat_.find("joins");
        if (list == repeat_.end()) {
            return;
        }
        const Scope from = scope_of(copy);
        const Scope to = scope_of(copy + 1);
        for (std::size_t i = 0; i < list->size(); ++i) {
            const std::size_t first = out_.bodies.size();
            expand_cable(out_, from, to, (*list)[i], document_, location_ / "joins" / i);
            for (std::size_t b = first; b < out_.bodies.size(); ++b) {
                apply_stored_state(out_.bodies[b], document_);
            }
        }
    }

    [[nodiscard]] Scope scope_of(int copy) const {
        Scope scope;
        scope.prefix = copy == 0 ? "" : copy_prefix(copy);
        scope.frame.position = copy * copy_offset_;
        return scope;
    }

    Description& out_;
    const Document& document_;
    SourceLocation location_;
    const Json& repeat_;
    Vec3 copy_offset_;
    Extent first_extent_;
    int copy_number_ = 0;
    // Data of the copy that is being added:
    std::vector<BodyId> bodies_{};  ///< By index in copy 0.
    std::int32_t first_ = 0;        ///< Its first interaction.
};

}  // namespace

void expand_copies(Description& out, const Document& document) {
    const auto repeat = document.root.find("repeat");
    if (repeat == document.root.end()) {
        return;
    }
    Copier(out, document, *repeat).run(repeat->value("copies", 1));
}

}  // namespace hawser::scene
