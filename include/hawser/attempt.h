// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file attempt.h
/// Undo of several edits of a world as one unit (Attempt), and the owner of a world's data (Owned).
/// Both serve World and the functions define() of its definitions; user programs do not need them.

#include <cassert>
#include <cstddef>
#include <memory>

namespace hawser {

class World;

/// Scope in which a function makes several edits of a world. If an exception leaves the scope, the
/// edits are undone, and the world has the state before the scope. In nested scopes only the
/// outermost has an effect. Before the first step the scope has no effect.
class Attempt {
  public:
    /// Save the world for an undo.
    /// @param wanted  False: the scope has no effect.
    /// @throws UseError, std::bad_alloc.
    explicit Attempt(World& world, bool wanted = true);
    ~Attempt();
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    /// Undo the edits at the end of the scope, although no exception is thrown.
    void fail() noexcept { failed_ = true; }

  private:
    World& world_;
    bool holds_ = false, failed_ = false;
    int exceptions_ = 0;    ///< std::uncaught_exceptions() at the start of the scope.
    std::size_t mark_ = 0;  ///< ChangeListener::mark() at the start of the scope.
};

/// Owner of the data of a world. Debug builds assert that the world was not moved from.
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
