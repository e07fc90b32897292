// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file use.h
/// Exclusive use of a world by one thread. A call that steps or changes the world marks it as in
/// use. A call by a second thread, or a change from a callback within a step, is rejected before it
/// reads or writes anything. The mark is one atomic exchange, about ten nanoseconds.

#include <hawser/def.h>

#include <pthread.h>

#include <atomic>
#include <string>

namespace hawser::world {

class Use {
  public:
    /// Try to lock the world.
    /// @return 0: rejected, 1: granted, 2: granted within a call of the same thread.
    int take() noexcept {
        const pthread_t me = this_thread();
        pthread_t user = kNoThread;
        if (user_.compare_exchange_strong(user, me, std::memory_order_acquire)) {
            changed_ = true;
            return 1;
        }
        return user == me && !stepping_ ? 2 : 0;
    }
    void leave() noexcept { user_.store(kNoThread, std::memory_order_release); }
    /// Mark the start or end of a step, by the thread that uses the world.
    void mark_stepping(bool on) noexcept { stepping_ = on; }
    [[nodiscard]] bool is_used_by_this_thread() const noexcept {
        return user_.load(std::memory_order_relaxed) == this_thread();
    }

    /// True if the state may have changed since the last call of unchanged(). Derived data are then
    /// computed again on request.
    [[nodiscard]] bool changed() const noexcept { return changed_; }
    void unchanged() noexcept { changed_ = false; }

  private:
    /// Return the identifier of the calling thread. A thread_local mark is not possible: mold
    /// misplaces read-only data of a program after a one-byte mark, and the program does not start.
    static pthread_t this_thread() noexcept { return ::pthread_self(); }
    static constexpr pthread_t kNoThread = 0;  ///< thread ids of glibc are addresses
    std::atomic<pthread_t> user_{kNoThread};
    bool stepping_ = false;  ///< Read and written only by the thread that uses the world.
    bool changed_ = true;
};

/// A call that changes a world or computes in it.
/// @throws UseError if it is in use.
class Using {
  public:
    Using(Use& use, const char* call) : use_(use), granted_(use.take()) {
        if (granted_ == 0) throw_def_error(call);
    }
    ~Using() {
        if (granted_ == 1) use_.leave();
    }
    Using(const Using&) = delete;
    Using& operator=(const Using&) = delete;

  private:
    [[noreturn]] void throw_def_error(const char* call) const {
        throw UseError(std::string(call) +
                       (use_.is_used_by_this_thread()
                            ? ": called from within World::step(); do it between steps"
                            : ": the world is in use by another thread; let one thread "
                              "at a time use a world"));
    }
    Use& use_;
    int granted_;
};

/// The same for functions that may not throw.
class OptionalUse {
  public:
    explicit OptionalUse(Use& use) noexcept : use_(use), granted_(use.take()) {}
    ~OptionalUse() {
        if (granted_ == 1) use_.leave();
    }
    OptionalUse(const OptionalUse&) = delete;
    OptionalUse& operator=(const OptionalUse&) = delete;
    [[nodiscard]] bool is_granted() const noexcept { return granted_ != 0; }
    /// True if it is not within another call.
    [[nodiscard]] bool is_outermost() const noexcept { return granted_ == 1; }

  private:
    Use& use_;
    int granted_;
};

}  // namespace hawser::world
