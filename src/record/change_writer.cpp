// SPDX-License-Identifier: Apache-2.0
#include "record/changes.h"

#include "record/field_bytes.h"

#include <utility>
#include <vector>

namespace hawser::record {

/// Append one change of the world to the bytes. If allocation fails, remove the part of it already
/// written.
template <class F>
void ChangeBytes::write(F&& fields) noexcept {
    try {
        ByteWriter one;
        PutFields put{one};
        fields(put);
        out_.write_bytes(one.bytes());
    } catch (const std::exception&) {
        failed_ = true;
    }
}

namespace {

void begin(PutFields& put, ChangeKind kind) { put.out.put(static_cast<std::uint8_t>(kind)); }

}  // namespace

void ChangeBytes::added(const BodyDef& def) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::add_body);
        visit_fields(def, put);
    });
}
void ChangeBytes::added(const InteractionDef& def) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::add_interaction);
        visit_fields(def, put);
    });
}
void ChangeBytes::added(const ShapeDef& def) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::add_shape);
        visit_fields(def, put);
    });
}
void ChangeBytes::added(const InputDef& def) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::add_input);
        visit_fields(def, put);
    });
}
void ChangeBytes::added(const MaterialDef& def) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::add_material);
        visit_fields(def, put);
    });
}
void ChangeBytes::added(const MaterialPairDef& def) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::add_material_pair);
        visit_fields(def, put);
    });
}
void ChangeBytes::removed(BodyId id) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::remove_body);
        put(id);
    });
}
void ChangeBytes::removed(InteractionId id) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::remove_interaction);
        put(id);
    });
}
void ChangeBytes::removed(ShapeId id) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::remove_shape);
        put(id);
    });
}
void ChangeBytes::removed(InputId id) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::remove_input);
        put(id);
    });
}
void ChangeBytes::set(InputId id, double value) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_input);
        put(id);
        put(value);
    });
}
void ChangeBytes::set_force(BodyId id, const Vec3& force, const Vec3& torque) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_force);
        put(id);
        put(force);
        put(torque);
    });
}
void ChangeBytes::set_pose(BodyId id, const Pose& pose) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_pose);
        put(id);
        put(pose.position);
        put(pose.orientation);
    });
}
void ChangeBytes::set_velocity(BodyId id, const Twist& twist) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_velocity);
        put(id);
        put(twist.linear);
        put(twist.angular);
    });
}
void ChangeBytes::woken(BodyId id) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::wake);
        put(id);
    });
}
void ChangeBytes::set_group(BodyId id, const std::string& group) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_group);
        put(id);
        put(group);
    });
}
void ChangeBytes::set_groups(int parts) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_groups);
        put(std::int32_t{parts});
    });
}
void ChangeBytes::follow_groups(int parts, int every) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::follow_groups);
        put(std::int32_t{parts});
        put(std::int32_t{every});
    });
}
void ChangeBytes::set_coupling(InteractionId id, Coupling coupling) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_coupling);
        put(id);
        put.word(coupling, 4);
    });
}
void ChangeBytes::degraded(const Degradation& d) noexcept {
    write([&](PutFields& put) {
        begin(put, d.wires > 0 ? ChangeKind::degrade_wires : ChangeKind::degrade);
        put(d.iterations);
        put(d.hasty);
        put(d.cuts);
        if (d.wires > 0) put(d.wires);
    });
}
void ChangeBytes::parted(InteractionId id) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::part);
        put(id);
    });
}
void ChangeBytes::set_mass(BodyId lump, double mass) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::set_mass);
        put(lump);
        put(mass);
    });
}
void ChangeBytes::node_inserted(InteractionId element, double share, double mass) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::insert_node);
        put(element);
        put(share);
        put(mass);
    });
}
void ChangeBytes::node_removed(BodyId node, double bend) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::remove_node);
        put(node);
        put(bend);
    });
}
void ChangeBytes::laid_over(InteractionId element, const InteractionDef& before,
                            const InteractionDef& behind) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::lay_over);
        put(element);
        visit_fields(before, put);
        visit_fields(behind, put);
    });
}
void ChangeBytes::lifted(InteractionId before, InteractionId behind,
                         const InteractionDef& element) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::lift_off);
        put(before);
        put(behind);
        visit_fields(element, put);
    });
}
void ChangeBytes::moved_along(InteractionId before, InteractionId behind, double along,
                              double fed) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::move_along);
        put(before);
        put(behind);
        put(along);
        put(fed);
    });
}
void ChangeBytes::cut(InteractionId element, double share) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::cut);
        put(element);
        put(share);
    });
}
void ChangeBytes::joined(BodyId a, BodyId b, const Vec3& point, const JoinDef& def) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::join);
        put(a);
        put(b);
        put(point);
        visit_fields(def, put);
    });
}
void ChangeBytes::detached(InteractionId element, int end) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::detach);
        put(element);
        put(static_cast<std::int32_t>(end));
    });
}
void ChangeBytes::detached_with_mass(InteractionId element, int end, double mass) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::detach_carried);
        put(element);
        put(static_cast<std::int32_t>(end));
        put(mass);
    });
}
void ChangeBytes::released(InteractionId hook) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::release);
        put(hook);
    });
}
void ChangeBytes::restored(std::span<const std::byte> bytes) noexcept {
    write([&](PutFields& put) {
        begin(put, ChangeKind::restore);
        put(static_cast<std::uint32_t>(bytes.size()));
        put.out.write_bytes(bytes);
    });
}

void ChangeBytes::restored(const Structure& made_of, std::span<const std::byte> bytes) noexcept {
    bodies_changed_ = true;
    write([&](PutFields& put) {
        begin(put, ChangeKind::rebuild);
        put(made_of);
        put(static_cast<std::uint32_t>(bytes.size()));
        put.out.write_bytes(bytes);
    });
}

void ChangeBytes::clear() noexcept {
    out_.clear();
    bodies_changed_ = false;
}

}  // namespace hawser::record
