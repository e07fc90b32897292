// SPDX-License-Identifier: Apache-2.0
#include "world/node_defs.h"

#include <hawser/world.h>

#include "base/index.h"

#include <array>

namespace hawser::world {

BodyDef node_body(const World& w, const InteractionDef& element, const edit::NodeDef& node) {
    BodyDef out{.name = {}, .kind = BodyKind::lump, .position = node.position};
    out.velocity = node.velocity;
    out.mass = node.mass;
    out.linear_damping = node.damping;
    for (std::size_t b = 2; b-- > 0;) {
        const BodyDef& end = w.body_def(element.body[b]);
        if (end.kind != BodyKind::lump) continue;
        out.gravity = end.gravity;
        out.group = end.group;
        out.force += node.of_end[b] * end.force;
    }
    return out;
}

InteractionDef other_element(const model::Interactions& in, std::int32_t element, BodyId node,
                             double share, bool first, double mass, std::int32_t beside) {
    const InteractionDef& def = in.def[at(element)];
    const bool wound = kind_info(def.kind).is(kWoundUp);
    InteractionDef out;
    out.kind = wound ? InteractionKind::Stretch : def.kind;
    out.body[0] = first ? def.body[0] : node;
    out.body[1] = first ? node : def.body[1];
    out.point[first ? 0 : 1] = def.point[first ? 0 : 1];
    const double length = (first ? share : 1.0 - share) * in.rest_length[at(element)];
    out.set("length", length);
    for (const char* same : {"EA", "tension_only", "breaking_load"}) out.set(same, def.get(same));
    // The next node gets its half of the mass in finish_node_insertion(); until then it has none.
    constexpr double kNone = 1e-3;
    if (wound) out.set("mass", kNone * mass);
    // A fraction of critical damping. For a drum's element use that of the wire beyond.
    const std::int32_t as = wound && beside >= 0 ? beside : element;
    if (in.row_flags[at(in.row_begin[at(as)])] & model::kRowDamper)
        out.damping_time[0] =
            in.def[at(as)].damping_time[0] * (as == beside ? length / in.rest_length[at(as)]
                                              : wound      ? 1.0
                                                           : 1.0 - share);
    return out;
}

InteractionDef node_bend(const model::Interactions& in, std::int32_t element, double EI) {
    const InteractionDef& def = in.def[at(element)];
    InteractionDef out;
    out.kind = InteractionKind::Bend;
    out.body[0] = def.body[0];
    out.body[2] = def.body[1];
    out.set("EI", EI).set("length", 0.5 * in.rest_length[at(element)]);
    return out;
}

}  // namespace hawser::world
