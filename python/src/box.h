// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file box.h
/// Shared owner of a world: exclusive use by one thread, numpy arrays on its state, errors raised
/// in callbacks.

#include <hawser/hawser.h>
#include <hawser/session.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace hawser::python {

namespace py = pybind11;

/// Array of a world's state that numpy sees without a copy.
enum class StateArray : std::uint8_t { position, orientation, velocity };
inline constexpr int kStateArrays = 3;

/// Pinned memory of one numpy array. It may outlive the world.
struct StateMemory {
    StateMemory(StateArray what, const double* data, std::size_t count);
    ~StateMemory();
    StateMemory(const StateMemory&) = delete;
    StateMemory& operator=(const StateMemory&) = delete;

    StateArray array;
    double* data;
    std::size_t count;
};

class SystemBridge;  // system.h

/// Owner of a world, shared by all Python objects that use it.
class WorldBox : public std::enable_shared_from_this<WorldBox> {
  public:
    explicit WorldBox(World world);
    explicit WorldBox(std::unique_ptr<Session> session);
    ~WorldBox();
    WorldBox(const WorldBox&) = delete;
    WorldBox& operator=(const WorldBox&) = delete;

    /// Return the world for reading.
    /// @throws UseError if another thread uses it.
    [[nodiscard]] World& read();
    /// Return the session. @throws UseError as read().
    [[nodiscard]] Session& session();

    /// Take steps without the interpreter lock. Checks signals at least every 20 ms, and ends a
    /// longer step if an interrupt arrives.
    /// @throws StepFailed, py::error_already_set (of a callback or a signal handler).
    void step(std::int64_t count);
    /// Cancel the running step, or else the next one. Any thread may call it.
    void cancel() noexcept { world_->cancel(); }
    /// Update arrays whose memory the world has released. Call it after each change.
    void refresh_arrays();
    /// Return the present array, without a copy.
    [[nodiscard]] py::object array(StateArray which);
    /// Enter the systems written in Python that the world has, such as those of a twin.
    void adopt_bridges();
    /// Store the error of a callback, which step() raises. Only the first one is kept.
    void fail(py::error_already_set error);
    /// Store the events of session steps, up to the newest 16,384.
    [[nodiscard]] std::vector<Event>& events() noexcept { return events_; }

    std::vector<SystemBridge*> bridges;  ///< Systems written in Python, in order.

  private:
    struct Running;
    Status step_once(std::int64_t& left);
    void check_thread() const;

    std::unique_ptr<World> own_;
    std::unique_ptr<Session> session_;
    World* world_ = nullptr;
    bool running_ = false;  ///< Read and written with the interpreter lock.
    std::thread::id user_;
    std::vector<std::weak_ptr<StateMemory>> memories_;
    std::array<py::object, kStateArrays> arrays_;  ///< The present arrays, or null.
    std::array<std::weak_ptr<StateMemory>, kStateArrays> present_;
    std::unique_ptr<py::error_already_set> error_;
    std::vector<Event> events_;
};

/// A step failed; raised as hawser.StepError.
struct StepFailed {
    std::string status;
    std::string message;
};

/// An object was removed, or its world does not exist any more; raised as hawser.RemovedError.
class ObjectRemoved : public std::exception {
  public:
    explicit ObjectRemoved(std::string message) : message_(std::move(message)) {}
    [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }

  private:
    std::string message_;
};

}  // namespace hawser::python
