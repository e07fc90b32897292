// SPDX-License-Identifier: Apache-2.0
#include "world/systems.h"

#include <hawser/world.h>

#include "base/hash.h"
#include "context/guarded.h"
#include "world/checks.h"
#include "world/nearest.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <string>
#include <utility>

namespace hawser::world {
namespace {

/// A visitor that calls f for each array.
template <class F>
class Visitor final : public StateVisitor {
  public:
    Visitor(bool around_step, F f) : around_step_(around_step), callback_(std::move(f)) {}
    [[nodiscard]] bool around_step() const noexcept override { return around_step_; }

  private:
    void bytes(void* data, std::size_t size) override { callback_(data, size); }
    bool around_step_;
    F callback_;
};

/// Finds a number of a state from which no system can continue.
class NumberCheck final : public StateVisitor {
  public:
    [[nodiscard]] bool all_finite() const noexcept { return all_finite_; }

  private:
    void bytes(void*, std::size_t) override {}
    void numbers(std::span<double> values) override {
        constexpr double kMaxNumber = 1e300;
        for (const double x : values) all_finite_ = all_finite_ && std::abs(x) <= kMaxNumber;
    }
    bool all_finite_ = true;
};

/// Call f(data, bytes) for each array of a system's state.
template <class F>
void visit(System& system, bool around_step, F&& f) {
    Visitor visitor(around_step, [&f](void* data, std::size_t size) { f(data, size); });
    system.visit_state(visitor);
}

std::string full_name(const SystemSignal& s) { return s.system + "." + s.name; }

}  // namespace

namespace {

/// Keeps the applied forces as set while it lives, because inputs may change them.
class UnrotatedForces {
  public:
    explicit UnrotatedForces(InputAccess& door) noexcept : input_access_(door) {
        door.unrotate_forces();
    }
    ~UnrotatedForces() { input_access_.rotate_forces(); }
    UnrotatedForces(const UnrotatedForces&) = delete;
    UnrotatedForces& operator=(const UnrotatedForces&) = delete;

  private:
    InputAccess& input_access_;
};

}  // namespace

/// Access of a system through its Prestep.
class Systems::StepAccess final : public Prestep::Hands {
  public:
    StepAccess(Systems& of, context::StepContext& ctx) : systems_(of), ctx_(ctx) {}
    void set_input(InputId id, double value) noexcept override {
        InputAccess::Before before;
        if (!systems_.input_access_.set(id, value, before)) {
            if (systems_.bad.reason[0] != '\0') return;
            systems_.bad.of_input = true;
            systems_.bad.input = id;
            systems_.bad.reason = std::isfinite(value)
                                      ? "there is no such input; give an id of the world"
                                      : "it is not finite; give a finite value";
            return;
        }
        for (const std::int32_t body : before.body)
            if (before.moved && body >= 0) ctx_.state.loads.alter(body);
        for (InputAccess::Before& earlier : systems_.set_) {
            if (earlier.input != before.input) continue;
            earlier.asked = before.asked;
            earlier.clamped = before.clamped;
            return;
        }
        systems_.set_.push_back(before);  // act() has reserved capacity for one of each
    }
    void tell(EventKind kind, BodyId body, InteractionId interaction,
              double value) noexcept override {
        Event event;
        event.time = ctx_.state.time;
        event.kind = kind;
        event.body = body;
        event.interaction = interaction;
        event.value = value;
        try {
            systems_.reported_.push_back(event);
        } catch (const std::bad_alloc&) {
            systems_.events_dropped_ = true;  // no event is lost: the step ends and is retried
        }
    }
    void run(int count, void (*task)(void*, int) noexcept, void* context) noexcept override {
        ctx_.state.loads.share(true);
        auto one = [&](int i, int) noexcept { task(context, i); };
        ctx_.pool.for_each(count, one);
        ctx_.state.loads.share(false);
    }

  private:
    Systems& systems_;
    context::StepContext& ctx_;
};

System& Systems::add(std::unique_ptr<System> system) {
    if (!system) throw DefError("add_system: there is no system; give one");
    const std::string name(system->name());
    if (name.empty()) throw DefError("a system needs a name");
    if (find(name) != nullptr)
        throw DefError("system '" + name + "': the name is in use; names must be unique");
    std::vector<SystemSignal> all = signals_;
    SignalTable table(name, all);
    system->signals(table);
    for (std::size_t i = signals_.size(); i < all.size(); ++i) {
        if (all[i].name.empty()) throw DefError("system '" + name + "': a signal has no name");
        for (std::size_t j = signals_.size(); j < i; ++j)
            if (all[i].name == all[j].name)
                throw DefError("system '" + name + "': signal '" + all[i].name +
                               "' is listed twice; names are unique in a system");
    }
    list_.push_back(std::move(system));
    // No call below throws.
    signals_.swap(all);
    return *list_.back();
}

std::unique_ptr<System> Systems::remove(const System& system) {
    const auto found =
        std::find_if(list_.begin(), list_.end(), [&](const auto& s) { return s.get() == &system; });
    if (found == list_.end()) throw DefError("remove_system: it is none of this world's systems");
    std::unique_ptr<System> out = std::move(*found);
    list_.erase(found);
    discard_actions();
    std::erase_if(signals_, [&](const SystemSignal& s) { return s.system == out->name(); });
    if (bad.system == out->name()) bad = {};
    return out;
}

System* Systems::find(std::string_view name) const noexcept {
    for (const auto& s : list_)
        if (s->name() == name) return s.get();
    return nullptr;
}

const SystemSignal& Systems::signal(std::string_view name) const {
    std::vector<std::string> names;
    for (const SystemSignal& s : signals_)
        if (names.emplace_back(full_name(s)) == name) return s;
    std::vector<const char*> known;
    for (const std::string& each : names) known.push_back(each.c_str());
    throw DefError("there is no signal '" + std::string(name) + "'" +
                   (known.empty() ? ": no system has one" : name_suggestion(name, known)));
}

void Systems::save_states_to(std::vector<std::byte>& to) const {
    std::size_t size = 0;
    for (const auto& s : list_) visit(*s, true, [&](void*, std::size_t n) { size += n; });
    if (to.size() < size) to.resize(size);
    std::byte* next = to.data();
    for (const auto& s : list_)
        visit(*s, true, [&](const void* from, std::size_t n) {
            if (n > 0) std::memcpy(next, from, n);
            next += n;
        });
}

void Systems::restore_states(const std::vector<std::byte>& from) const {
    const std::byte* next = from.data();
    for (const auto& s : list_)
        visit(*s, true, [&](void* to, std::size_t n) {
            if (n > 0) std::memcpy(to, next, n);
            next += n;
        });
}

Status Systems::act_all(context::StepContext& ctx) {
    save_states_to(saved_states_);
    if (set_.capacity() < input_access_.count()) set_.reserve(input_access_.count());
    constexpr std::size_t kEventsOfOne = 8;
    if (reported_.capacity() < kEventsOfOne * list_.size())
        reported_.reserve(kEventsOfOne * list_.size());
    drive_ = ctx.state.ledger.drive;
    acted_ = true;
    const UnrotatedForces unrotated(input_access_);
    if (pending_action_.is_known) {
        repeat_action(ctx);
        return ctx.state.loads.out_of_memory() ? Status::out_of_memory : Status::ok;
    }
    StepAccess hands(*this, ctx);
    Prestep now(*world_, ctx.state.time, ctx.model.def.step, ctx.state.step, hands, queue_);
    Loads loads(ctx.state.loads);
    for (std::size_t i = 0; i < list_.size(); ++i) {
        ctx.state.loads.begin_system(static_cast<int>(i), list_[i]->is_water());
        queue_.begin_system(list_[i]->name());
        const std::size_t inputs = set_.size();
        list_[i]->prestep(now, loads);
        if (ctx.state.loads.out_of_memory() || queue_.out_of_memory() || events_dropped_)
            return Status::out_of_memory;
        if (bad.reason[0] == '\0' && ctx.state.loads.touched())
            bad = ctx.state.loads.fault(ctx.pool);
        check_ranges(inputs);
        if (bad.reason[0] == '\0') continue;
        bad.system = list_[i]->name();
        return Status::bad_load;
    }
    if (queue_.size() == 0) return Status::ok;
    save_action(ctx);
    return Status::bad_edit;
}

/// Check the inputs that were set from entry `first` of set_ on. Report in `bad` the first one that
/// sets a minimum above its maximum.
void Systems::check_ranges(std::size_t first) noexcept {
    for (std::size_t i = first; i < set_.size() && bad.reason[0] == '\0'; ++i) {
        if (!input_access_.leaves_empty_range(set_[i].input)) continue;
        bad.of_input = true;
        bad.input = input_access_.id_of(set_[i].input);
        bad.reason =
            "its range would be empty: the minimum is above the maximum; set the other end";
    }
}

Status Systems::act(context::StepContext& ctx) noexcept {
    bad = {};
    events_dropped_ = false;
    Status status = Status::ok;
    const Status room = context::guarded(ctx, [&] { status = act_all(ctx); });
    return room == Status::ok ? status : room;
}

void Systems::accept(context::StepContext& ctx) noexcept {
    for (const Event& event : reported_) {
        ctx.state.events.push(event);
        ++ctx.work.stats.event_count[static_cast<std::size_t>(event.kind)];
    }
    reported_.clear();
    for (const InputAccess::Before& before : set_)
        if (before.clamped) input_access_.tell(before);
    set_.clear();
    discard_actions();
    acted_ = false;
}

void Systems::go_back(context::StepContext& ctx) noexcept {
    if (!acted_) return;
    const UnrotatedForces unrotated(input_access_);
    for (auto before = set_.rbegin(); before != set_.rend(); ++before)
        input_access_.take_back(*before);
    set_.clear();
    reported_.clear();
    ctx.state.ledger.drive = drive_;
    restore_states(saved_states_);
    acted_ = false;
}

std::uint64_t Systems::no_layout() noexcept { return base::kFnvStart; }

std::uint64_t Systems::layout() const {
    std::uint64_t h = no_layout();
    for (const auto& s : list_) {
        const std::string_view name = s->name();
        h = base::fnv1a(name.data(), name.size(), h);
        std::uint64_t size = 0, arrays = 0;
        visit(*s, false, [&](void*, std::size_t n) {
            size += n;
            ++arrays;
        });
        h = base::fnv1a(&size, sizeof size, h);
        h = base::fnv1a(&arrays, sizeof arrays, h);
    }
    return h;
}

std::size_t Systems::state_bytes() const {
    std::size_t sum = 0;
    for (const auto& s : list_) visit(*s, false, [&](void*, std::size_t n) { sum += n; });
    return sum;
}

void Systems::save(std::byte* to) const {
    for (const auto& s : list_)
        visit(*s, false, [&](const void* from, std::size_t n) {
            if (n > 0) std::memcpy(to, from, n);
            to += n;
        });
}

void Systems::restore(const std::byte* from) {
    for (const auto& s : list_)
        visit(*s, false, [&](void* to, std::size_t n) {
            if (n > 0) std::memcpy(to, from, n);
            from += n;
        });
}

void Systems::check_states(const World& world) const {
    const auto throw_def_error = [](std::string_view system, const std::string& what) {
        throw DefError("snapshot: not a state that a world can have: system '" +
                       std::string(system) + "': " + what);
    };
    for (const auto& s : list_) {
        NumberCheck numbers;
        s->visit_state(numbers);
        if (!numbers.all_finite())
            throw_def_error(s->name(), "a number is not finite, or beyond 1e300");
    }
    for (const SystemSignal& s : signals_)
        if (s.input && !(*s.value >= s.min && *s.value <= s.max))
            throw_def_error(s.system, "input '" + s.name + "' is outside its range");
    for (const auto& s : list_) {
        StateRules rules;
        s->check_state(world, rules);
        if (*rules.fault() != '\0') throw_def_error(s->name(), rules.fault());
    }
}

std::uint64_t Systems::hash(std::uint64_t h) const {
    for (const auto& s : list_)
        visit(*s, false, [&](const void* data, std::size_t n) { h = base::fnv1a(data, n, h); });
    return h;
}

}  // namespace hawser::world
