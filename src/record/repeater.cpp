// SPDX-License-Identifier: Apache-2.0
#include <hawser/hawser.h>
#include <hawser/repeater.h>

#include "record/bytes.h"
#include "record/change_fields.h"
#include "record/changes.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace hawser::record {

/// Applies the loads of a recorded step to the same bodies.
class Repeater::Loader final : public System {
  public:
    static constexpr int kMaximum = 21;  ///< Number of entries of a symmetric 6 × 6 matrix.
    struct Load {
        BodyId body;
        std::size_t freedom = 0;
        std::array<double, 6> force{};
        std::array<std::array<double, kMaximum>, 3> matrix{};  ///< Matrices A, D, K.
    };
    std::vector<Load> next;  ///< Loads of the next step.

    [[nodiscard]] std::string_view name() const noexcept override { return "recorded loads"; }
    void prestep(Prestep&, Loads& loads) noexcept override {
        for (const Load& load : next) {
            const BodyLoad to = loads.of(load.body);
            if (to.freedom != static_cast<int>(load.freedom)) continue;  // out of memory
            const std::size_t entries = load.freedom * (load.freedom + 1) / 2;
            double* const matrices[] = {to.mass, to.damping, to.stiffness};
            for (std::size_t i = 0; i < load.freedom; ++i) to.force[i] += load.force[i];
            for (std::size_t m = 0; m < 3; ++m)
                for (std::size_t i = 0; i < entries; ++i) matrices[m][i] += load.matrix[m][i];
        }
    }
};

namespace {

std::size_t freedom_of(BodyKind kind) {
    switch (kind) {
        case BodyKind::rigid:
            return 6;
        case BodyKind::lump:
            return 3;
        case BodyKind::scalar:
            return 1;
        default:
            return 0;
    }
}

}  // namespace

/// Apply the loads of the next step. The step checks their values (Status::bad_load).
void Repeater::repeat_loads(World& world) {
    const auto& loads = recording_.loads;
    if (loads.empty()) return;
    if (loader_ == nullptr)
        loader_ = &static_cast<Loader&>(world.add_system(std::make_unique<Loader>()));
    loader_->next.clear();
    const std::size_t end = end_of(loads.size(), &RecordedTake::loads);
    while (load_ < end && loads[load_].step < world.step_count()) ++load_;
    if (load_ >= end || loads[load_].step != world.step_count()) return;
    ByteReader in(loads[load_].bytes);
    constexpr std::size_t kMinimum = 4 + 4 + 1 + 4 * 8;
    loader_->next.resize(in.get_count(kMinimum));
    for (Loader::Load& load : loader_->next) {
        load.body.index = in.get<std::int32_t>();
        load.body.generation = in.get<std::int32_t>();
        load.freedom = in.get<std::uint8_t>();
        if (!world.alive(load.body) || load.freedom != freedom_of(world.body_def(load.body).kind))
            throw BadBytes("a load is on no body that has it");
        const std::size_t entries = load.freedom * (load.freedom + 1) / 2;
        for (std::size_t i = 0; i < load.freedom; ++i) load.force[i] = in.get<double>();
        for (auto& matrix : load.matrix)
            for (std::size_t i = 0; i < entries; ++i) matrix[i] = in.get<double>();
    }
    in.expect_end();
}

/// Return the end of the entries of the present branch in a list of `all` entries.
std::size_t Repeater::end_of(std::size_t all, std::size_t RecordedTake::* before) const {
    return take_ < recording_.takes.size() ? recording_.takes[take_].*before : all;
}

/// Remove the loader before a state is restored: states in recordings belong to worlds without
/// systems.
void Repeater::drop_loader(std::span<const std::byte> change, World& world) {
    if (loader_ == nullptr || change.empty()) return;
    const auto kind = static_cast<ChangeKind>(change.front());
    if (kind != ChangeKind::restore && kind != ChangeKind::rebuild) return;
    (void)world.remove_system(*loader_);
    loader_ = nullptr;
}

/// Enter the next branch. The last change of a branch restores the state at which the next one
/// starts.
void Repeater::enter_take(World& world) {
    const RecordedTake& take = recording_.takes[take_];
    if (world.step_count() != take.to)
        throw std::runtime_error("a branch of the recording does not begin at its stated step");
    input_ = take.inputs;
    load_ = take.loads;
    cut_ = take.cuts;
    ++take_;
}

void Repeater::before_step(World& world) {
    const auto& inputs = recording_.inputs;
    const auto& changes = recording_.changes;
    const auto& cuts = recording_.cuts;
    std::int64_t now = world.step_count();
    // A system sets both ends of a range. The first may be beyond the other one until that follows.
    std::vector<RecordedInput> later;
    for (;;) {
        const std::size_t end = end_of(changes.size(), &RecordedTake::changes);
        const bool due = change_ < end && changes[change_].step <= now;
        if (due && changes[change_].inputs_before <= input_) {
            drop_loader(changes[change_].bytes, world);
            apply_changes(changes[change_++].bytes, world);
            if (change_ == end && take_ < recording_.takes.size()) {
                enter_take(world);
                now = world.step_count();
            }
        } else if (input_ < end_of(inputs.size(), &RecordedTake::inputs) &&
                   inputs[input_].step <= now) {
            const RecordedInput& set = inputs[input_++];
            try {
                world.set_input({set.input}, set.value);
            } catch (const DefError&) {
                later.push_back(set);
            }
        } else {
            break;
        }
    }
    for (const RecordedInput& set : later) world.set_input({set.input}, set.value);
    repeat_loads(world);
    const std::size_t end = end_of(cuts.size(), &RecordedTake::cuts);
    while (cut_ < end && cuts[cut_].step < now) ++cut_;
    if (cut_ < end && cuts[cut_].step == now) world.solver().degrade_next_step(cuts[cut_].left_out);
}

}  // namespace hawser::record
