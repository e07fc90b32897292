// SPDX-License-Identifier: Apache-2.0
#include "runtime/tasks.h"

#include "runtime/trace.h"

#include <hawser/def.h>

#include <pthread.h>
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <ctime>
#include <string>
#include <system_error>

namespace hawser {

ThreadError::ThreadError(int wanted, int started, const std::string& reason)
    : std::runtime_error("worker threads: " + std::to_string(started) + " of " +
                         std::to_string(wanted) + " could be started (" + reason +
                         "); ask for at most " + std::to_string(started + 1) +
                         " threads, or raise the limit of processes (ulimit -u, pids.max)"),
      wanted_(wanted),
      started_(started) {}

}  // namespace hawser

namespace hawser::runtime {
namespace {

inline void spin_pause() noexcept {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

/// Blocks signals in threads started while it lives. Handlers then run on the threads of the
/// program, whose data exist while they run.
class SignalsBlocked {
  public:
    SignalsBlocked() noexcept {
        sigset_t all;
        sigfillset(&all);
        for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT})
            sigdelset(&all, own);
        pthread_sigmask(SIG_BLOCK, &all, &before_);
    }
    ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsBlocked(const SignalsBlocked&) = delete;
    SignalsBlocked& operator=(const SignalsBlocked&) = delete;

  private:
    sigset_t before_{};
};

}  // namespace

Pool::Pool(int threads)
    : threads_(std::max(threads, 1)),
      parts_(std::make_unique<Part[]>(static_cast<std::size_t>(threads_))) {
    workers_.reserve(static_cast<std::size_t>(threads_ - 1));
    process_ = static_cast<int>(::getpid());
    const SignalsBlocked blocked;
    try {
        for (int t = 1; t < threads; ++t)
            workers_.emplace_back([this, t](const std::stop_token& stop) { work(stop, t); });
    } catch (const std::system_error& error) {
        const std::size_t started = workers_.size();
        end_workers();
        throw ThreadError(threads - 1, static_cast<int>(started), error.code().message());
    } catch (...) {
        end_workers();  // they sleep, and the destructor is not going to run
        throw;
    }
}

Pool::~Pool() { end_workers(); }

/// End the workers. A forked child has no workers, so a join would never return.
void Pool::end_workers() noexcept {
    if (static_cast<int>(::getpid()) != process_)
        for (std::jthread& w : workers_) w.detach();
    for (std::jthread& w : workers_) w.request_stop();
    awake_.fetch_add(2, std::memory_order_release);
    awake_.notify_all();
    workers_.clear();  // joins
}

void Pool::resume() noexcept {
    if (workers_.empty() || (awake_.load(std::memory_order_relaxed) & 1U) != 0) return;
    awake_.fetch_add(1, std::memory_order_release);
    awake_.notify_all();
}

void Pool::pause() noexcept {
    if (workers_.empty() || (awake_.load(std::memory_order_relaxed) & 1U) == 0) return;
    awake_.fetch_add(1, std::memory_order_release);
}

double Pool::cpu_seconds(int thread) noexcept {
    clockid_t clock = CLOCK_THREAD_CPUTIME_ID;
    if (thread > 0) {
        const auto worker = workers_[static_cast<std::size_t>(thread - 1)].native_handle();
        if (pthread_getcpuclockid(worker, &clock) != 0) return 0.0;
    }
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Run tasks of a part until none are left. @return the number of tasks that this thread has run.
int Pool::run_remaining_tasks(Part& part, int thread) noexcept {
    int worked = 0;
    std::uint64_t ticket = part.ticket.load(std::memory_order_acquire);
    for (;;) {
        const std::uint64_t index = ticket & kTicketClosed;
        const Task task = task_.load(std::memory_order_acquire);
        void* const context = context_.load(std::memory_order_acquire);
        const std::int32_t end = part.end.load(std::memory_order_acquire);
        if (index == kTicketClosed || static_cast<std::int64_t>(index) >= end) return worked;
        if (!part.ticket.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel,
                                               std::memory_order_acquire))
            continue;
        task(context, static_cast<int>(index), thread);
        ++worked;
        ticket = part.ticket.load(std::memory_order_acquire);
    }
}

/// Run tasks until none remain, starting with the part of this thread. A batch of tasks ends only
/// after this function has added its count, so that every count belongs to one batch.
void Pool::run_remaining_tasks(int thread) noexcept {
    int worked = 0;
    for (int p = 0; p < threads_; ++p)
        worked +=
            run_remaining_tasks(parts_[static_cast<std::size_t>((thread + p) % threads_)], thread);
    if (worked > 0) done_.fetch_add(worked, std::memory_order_release);
}

void Pool::run(int count, Task task, void* context) noexcept {
    if (trace_ == nullptr)
        distribute_tasks(count, task, context);
    else
        distribute_recorded_tasks(count, task, context);
}

void Pool::distribute_recorded_tasks(int count, Task task, void* context) noexcept {
    struct Recorded {
        Trace& trace;
        Task task;
        void* context;
        TraceSpan span_template;
    } r{*trace_, task, context, {}};
    r.span_template.step = trace_->step;
    r.span_template.stage = trace_->stage;
    r.span_template.loop = trace_->loops++;
    TraceSpan loop = r.span_template;
    loop.kind = SpanKind::loop;
    loop.task = count;
    loop.begin = trace_->now();
    distribute_tasks(
        count,
        [](void* c, int i, int thread) noexcept {
            const Recorded& recorded = *static_cast<const Recorded*>(c);
            TraceSpan span = recorded.span_template;
            span.task = i;
            span.thread = thread;
            recorded.trace.task(span, [&] { recorded.task(recorded.context, i, thread); });
        },
        &r);
    loop.end = trace_->now();
    trace_->push(loop);
}

void Pool::announce(const base::TaskOrder& order) noexcept {
    if (trace_ != nullptr) trace_->announce(order);
}

void Pool::begin_node(int node, int thread) noexcept {
    if (trace_ != nullptr) trace_->begin_node(node, thread);
}

void Pool::distribute_tasks(int count, Task task, void* context) noexcept {
    if (workers_.empty() || count <= 1 || (awake_.load(std::memory_order_relaxed) & 1U) == 0) {
        for (int i = 0; i < count; ++i) task(context, i, 0);
        return;
    }
    const std::uint64_t batch = opened_.load(std::memory_order_relaxed) + kTicketClosed + 1;
    const auto parts = static_cast<std::size_t>(threads_);
    const auto begin_of = [&](std::size_t p) {
        return static_cast<std::size_t>(count) * p / parts;
    };
    for (std::size_t p = 0; p < parts; ++p)
        parts_[p].ticket.store(batch | kTicketClosed, std::memory_order_release);
    task_.store(task, std::memory_order_release);
    context_.store(context, std::memory_order_release);
    done_.store(0, std::memory_order_release);
    for (std::size_t p = 0; p < parts; ++p) {
        parts_[p].end.store(static_cast<std::int32_t>(begin_of(p + 1)), std::memory_order_release);
        parts_[p].ticket.store(batch | begin_of(p), std::memory_order_release);
    }
    opened_.store(batch, std::memory_order_release);
    run_remaining_tasks(0);
    for (int spins = 0; done_.load(std::memory_order_acquire) != count; ++spins) {
        if (spins < 2'000)
            spin_pause();
        else
            std::this_thread::yield();  // fewer cores than threads
    }
}

void Pool::work(const std::stop_token& stop, int thread) noexcept {
    int idle = 0;
    std::uint64_t seen = 0;
    for (;;) {
        // Read before the stop flag. A later stop request changes this number, so that the wait
        // below returns at once.
        const std::uint32_t awake = awake_.load(std::memory_order_acquire);
        if (stop.stop_requested()) return;
        if (const std::uint64_t batch = opened_.load(std::memory_order_acquire); batch != seen) {
            run_remaining_tasks(thread);
            seen = batch;
            idle = 0;
            continue;
        }
        if ((awake & 1U) == 0) {
            awake_.wait(awake, std::memory_order_acquire);
            idle = 0;
        } else if (++idle < 20'000) {
            spin_pause();
        } else {
            std::this_thread::yield();
        }
    }
}

}  // namespace hawser::runtime
