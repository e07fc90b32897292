// SPDX-License-Identifier: Apache-2.0
#include "live/frame_writer.h"

#include "base/index.h"
#include "live/hub.h"
#include "record/scene_info.h"

#include <hawser/state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace hawser::live {

namespace {

float single(double value) noexcept { return static_cast<float>(value); }

Vec3 world_position(const StateView& state, const HeldPoint& held) {
    const double* x = &state.positions[3 * at(held.body)];
    Vec3 out(x[0], x[1], x[2]);
    if (held.turns) {
        const double* q = &state.orientations[4 * at(held.body)];
        out += Quat(q[0], q[1], q[2], q[3]) * held.point;
    }
    return out;
}

void append_floats(std::vector<float>& to, const Vec3& v) {
    for (int k = 0; k < 3; ++k) to.push_back(single(v[k]));
}

float* append_poses(const StateView& state, const std::vector<BodyId>& bodies, const Vec3& origin,
                    float* to) {
    for (const BodyId id : bodies) {
        const double* x = &state.positions[3 * at(id.index)];
        const double* q = &state.orientations[4 * at(id.index)];
        for (int k = 0; k < 3; ++k) *to++ = single(x[k] - origin[k]);
        for (int k = 0; k < 4; ++k) *to++ = single(q[k]);
    }
    return to;
}

float* append_nodes(const StateView& state, const std::vector<BodyId>& bodies, const Vec3& origin,
                    float* to) {
    for (const BodyId id : bodies) {
        const double* x = &state.positions[3 * at(id.index)];
        for (int k = 0; k < 3; ++k) *to++ = single(x[k] - origin[k]);
    }
    return to;
}

template <class T>
float* append_vector(const std::vector<T>& from, float* to) {
    static_assert(sizeof(T) == sizeof(float));
    if (!from.empty()) std::memcpy(to, from.data(), from.size() * sizeof(T));
    return to + from.size();
}

float* append_joints(const World& world, const std::vector<JointSource>& joints, float* to) {
    for (const JointSource& joint : joints) {
        const auto force = world.force(joint.id);
        for (std::size_t k = 0; k < 3; ++k) *to++ = k < force.size() ? single(force[k]) : 0.0F;
    }
    return to;
}

float* append_signals(const World& world, const FramePlan& plan, float* to) {
    const auto outputs = world.outputs();
    for (const OutputId id : plan.outputs)
        *to++ = at(id.index) < outputs.size() ? single(outputs[at(id.index)])
                                              : std::numeric_limits<float>::quiet_NaN();
    for (const InputSource& input : plan.inputs)
        *to++ = single(input.signal ? *input.signal / input.factor : world.input(input.id));
    return to;
}

}  // namespace

void FrameWriter::add_wire(const World& world, const WireSource& wire, const StateView& state,
                           const Vec3& origin) {
    constexpr double kCoincidenceDistance =
        1e-3;  // [m] ends of two elements that are closer than this coincide
    const std::size_t before = points_.size() / 3;
    Vec3 last = Vec3::Zero();
    float pull_before = 0.0F;
    bool routed_before = false;
    for (const PieceSource& piece : wire.pieces) {
        std::array<Vec3, 2> ends = piece.routed
                                       ? world.wires().ends(piece.element)
                                       : std::array<Vec3, 2>{world_position(state, piece.end[0]),
                                                             world_position(state, piece.end[1])};
        if (piece.backwards) std::swap(ends[0], ends[1]);
        float pull = -1.0F;
        if (piece.joint)
            pull = single(record::element_tension(world, piece.element));
        else if (world.intact(piece.element))
            pull = std::max(0.0F, single(-world.force(piece.element)[0]));
        if (points_.size() / 3 == before) {
            append_floats(points_, ends[0] - origin);
        } else if ((ends[0] - last).squaredNorm() > kCoincidenceDistance * kCoincidenceDistance) {
            // On a wheel the line continues; otherwise an element between was removed.
            append_floats(points_, ends[0] - origin);
            tensions_.push_back(routed_before && piece.routed ? std::max(pull, pull_before)
                                                              : -1.0F);
        }
        append_floats(points_, ends[1] - origin);
        tensions_.push_back(pull);
        last = ends[1];
        pull_before = pull;
        routed_before = piece.routed;
    }
    counts_.push_back(static_cast<std::uint32_t>(points_.size() / 3 - before));
}

void FrameWriter::add_wires(const World& world, const FramePlan& plan, const Vec3& origin) {
    counts_.clear();
    points_.clear();
    tensions_.clear();
    const StateView state = world.state().arrays();
    for (const WireSource& wire : plan.wires) add_wire(world, wire, state, origin);
}

void FrameWriter::add_contacts(const World& world, const Vec3& origin, FrameHeader& head) {
    forces_.clear();
    world.contacts(contacts_);
    for (const ContactView& contact : contacts_) {
        if (contact.force.isZero(0.0)) continue;
        if (forces_.size() >= 6 * kMaxContacts) {
            ++head.contacts_left;
            continue;
        }
        append_floats(forces_, contact.point - origin);
        append_floats(forces_, contact.force);
    }
}

void FrameWriter::add_stats(const World& world, const FrameNotes& notes, float* to,
                            FrameHeader& head) {
    constexpr double kMillisecondsPerSecond = 1e3;
    const StepStats& s = world.stats();
    // Conditions of a solution that counts as exact (docs/theory/newton.md).
    constexpr double kMaxMomentumResidual = 1e-8;
    const bool solved = s.status == Status::ok && s.flips_left == 0 && !s.cut &&
                        s.natural_map <= world.settings().contact_tolerance &&
                        s.momentum_residual <= kMaxMomentumResidual && !s.degradation.any();
    const bool missed = kMillisecondsPerSecond * s.step_seconds > notes.deadline_ms;
    head.bits = (solved ? kCertified : 0U) | (s.degradation.of_solve() ? kEndedEarly : 0U) |
                (missed ? kMissedDeadline : 0U) | (static_cast<std::uint32_t>(s.degraded_by) << 8U);
    head.iterations = s.degradation.iterations;
    head.cuts = s.degradation.cuts;
    head.coarser = s.degradation.wires;
    head.hasty = s.degradation.hasty ? 1U : 0U;
    // The energy costs twice as much as the rest of a frame: once a second is enough for a plot.
    constexpr std::int64_t kEnergyEvery = 60;
    const std::int64_t step = world.step_count();
    if (energy_of_ < 0 || step < energy_of_ || step - energy_of_ >= kEnergyEvery) {
        energy_ = world.energy().mechanical();
        energy_of_ = step;
    }
    *to++ = single(kMillisecondsPerSecond * s.step_seconds);
    for (const double stage : s.stage_seconds) *to++ = single(kMillisecondsPerSecond * stage);
    for (const double value :
         {kMillisecondsPerSecond * s.solver_cpu_seconds, notes.deadline_ms, s.momentum_residual,
          s.constraint_residual, s.violation_max, s.natural_map, static_cast<double>(s.contacts),
          static_cast<double>(s.newton_iterations), static_cast<double>(s.islands),
          static_cast<double>(s.asleep), energy_, notes.late_ms, 1e6 * seconds_})
        *to++ = single(value);
}

void FrameWriter::write(const World& world, const FramePlan& plan, const Vec3& origin,
                        const FrameNotes& notes, Bytes& out) {
    const double begun = clock_now();
    FrameHeader head;
    head.flags = notes.flags;
    head.epoch = notes.epoch;
    head.number = notes.number;
    head.skipped = notes.skipped;
    head.step = world.step_count();
    head.time = world.time();
    add_wires(world, plan, origin);
    add_contacts(world, origin, head);
    const auto count = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
    head.rigid = count(plan.rigid.size());
    head.lumps = count(plan.lumps.size());
    head.scalars = count(plan.scalars.size());
    head.wires = count(plan.wires.size());
    head.points = count(points_.size() / 3);
    head.pieces = count(tensions_.size());
    head.contacts = count(forces_.size() / 6);
    head.joints = count(plan.joints.size());
    head.outputs = count(plan.outputs.size());
    head.inputs = count(plan.inputs.size());
    head.stats = count(kStatCount);
    head.length = count(kFrameHeader + 4 * head.floats());
    out.resize(head.length);
    auto* to = reinterpret_cast<float*>(out.data() + kFrameHeader);
    const StateView state = world.state().arrays();
    to = append_poses(state, plan.rigid, origin, to);
    to = append_nodes(state, plan.lumps, origin, to);
    for (const BodyId id : plan.scalars) *to++ = single(state.positions[3 * at(id.index)]);
    to = append_vector(counts_, to);
    to = append_vector(points_, to);
    to = append_vector(tensions_, to);
    to = append_vector(forces_, to);
    to = append_joints(world, plan.joints, to);
    float* const outputs = to;
    to = append_signals(world, plan, to);
    for (const ShownOutput& shown : notes.shown) outputs[shown.output] = single(shown.value);
    add_stats(world, notes, to, head);
    head.clock = clock_now();
    seconds_ = head.clock - begun;
    std::memcpy(out.data(), &head, sizeof head);
}

}  // namespace hawser::live
