// SPDX-License-Identifier: Apache-2.0
#include <hawser/hawser.h>

#include "exercise/curves.h"
#include "exercise/levers.h"
#include "exercise/notes.h"
#include "exercise/scorer.h"
#include "record/input_range.h"
#include "record/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::exercise {

namespace {

/// Tolerance of times, which are multiples of the step [steps].
constexpr double kStepRounding = 1e-6;
constexpr std::size_t kMaxMarks = 1024;

}  // namespace

struct Run::Impl {
    /// State of a fault.
    struct Standing {
        bool active = false, was = false;  ///< `was`: it has started automatically before.
        double until = std::numeric_limits<double>::infinity();  ///< Time at which it ends [s].
    };
    /// State that marks save and restore.
    struct State {
        Controls levers;
        std::vector<Standing> faults;
        Scorer scorer;
        /// Index of the first operation of the timeline that is not applied yet.
        std::size_t next_operation = 0;
        Curves curves;
        std::size_t every = 1, seen = 0;
    };

    Impl(const Exercise& e, Session& s)
        : exercise(e),
          session(s),
          channels(list_channels(e)),
          is_noted(noted_channels(channels, s.world())),
          notes(s),
          state{{},
                std::vector<Standing>(e.faults.size()),
                Scorer(e, s.world().settings().step),
                0,
                {},
                1,
                0} {
        state.curves.values.resize(e.displays.size());
        notes.begin(e, is_noted);
    }

    [[nodiscard]] double now() const { return session.time() + kStepRounding * step(); }
    [[nodiscard]] double step() const { return session.world().settings().step; }

    std::size_t fault_named(std::string_view name) const {
        std::vector<std::string> known;
        for (std::size_t i = 0; i < exercise.faults.size(); ++i) {
            if (exercise.faults[i].name == name) return i;
            known.push_back(exercise.faults[i].name);
        }
        throw DefError(known.empty()
                           ? fmt::format("there is no fault \"{}\": the exercise has none", name)
                           : fmt::format("there is no fault \"{}\"; nearest: \"{}\"", name,
                                         record::nearest_name(name, known)));
    }

    void part(const Fault& fault) {
        World& world = session.world();
        const WireId wire = world.wires().find(fault.target);
        const InteractionId element = world.find_interaction(fault.target);
        if (wire.valid())
            world.wires().part(wire, std::isnan(fault.s)
                                         ? 0.5 * world.wires().length(wire)
                                         : std::min(fault.s, world.wires().length(wire)));
        else if (element.valid())
            world.wires().part(element);
        else
            throw DefError(fmt::format("the fault \"{}\": there is no wire \"{}\" now", fault.name,
                                       fault.target));
    }

    void begin(std::size_t index, std::string_view by) {
        const Fault& fault = exercise.faults[index];
        Standing& standing = state.faults[index];
        if (standing.active) return;
        if (fault.kind == FaultKind::line_parts) part(fault);
        state.levers.begin(session, fault);
        if (fault.kind == FaultKind::output_frozen) {
            const World& world = session.world();
            const OutputId id = world.find_output(fault.target);
            state.scorer.freeze_output(fault.target, id.valid() ? world.output(id) : kDefault);
        }
        standing.active = true;
        standing.until = session.time() + fault.lasts;
        state.scorer.fault(session.time(), fault, by, true);
        notes.fault(true, fault.name, by);
    }

    void finish(std::size_t index, std::string_view by) {
        const Fault& fault = exercise.faults[index];
        if (!state.faults[index].active) return;
        state.faults[index].active = false;
        state.levers.end(fault);
        state.scorer.fault(session.time(), fault, by, false);
        notes.fault(false, fault.name, by);
    }

    void update_faults() {
        for (std::size_t i = 0; i < exercise.faults.size(); ++i) {
            const Fault& fault = exercise.faults[i];
            Standing& standing = state.faults[i];
            if (standing.active && fault.kind != FaultKind::line_parts && standing.until <= now())
                finish(i, "");
            if (fault.at && !standing.was && *fault.at <= now()) {
                standing.was = true;
                begin(i, "");
            }
        }
    }

    void ask(std::string_view input, double value) {
        const auto [name, real] = resolve_target(session.scene(), input, value);
        state.levers.ask(session, name, real);
    }

    const Exercise& exercise;
    Session& session;
    std::vector<Channel> channels;
    std::vector<bool> is_noted;
    NoteWriter notes;
    State state;
    std::vector<double> values;
    std::vector<State> saved_states;
};

Run::Run(const Exercise& exercise, Session& session) {
    const std::vector<std::string> outputs = output_names(session.world());
    for (const Channel& c : list_channels(exercise))
        if (!c.output.empty() && !session.world().find_output(c.output).valid())
            throw DefError(fmt::format(
                "the exercise \"{}\" needs the output \"{}\", which the world has not; nearest: "
                "\"{}\"",
                exercise.name, c.output, record::nearest_name(c.output, outputs)));
    impl_ = std::make_unique<Impl>(exercise, session);
}
Run::~Run() = default;

bool Run::is_role(std::string_view role) const noexcept {
    const auto& stations = impl_->exercise.stations;
    return role == kInstructor || role == kWatcher ||
           std::any_of(stations.begin(), stations.end(),
                       [&](const Station& s) { return s.name == role; });
}

bool Run::may_set(std::string_view role, std::string_view input) const noexcept {
    if (role == kInstructor) return true;
    for (const Station& station : impl_->exercise.stations)
        if (station.name == role)
            return std::find(station.inputs.begin(), station.inputs.end(), input) !=
                   station.inputs.end();
    return false;
}

void Run::set_input(std::string_view role, std::string_view input, double value) {
    const std::vector<std::string> known = input_names(impl_->session.scene());
    if (std::find(known.begin(), known.end(), input) == known.end())
        throw DefError(fmt::format("there is no input \"{}\"; nearest: \"{}\"", input,
                                   record::nearest_name(input, known)));
    if (!may_set(role, input)) {
        std::string who(kInstructor);
        for (const Station& station : impl_->exercise.stations)
            if (may_set(station.name, input)) who += ", " + station.name;
        throw Refused(fmt::format("\"{}\" may not set \"{}\"; who may: {}", role, input, who));
    }
    if (!std::isfinite(value))
        throw DefError(fmt::format("the input \"{}\": the value is not finite", input));
    record::check_input_range(impl_->session.scene(), input, value);
    impl_->ask(input, value);
    impl_->notes.asked(role, input, value);
}

double Run::asked(std::string_view input) const noexcept {
    const auto [name, one] = resolve_target(impl_->session.scene(), input, 1.0);
    const double value = impl_->state.levers.requested(name);
    for (const scene::SignalInput& s : impl_->session.scene().signal_inputs)
        if (s.name == input && s.factor != 0.0 && name == s.signal) return value / s.factor;
    return value;
}

void Run::trigger(std::string_view role, std::string_view fault) {
    const std::size_t index = impl_->fault_named(fault);
    if (role != kInstructor)
        throw Refused(fmt::format("\"{}\" may not trigger faults; the instructor may", role));
    impl_->begin(index, role);
}

void Run::clear(std::string_view role, std::string_view fault) {
    const std::size_t index = impl_->fault_named(fault);
    if (role != kInstructor)
        throw Refused(fmt::format("\"{}\" may not clear faults; the instructor may", role));
    if (impl_->exercise.faults[index].kind == FaultKind::line_parts)
        throw DefError(fmt::format("the fault \"{}\": a broken line stays broken", fault));
    impl_->finish(index, role);
}

bool Run::active(std::string_view fault) const noexcept {
    for (std::size_t i = 0; i < impl_->exercise.faults.size(); ++i)
        if (impl_->exercise.faults[i].name == fault) return impl_->state.faults[i].active;
    return false;
}

double Run::shown(std::string_view output) const {
    if (const double value = impl_->state.scorer.frozen_value(output); !std::isnan(value))
        return value;
    const World& world = impl_->session.world();
    const OutputId id = world.find_output(output);
    if (id.valid()) return world.output(id);
    throw DefError(fmt::format("there is no output \"{}\"; nearest: \"{}\"", output,
                               record::nearest_name(output, output_names(world))));
}

void Run::before_step() {
    auto& state = impl_->state;
    const std::vector<scene::Operation>& levers = impl_->exercise.levers;
    for (; state.next_operation < levers.size() && levers[state.next_operation].at <= impl_->now();
         ++state.next_operation)
        for (const auto& [input, value] : levers[state.next_operation].set)
            impl_->ask(input, value);
    impl_->update_faults();
    state.levers.apply(impl_->session);
}

void Run::after_step() {
    auto& state = impl_->state;
    read_channels(impl_->channels, impl_->is_noted, impl_->session.world(), impl_->session.events(),
                  true, impl_->values);
    impl_->notes.values(impl_->is_noted, impl_->values);
    state.scorer.after_step(impl_->session.time(), impl_->values);
    add_sample(state.curves, state.every, state.seen, impl_->session.time(), impl_->values);
}

Status Run::step() {
    before_step();
    const Status status = impl_->session.step();
    if (status == Status::ok || status == Status::diverged) after_step();
    return status;
}

bool Run::ended() const noexcept { return impl_->state.scorer.ended(); }

void Run::end(const std::string& why, bool failed) {
    if (ended()) return;
    impl_->state.scorer.end(impl_->session.time(), why, failed);
    impl_->notes.end(why, failed);
}

const Result& Run::result() const noexcept { return impl_->state.scorer.result(); }
const Curves& Run::curves() const noexcept { return impl_->state.curves; }

int Run::mark() {
    if (impl_->saved_states.size() == kMaxMarks)
        throw DefError(fmt::format("an exercise has at most {} marks", kMaxMarks));
    impl_->saved_states.push_back(impl_->state);
    const int number = static_cast<int>(impl_->saved_states.size()) - 1;
    impl_->notes.number(NoteKind::mark, number);
    return number;
}

void Run::back_to(int mark) {
    if (mark < 0 || static_cast<std::size_t>(mark) >= impl_->saved_states.size())
        throw DefError(fmt::format("there is no mark {}", mark));
    impl_->state = impl_->saved_states[static_cast<std::size_t>(mark)];
    impl_->state.levers.forget_applied();
    impl_->state.scorer.restored(impl_->session.time());
    impl_->notes.number(NoteKind::back, mark);
}

}  // namespace hawser::exercise
