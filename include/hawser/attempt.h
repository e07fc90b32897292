// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file attempt.h
/// Calls of several edits, all or none; and parts of a world until it is moved from.

#include <cassert>
#include <cstddef>
#include <memory>

namespace hawser {

class World;

/// A call that makes several edits of a world. If it throws, they are undone, and the world is as
/// before the call. Only the outermost of nested calls acts. Before the first step it does nothing,
/// because no undo is needed.
class Attempt {
  public:
    /// Begin a call.
    /// @param wanted  False: do nothing.
    /// @throws UseError, std::bad_alloc.
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
    std::size_t mark_ = 0;  ///< Mark of the change listener.
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
