// SPDX-License-Identifier: Apache-2.0
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "record/control.h"
#include "record/csv.h"
#include "record/host.h"
#include "record/names.h"
#include "record/recording_listener.h"
#include "record/recording_writer.h"
#include "record/scene_info.h"
#include "record/snapshot_file.h"
#include "session/control_ranges.h"
#include "session/run_notes.h"
#include "session/timeline.h"
#include "verify/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <utility>

namespace hawser {

struct Session::Impl {
    /// A file that gets the state at a fixed stride of steps.
    template <class Writer>
    struct Output {
        std::unique_ptr<Writer> to;
        std::int64_t every = 1, begun = 0, written = 0;  ///< Numbers of steps.
        [[nodiscard]] bool is_due(const World& world) const {
            return to && (world.step_count() - begun) % every == 0;
        }
        [[nodiscard]] bool is_behind(const World& world) const {
            return to && world.step_count() != written;
        }
    };

    scene::Scene scene;
    record::SceneInfo info;
    std::vector<record::ControlChange> control;
    std::size_t next_control = 0;  ///< The first one that is not in force yet.
    session::Timeline timeline;
    std::uint64_t identity = 0;    ///< Identity of the scene at its start …
    Structure made_of;             ///< … and its structure if it begins with a saved state …
    std::vector<std::byte> start;  ///< … and its state.
    /// Differences of the scene from that of the saved state.
    std::vector<std::string> differences;
    /// Columns of a control file: the inputs by index, then these signals.
    std::vector<std::string> signals;
    std::size_t places = 0;
    Output<record::RecordingWriter> recording;
    std::unique_ptr<record::RecordingListener> listener;  ///< Listener of the recording.
    session::RunNotes notes;
    Output<record::CsvWriter> table;
    std::unique_ptr<verify::Verifier> verifier;
    std::vector<Observer*> observers;
    std::vector<Event> events;
    std::string objection;
    Status last = Status::ok;
    double step_cpu = 0.0;  ///< CPU time of the stepping thread in the last step [s].

    explicit Impl(scene::Scene given)
        : scene(std::move(given)), info(record::make_scene_info(scene)) {}
    [[nodiscard]] World& world() noexcept { return scene.world; }

    /// Apply the values of the control file until now.
    void apply_controls() {
        constexpr double kSlack = 1e-6;  // Times are multiples of the step up to rounding.
        World& w = world();
        const double now = w.time() + kSlack * w.settings().step;
        for (; next_control < control.size() && control[next_control].time <= now; ++next_control)
            set(control[next_control]);
    }

    void set(const record::ControlChange& change) {
        World& w = world();
        const auto signal = static_cast<std::size_t>(change.input) - places;
        if (static_cast<std::size_t>(change.input) >= places)
            set_signal(signals[signal], change.value);
        else if (const InputId id{change.input}; w.alive(id))
            w.set_input(id, change.value);  // others have been removed
    }

    /// Return the name of a control file's target in the timeline.
    [[nodiscard]] std::string target(const record::ControlChange& change) {
        if (static_cast<std::size_t>(change.input) < places)
            return world().input_def(InputId{change.input}).name;
        const std::string& name = signals[static_cast<std::size_t>(change.input) - places];
        for (const scene::SignalInput& lever : scene.signal_inputs)
            if (lever.name == name) return lever.signal;
        return name;
    }

    /// Apply the last value of each input before the start of a run that begins later, unless the
    /// timeline has set it since. Apply only that one, because the state may already contain it,
    /// and earlier values would wake sleeping bodies.
    void apply_earlier_controls() {
        if (world().step_count() == 0) return;
        const double done = session::operations_done_until(world());
        while (next_control < control.size() && control[next_control].time <= done) ++next_control;
        for (std::size_t i = 0; i < next_control; ++i) {
            const record::ControlChange& change = control[i];
            const bool later = std::any_of(
                control.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                control.begin() + static_cast<std::ptrdiff_t>(next_control),
                [&](const record::ControlChange& c) { return c.input == change.input; });
            if (!later && !timeline.sets(scene.timeline, target(change), change.time)) set(change);
        }
    }

    /// Set a signal by its own name, or by that of an input of the scene. @return false if no
    /// system has such an input (any more).
    bool set_signal(std::string name, double value) {
        for (const scene::SignalInput& input : scene.signal_inputs) {
            if (input.name != name) continue;
            name = input.signal;
            value = input.factor * std::clamp(value, input.min, input.max);
            break;
        }
        for (const SystemSignal& s : world().system_signals()) {
            if (!s.input || s.system + "." + s.name != name) continue;
            world().set_system_signal(name, value);
            if (recording.to) notes.signal(world(), *recording.to, name, value);
            return true;
        }
        return false;
    }

    void open_recording(const std::filesystem::path& file, std::int32_t every);

    void add_frame() {
        recording.to->add_frame(world());
        recording.written = world().step_count();
    }
    void add_row() {
        table.to->add_row(world());
        table.written = world().step_count();
    }

    /// Write the work that the last step left out, its events, and a frame if one is due.
    void write_step() {
        if (recording.to) {
            if (const StepStats& stats = world().stats(); stats.degradation.any())
                recording.to->add_cut(
                    {stats.step - 1, stats.degradation, stats.degraded_by, stats.foreseen_seconds});
            recording.to->add_loads(world());
            for (const Event& event : events) recording.to->add_event(world(), event);
        }
        if (recording.is_due(world())) add_frame();
        if (table.is_due(world())) add_row();
    }
};

namespace {
/// Return the CPU time of the calling thread [s].
double thread_cpu_seconds() noexcept {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

scene::Scene scene_of(const SessionDef& def) {
    if (!def.scene.empty() && !def.scene_text.empty())
        throw DefError("a session has one scene: give a file or a text, not both");
    if (def.scene.empty() && def.scene_text.empty())
        throw DefError("a session needs a scene: a file, a text, or a world");
    return def.scene.empty() ? scene::load_text(def.scene_text, "scene", def.options)
                             : scene::load_file(def.scene, def.options);
}

scene::Scene scene_from_world(World world) {
    scene::Scene scene;
    scene.world = std::move(world);
    return scene;
}

/// Return the names of inputs by index; "" at vacant indices.
std::vector<std::string> input_names(const World& world) {
    std::vector<std::string> names(static_cast<std::size_t>(world.input_count()));
    for (const InputId id : world.inputs())
        names[static_cast<std::size_t>(id.index)] = world.input_def(id).name;
    return names;
}

/// Return the inputs of systems, as "system.signal", and those of the scene that set them.
std::vector<std::string> signal_names(const scene::Scene& scene) {
    const World& world = scene.world;
    std::vector<std::string> names;
    for (const scene::SignalInput& input : scene.signal_inputs) names.push_back(input.name);
    for (const SystemSignal& s : world.system_signals())
        if (s.input) names.push_back(s.system + "." + s.name);
    return names;
}

void check_every(std::int32_t every) {
    if (every < 1 || every > 1'000'000)
        throw DefError(fmt::format("a session writes every 1 to 10⁶ steps, not every {}", every));
}

}  // namespace

Session::Session(const SessionDef& def) : Session(scene_of(def), def) {}

Session::Session(World world, const SessionDef& def)
    : Session(scene_from_world(std::move(world)), def) {}

Session::Session(scene::Scene scene, const SessionDef& def)
    : impl_(std::make_unique<Impl>(std::move(scene))) {
    World& world = impl_->world();
    check_every(def.every);
    world.prepare();
    impl_->identity = world.state().identity();
    if (def.verify) impl_->verifier = std::make_unique<verify::Verifier>(world);
    if (!def.restore.empty()) {
        impl_->made_of = world.state().structure();
        impl_->start = world.state().save();
        impl_->differences = record::restore_snapshot(def.restore, impl_->info, world);
    }
    if (!def.state.empty()) world.state().restore(def.state);
    impl_->timeline.skip(impl_->scene.timeline, world);
    if (!def.control.empty()) {
        std::vector<std::string> names = input_names(world);
        impl_->places = names.size();
        impl_->signals = signal_names(impl_->scene);
        names.insert(names.end(), impl_->signals.begin(), impl_->signals.end());
        impl_->control = record::read_control(def.control, names,
                                              session::control_ranges(impl_->scene, impl_->places));
        impl_->apply_earlier_controls();
    }
    if (!def.record.empty()) record(def.record, def.every);
    if (!def.csv.empty()) write_csv(def.csv, def.every);
    if (def.verify) {
        impl_->verifier->begin_at(world);
        observe(*impl_->verifier);
    }
}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const scene::Scene& Session::scene() const noexcept { return impl_->scene; }
const World& Session::world() const noexcept { return impl_->scene.world; }
World& Session::world() noexcept { return impl_->scene.world; }
double Session::time() const noexcept { return impl_->scene.world.time(); }
std::span<const Event> Session::events() const noexcept { return impl_->events; }
std::span<const scene::Operation> Session::operations() const noexcept {
    return impl_->timeline.performed(impl_->scene.timeline);
}
const std::string& Session::objection() const noexcept { return impl_->objection; }
std::span<const std::string> Session::differences() const noexcept { return impl_->differences; }
void Session::cancel() noexcept { impl_->world().cancel(); }

void Session::set_input(std::string_view name, double value) {
    const InputId id = world().find_input(name);
    if (id.valid()) return impl_->world().set_input(id, value);
    if (impl_->set_signal(std::string(name), value)) return;
    std::vector<std::string> names = input_names(world());
    std::erase(names, "");
    for (std::string& signal : signal_names(impl_->scene)) names.push_back(std::move(signal));
    throw DefError(names.empty() ? fmt::format("there is no input \"{}\": the scene has none", name)
                                 : fmt::format("there is no input \"{}\"; nearest: \"{}\"", name,
                                               record::nearest_name(name, names)));
}

void Session::restore(const Structure& made_of, std::span<const std::byte> state) {
    World& world = impl_->world();
    world.state().restore(made_of, state);
    impl_->notes.clear();
    impl_->timeline.skip(impl_->scene.timeline, world);
    // Values before the step that led to this state were in force in it.
    const double last = session::operations_done_until(world);
    const auto& control = impl_->control;
    const auto next = std::find_if(control.begin(), control.end(), [&](const auto& change) {
        return world.step_count() == 0 || change.time > last;
    });
    impl_->next_control = static_cast<std::size_t>(next - control.begin());
    impl_->last = Status::ok;
    impl_->objection.clear();
    if (impl_->verifier) impl_->verifier->begin_at(world);
}

void Session::record(const std::filesystem::path& file, std::int32_t every) {
    check_every(every);
    impl_->listener.reset();
    World& world = impl_->world();
    // A recording begins with the world of its scene. Other objects came with a saved state, with
    // which the recording continues (chunk TAKE).
    if (impl_->start.empty() || world.state().identity() == impl_->identity)
        return impl_->open_recording(file, every);
    const Structure made_of = world.state().structure();
    const std::vector<std::byte> state = world.state().save();
    world.state().restore(impl_->made_of, impl_->start);
    try {
        impl_->open_recording(file, every);
    } catch (...) {
        world.state().restore(made_of, state);
        throw;
    }
    restore(made_of, state);
}

void Session::Impl::open_recording(const std::filesystem::path& file, std::int32_t every) {
    World& world = this->world();
    const WorldDef& settings = world.settings();
    notes.clear();
    recording = {std::make_unique<record::RecordingWriter>(
                     file, info, world,
                     record::RecordingSettings{.step = settings.step,
                                               .form = settings.form,
                                               .threads = settings.threads,
                                               .stride = every,
                                               .instruction_set = instruction_set(),
                                               .version = version(),
                                               .processor = record::processor_model()}),
                 every, world.step_count(), world.step_count()};
    listener = std::make_unique<record::RecordingListener>(*recording.to, world);
}

void Session::write_csv(const std::filesystem::path& file, std::int32_t every) {
    check_every(every);
    const World& world = impl_->world();
    impl_->table = {std::make_unique<record::CsvWriter>(file, impl_->info, world), every,
                    world.step_count(), world.step_count()};
    if (world.step_count() > 0) impl_->add_row();  // tensions are unknown before the first step
}

void Session::note(std::string_view kind, std::span<const std::byte> bytes) {
    constexpr std::size_t kMaxKind = 32;
    if (kind.empty() || kind.size() > kMaxKind)
        throw DefError("the kind of a note has 1 to 32 bytes");
    if (!impl_->recording.to) return;
    if (impl_->listener) impl_->listener->flush();
    impl_->recording.to->add_note(world().step_count(), kind, bytes);
}

double Session::step_cpu_seconds() const noexcept { return impl_->step_cpu; }

void Session::observe(Observer& observer) { impl_->observers.push_back(&observer); }

void Session::save(const std::filesystem::path& file) const {
    record::save_snapshot(file, impl_->info, world(),
                          world().state().identity() != impl_->identity);
}

Status Session::step() {
    World& world = impl_->world();
    impl_->last = Status::bad_edit;  // should that throw
    impl_->timeline.perform_due(impl_->scene.timeline, world);
    if (impl_->recording.to) impl_->notes.operations(world, *impl_->recording.to, operations());
    impl_->apply_controls();
    if (impl_->listener) impl_->listener->flush();
    for (Observer* observer : impl_->observers) observer->before_step(world);
    const std::int64_t step = world.step_count();
    const double cpu = thread_cpu_seconds();
    impl_->last = world.step();
    impl_->step_cpu = thread_cpu_seconds() - cpu;
    // Changes of systems within the step belong before it.
    if (impl_->listener) impl_->listener->flush(step);
    if (impl_->last != Status::ok) return impl_->last;
    impl_->events = world.events().take();
    impl_->write_step();
    for (Observer* observer : impl_->observers) {
        observer->after_step(world, impl_->events);
        if (impl_->objection.empty()) impl_->objection = observer->objection();
    }
    return impl_->objection.empty() ? Status::ok : Status::diverged;
}

record::Ending Session::finish(bool interrupted) {
    const World& world = impl_->world();
    record::Ending ending = record::Ending::finished;
    if (interrupted || impl_->last == Status::cancelled)
        ending = record::Ending::interrupted;
    else if (impl_->last != Status::ok || !impl_->objection.empty() ||
             (world.settings().on_diverged == OnDiverged::stop &&
              world.verdict().grade == Grade::wrong))
        ending = record::Ending::failed;
    if (impl_->listener) impl_->listener->flush();
    if (impl_->recording.is_behind(world)) impl_->add_frame();
    if (impl_->table.is_behind(world)) impl_->add_row();
    if (impl_->recording.to) impl_->recording.to->finish(world, ending);
    if (impl_->table.to) impl_->table.to->finish();
    impl_->listener.reset();
    impl_->recording.to.reset();
    impl_->table.to.reset();
    return ending;
}

}  // namespace hawser
