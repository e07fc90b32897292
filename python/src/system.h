// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file system.h
/// Systems written in Python: hawser.System, and the bridge by which a world calls it.

#include "box.h"

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace hawser::python {

/// Data of a hawser.System, owned by its Python object and the bridge.
struct SystemCore {
    struct Signal {
        std::string name, unit;
        double value = 0.0;
        bool input = false;
        double min = -1e300, max = 1e300;
    };
    std::string name;
    std::deque<Signal> signals;      ///< The world stores addresses of the values.
    std::vector<double> state;       ///< Numbers on which later steps depend.
    SystemBridge* bridge = nullptr;  ///< Null: in no world.

    SystemCore(std::string name_, std::size_t numbers)
        : name(std::move(name_)), state(numbers, 0.0) {}
    [[nodiscard]] Signal& signal(const std::string& name);
};

/// The step that begins, for Python. It is valid within System.prestep() only.
struct StepView {
    Prestep* now = nullptr;
    std::weak_ptr<WorldBox> box;
    /// @throws UseError outside prestep().
    [[nodiscard]] Prestep& get() const;
};

/// Loads of the step that begins, for Python. They are valid within System.prestep() only.
struct LoadsView {
    Loads* loads = nullptr;
    std::weak_ptr<WorldBox> box;
    [[nodiscard]] Loads& get() const;
    [[nodiscard]] WorldBox& of() const;
};

/// Calls a hawser.System. An exception makes the step fail; WorldBox::step() raises it.
class SystemBridge final : public System {
  public:
    SystemBridge(py::object instance, std::shared_ptr<SystemCore> core);
    ~SystemBridge() override;

    /// Enter this system in the list of a box.
    void enter(WorldBox& box);
    /// Return the Python object.
    [[nodiscard]] const py::object& instance() const noexcept { return instance_; }
    /// Drop the Python object, for garbage collection.
    void drop() { instance_ = py::object(); }
    void leave() noexcept { box_ = nullptr; }

    [[nodiscard]] std::string_view name() const noexcept override { return core_->name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] std::unique_ptr<System> clone() const override;

  private:
    py::object instance_;
    std::shared_ptr<SystemCore> core_;
    WorldBox* box_ = nullptr;  ///< Owner of the world that owns this.
    std::shared_ptr<StepView> step_ = std::make_shared<StepView>();
    std::shared_ptr<LoadsView> loads_ = std::make_shared<LoadsView>();
    py::object step_object_, loads_object_, call_;
};

/// Add the classes System, Step and Loads to the module.
void bind_systems(py::module_& module);

}  // namespace hawser::python
