// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file attempt.h
/// Calls of several edits, all or none; and what a world is made of, until it is moved from.
///
/// A World that was moved from may be destroyed or assigned to. Any other use is an error of the
/// program, which debug builds assert.
///
/// World::~World() ends the worker threads. A forked child has none of them: there it only frees
/// memory, and the child may also step the world, on the calling thread alone.

#include <cassert>
#include <cstddef>
#include <memory>

namespace hawser {

class World;

/// A call that makes several edits of a world: where it throws, they are undone, so that the world
/// goes on as if it had not been called. Of nested ones the outermost counts. Before the first step
/// it does nothing: then nothing is at stake.
class Attempt {
  public:
    /// @param wanted  False: it does nothing. @throws UseError, std::bad_alloc.
    explicit Attempt(World& world, bool wanted = true);
    ~Attempt();
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    /// Undo them, though the call does not throw.
    void fail() noexcept { failed_ = true; }

  private:
    World& world_;
    bool holds_ = false, failed_ = false;
    int exceptions_ = 0;    ///< In flight when it began.
    std::size_t mark_ = 0;  ///< Of the change listener.
};

/// Owns the parts of a world. Debug builds assert that the world was not moved from.
template <class T>
class Owned : public std::unique_ptr<T> {
  public:
    using std::unique_ptr<T>::unique_ptr;
    using std::unique_ptr<T>::operator=;
    T* operator->() const noexcept { return checked(); }
    T& operator*() const noexcept { return *checked(); }

  private:
    [[nodiscard]] T* checked() const noexcept {
        assert(this->get() != nullptr && "this World was moved from");
        return this->get();
    }
};

}  // namespace hawser
