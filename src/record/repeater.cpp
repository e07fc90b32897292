// SPDX-License-Identifier: Apache-2.0
#include <hawser/hawser.h>
#include <hawser/repeater.h>

#include "base/body_dof.h"
#include "record/bytes.h"
#include "record/change_fields.h"
#include "record/changes.h"
#include "record/recording_bytes.h"
#include "record/recording_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace hawser::record {

namespace {
constexpr unsigned kBothSources = kOtherSource | kWaterSource;
}

/// Loads of the next step, shared by the systems that apply them.
struct Repeater::Load {
    BodyId body;
    std::size_t freedom = 0;  ///< 0: no load, and none of the sea either.
    unsigned sources = kNoSource;
    std::array<double, kMaxLoadNumbers> all{};  ///< f, A, D, K.
    /// Part of water if there are two sources. Its matrices are differences of sums. Rounding may
    /// make them indefinite, and then no step accepts them as loads.
    std::array<double, kMaxLoadNumbers> water{};
    BodyLoad target{};  ///< Load in the step if there are two sources.

    /// Set the load of a body in the next step.
    void put(const BodyLoad& to,
             const std::array<double, kMaxLoadNumbers>& numbers) const noexcept {
        if (to.freedom != static_cast<int>(freedom)) return;  // out of memory
        const std::size_t entries = freedom * (freedom + 1) / 2;
        const double* from = numbers.data();
        std::copy_n(from, freedom, to.force);
        from += freedom;
        for (double* matrix : {to.mass, to.damping, to.stiffness}) {
            std::copy_n(from, entries, matrix);
            from += entries;
        }
    }
};

/// Applies the loads of the sea on nodes of wires, computed again, and recorded loads of bodies
/// that water loaded.
class Repeater::Water final : public System {
  public:
    std::vector<Load> next;  ///< Loads of the next step, by ascending body.
    /// Sea of the next step that acts on nodes without recorded loads; null: none.
    std::shared_ptr<LineLoads> lines;
    SeaInputs inputs;

    [[nodiscard]] std::string_view name() const noexcept override { return "recorded water"; }
    [[nodiscard]] bool is_water() const noexcept override { return true; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        if (lines && !lines->compute(now, inputs))
            return now.set_input(InputId{}, std::nan(""));  // ends the step
        if (lines) lines->add(loads, bodies_);
        for (const Load& load : next)
            if ((load.sources & kWaterSource) != 0) load.put(loads.of(load.body), load.all);
        for (Load& load : next)  // no first load follows, so that pointers stay valid
            if (load.sources == kBothSources) load.target = loads.of(load.body);
    }
    /// Complete the loads of the next step. @throws BadBytes
    void begin() {
        bodies_.clear();
        for (const Load& load : next) bodies_.push_back(load.body);
        if (lines && !std::is_sorted(bodies_.begin(), bodies_.end()))
            throw BadBytes("loads are not in the order of bodies");
    }

  private:
    std::vector<BodyId> bodies_;  ///< Bodies of `next`.
};

/// Applies the recorded loads of bodies that other systems loaded. The part of water in a load is
/// the sum when this system first requests the load. It is therefore set before that, through the
/// pointers of Water. The sum replaces it.
class Repeater::Loader final : public System {
  public:
    explicit Loader(Water& water) noexcept : water_(water) {}
    [[nodiscard]] std::string_view name() const noexcept override { return "recorded loads"; }
    void prestep(Prestep&, Loads& loads) noexcept override {
        for (const Load& load : water_.next) {
            if (load.sources != kBothSources) continue;
            load.put(load.target, load.water);
            load.put(loads.of(load.body), load.all);
        }
        for (const Load& load : water_.next)
            if (load.sources == kOtherSource) load.put(loads.of(load.body), load.all);
    }

  private:
    Water& water_;
};

/// Read the sea of a step whose loads on nodes of wires are computed again.
void Repeater::read_sea(ByteReader& in) {
    water_->lines.reset();
    const auto sea = in.get<std::int32_t>();
    if (sea < 0) return;
    if (static_cast<std::size_t>(sea) >= recording_.seas.size())
        throw BadBytes("the loads of a step belong to no sea");
    if (sea != sea_)
        lines_ = std::make_shared<LineLoads>(recording_.seas[static_cast<std::size_t>(sea)]);
    sea_ = sea;
    water_->lines = lines_;
    for (double* input : {&water_->inputs.waves, &water_->inputs.current, &water_->inputs.level})
        *input = get_finite(in);
}

/// Read one recorded load on a body.
void Repeater::read_load(ByteReader& in, const World& world, Load& load) const {
    const bool all = recording_.format == kAllLoadsVersion;
    load.body.index = in.get<std::int32_t>();
    load.body.generation = in.get<std::int32_t>();
    load.freedom = in.get<std::uint8_t>();
    load.sources = all ? unsigned{kOtherSource} : in.get<std::uint8_t>();
    const bool none = !all && load.freedom == 0 && load.sources == kNoSource;
    if (!world.alive(load.body) || (!none && load.freedom != static_cast<std::size_t>(base::dof_of(
                                                                 world.body_def(load.body).kind))))
        throw BadBytes("a load is on no body that has it");
    if (load.sources > kBothSources || (!none && load.sources == kNoSource))
        throw BadBytes("a load has no source");
    const std::size_t numbers = load_numbers(load.freedom);
    for (std::size_t i = 0; i < numbers; ++i) load.all[i] = in.get<double>();
    if (load.sources != kBothSources) return;
    for (std::size_t i = 0; i < numbers; ++i) load.water[i] = in.get<double>();
}

/// Apply the loads of the next step. The step checks their values (Status::bad_load).
void Repeater::repeat_loads(World& world) {
    const auto& loads = recording_.loads;
    if (loads.empty()) return;
    if (water_ == nullptr) {
        water_ = &static_cast<Water&>(world.add_system(std::make_unique<Water>()));
        loader_ = &world.add_system(std::make_unique<Loader>(*water_));
    }
    water_->next.clear();
    water_->lines.reset();
    const std::size_t end = end_of(loads.size(), &RecordedTake::loads);
    while (load_ < end && loads[load_].step < world.step_count()) ++load_;
    if (load_ < end && loads[load_].step == world.step_count()) {
        ByteReader in(loads[load_].bytes);
        if (recording_.format != kAllLoadsVersion) read_sea(in);
        water_->next.resize(in.get_count(kLoadBodyBytes - 1));
        for (Load& load : water_->next) read_load(in, world, load);
        in.expect_end();
    }
    water_->begin();
}

/// Return the end of the present branch's entries in a list of the recording. @param all  Number of
/// entries of the list. @param before  Member with the number of entries before the next branch.
std::size_t Repeater::end_of(std::size_t all, std::size_t RecordedTake::* before) const {
    return take_ < recording_.takes.size() ? recording_.takes[take_].*before : all;
}

/// Remove the systems that apply recorded loads before a state is restored. States in recordings
/// belong to worlds without systems.
void Repeater::drop_loader(std::span<const std::byte> change, World& world) {
    if (water_ == nullptr || change.empty()) return;
    const auto kind = static_cast<ChangeKind>(change.front());
    if (kind != ChangeKind::restore && kind != ChangeKind::rebuild) return;
    (void)world.remove_system(*loader_);
    (void)world.remove_system(*water_);
    loader_ = nullptr;
    water_ = nullptr;
}

/// Enter the next branch. The last change of a branch restores the state at which the next one
/// starts.
void Repeater::enter_branch(World& world) {
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
                enter_branch(world);
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
