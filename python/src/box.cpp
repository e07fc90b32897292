// SPDX-License-Identifier: Apache-2.0
#include "box.h"

#include "memory.h"
#include "system.h"

#include <unistd.h>

#include <csignal>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <span>
#include <utility>

namespace hawser::python {
namespace {

constexpr std::size_t kMostEvents = 16'384;
/// Time between checks of signals [s]. Ctrl-C is honoured within 0.1 s.
constexpr double kCheckEvery = 0.02;
/// Duration of a step above which an interrupt handler is installed during the next one [s].
constexpr double kLongStep = 2e-3;

/// World whose step an interrupt cancels. One at a time: only the main thread sets it.
std::atomic<World*> interruptible{nullptr};
std::atomic<bool> interrupted{false};
void (*earlier_handler)(int) = nullptr;
/// World with a request to cancel that came after its last step; its next step is repeated.
const World* cancelled_late = nullptr;

extern "C" void cancel_step(int signal) {
    interrupted = true;
    if (World* const world = interruptible.load()) world->cancel();
    if (earlier_handler != nullptr && earlier_handler != SIG_IGN && earlier_handler != SIG_DFL)
        earlier_handler(signal);  // Python's, which notes the signal
}

/// Interrupt handler during long steps of the main thread.
class Interruptible {
  public:
    Interruptible(World& world, bool wanted) {
        if (!wanted || interruptible.load() != nullptr) return;
        struct sigaction ours{};
        if (sigaction(SIGINT, nullptr, &before_) != 0) return;
        if ((before_.sa_flags & SA_SIGINFO) != 0) return;
        earlier_handler = before_.sa_handler;
        if (earlier_handler == SIG_IGN || earlier_handler == SIG_DFL) return;
        ours.sa_handler = cancel_step;
        ours.sa_flags = before_.sa_flags;
        interruptible = &world;
        active_ = sigaction(SIGINT, &ours, nullptr) == 0;
        if (!active_) interruptible = nullptr;
    }
    ~Interruptible() {
        if (!active_) return;
        sigaction(SIGINT, &before_, nullptr);
        interruptible = nullptr;
    }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

  private:
    struct sigaction before_{};
    bool active_ = false;
};

/// Return true in the main thread, in which Python runs signal handlers.
bool is_main_thread() {
    static thread_local const int main = ::getpid() == ::gettid() ? 1 : 0;
    return main == 1;
}

std::span<const double> state_span(const StateView& state, StateArray which) {
    switch (which) {
        case StateArray::position:
            return state.positions;
        case StateArray::orientation:
            return state.orientations;
        case StateArray::velocity:
            break;
    }
    return state.velocities;
}

}  // namespace

StateMemory::StateMemory(StateArray what, const double* of, std::size_t n)
    : array(what), data(const_cast<double*>(of)), count(n) {
    pin(data);
}
StateMemory::~StateMemory() { unpin(data); }

WorldBox::WorldBox(World world)
    : own_(std::make_unique<World>(std::move(world))), world_(own_.get()) {}
WorldBox::WorldBox(std::unique_ptr<Session> session)
    : session_(std::move(session)), world_(&session_->world()) {}
WorldBox::~WorldBox() = default;

void WorldBox::check_thread() const {
    if (running_ && user_ != std::this_thread::get_id())
        throw UseError("the world is in use by another thread; let one thread at a time use it");
}

World& WorldBox::read() {
    check_thread();
    return *world_;
}

Session& WorldBox::session() {
    check_thread();
    if (!session_) throw DefError("this world belongs to no session");
    return *session_;
}

/// Marks the world as in use by this thread.
struct WorldBox::Running {
    explicit Running(WorldBox& of) : box(of) {
        box.running_ = true;
        box.user_ = std::this_thread::get_id();
    }
    ~Running() { box.running_ = false; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    WorldBox& box;
};

Status WorldBox::step_once(std::int64_t& left) {
    World& world = *world_;
    const bool wanted =
        is_main_thread() && (world.step_count() == 0 || world.stats().step_seconds > kLongStep);
    const Interruptible guard(world, wanted);
    const Running running(*this);
    const py::gil_scoped_release release;
    if (left == 1 && !session_) {
        --left;
        return world.step();
    }
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    Status status = Status::ok;
    while (left > 0 && status == Status::ok) {
        --left;
        status = session_ ? session_->step() : world.step();
        if (session_) {
            const auto fresh = session_->events();
            events_.insert(events_.end(), fresh.begin(), fresh.end());
        }
        if (interrupted ||
            std::chrono::duration<double>(Clock::now() - begin).count() > kCheckEvery)
            break;
    }
    return status;
}

void WorldBox::step(std::int64_t count) {
    check_thread();
    if (count < 0)
        throw py::value_error("the number of steps must be >= 0, it is " + std::to_string(count));
    if (running_) throw UseError("step: called from within a step; do it between steps");
    events_.clear();
    std::int64_t left = count;
    while (left > 0) {
        interrupted = false;
        const Status status = step_once(left);
        refresh_arrays();
        const bool late = status == Status::cancelled && cancelled_late == world_;
        if (late) cancelled_late = nullptr;
        if (interrupted && status != Status::cancelled) cancelled_late = world_;
        if (events_.size() > kMostEvents)
            events_.erase(events_.begin(),
                          events_.end() - static_cast<std::ptrdiff_t>(kMostEvents));
        if (error_) {
            const std::unique_ptr<py::error_already_set> error = std::move(error_);
            throw py::error_already_set(*error);
        }
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (status == Status::cancelled && (interrupted || late)) {
            ++left;  // The handler of the signal went on: so does the run, with the same step.
            continue;
        }
        if (status == Status::ok) continue;
        std::string message;
        if (session_ && !session_->objection().empty())
            message = session_->objection();
        else if (status == Status::bad_load || status == Status::bad_edit)
            message = to_string(world_->bad_load(), *world_);
        else if (status == Status::over_bound)
            message = to_string(world_->stats().bound_met);
        else if (status == Status::diverged)
            message = remedy(world_->verdict().judge);
        throw StepFailed{to_string(status), message};
    }
}

void WorldBox::refresh_arrays() {
    if (memories_.empty()) return;
    std::erase_if(memories_, [](const auto& memory) { return memory.expired(); });
    const StateView state = world_->state().arrays();
    for (const auto& weak : memories_) {
        const auto memory = weak.lock();
        if (!memory) continue;
        const auto now = state_span(state, memory->array);
        const auto i = static_cast<std::size_t>(memory->array);
        if (now.data() == memory->data) continue;
        if (present_[i].lock() == memory) arrays_[i] = py::object();
        // Only memory that the world has released: it may use the other for something else.
        if (orphaned(memory->data))
            std::copy_n(now.data(), std::min(now.size(), memory->count), memory->data);
    }
}

py::object WorldBox::array(StateArray which) {
    const auto now = state_span(read().state().arrays(), which);
    const auto i = static_cast<std::size_t>(which);
    if (const auto memory = present_[i].lock();
        memory && arrays_[i] && memory->data == now.data() && memory->count == now.size())
        return arrays_[i];
    const auto n = static_cast<py::ssize_t>(now.size());
    std::vector<py::ssize_t> shape{n};
    if (which == StateArray::position) shape = {n / 3, 3};
    if (which == StateArray::orientation) shape = {n / 4, 4};
    if (n == 0) return py::array_t<double>(shape);
    auto memory = std::make_shared<StateMemory>(which, now.data(), now.size());
    memories_.push_back(memory);
    present_[i] = memory;
    const double* const data = memory->data;
    const py::capsule owner(new std::shared_ptr<StateMemory>(std::move(memory)),
                            [](void* p) { delete static_cast<std::shared_ptr<StateMemory>*>(p); });
    py::array_t<double> made(shape, data, owner);
    made.attr("flags").attr("writeable") = false;
    arrays_[i] = made;
    return made;
}

void WorldBox::adopt_bridges() {
    for (int i = 0; i < world_->system_count(); ++i)
        if (auto* const bridge = dynamic_cast<SystemBridge*>(&world_->system(i)))
            bridge->enter(*this);
}

void WorldBox::fail(py::error_already_set error) {
    if (!error_) error_ = std::make_unique<py::error_already_set>(std::move(error));
}

}  // namespace hawser::python
