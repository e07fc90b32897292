// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file systems.h
/// The systems of a world in order, with their signals and the data to undo a failed step.

#include <hawser/system.h>

#include "context/actors.h"
#include "world/queued_edits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hawser::world {

/// Access of systems to the world between the start of a step and its end.
class InputAccess {
  public:
    virtual ~InputAccess() = default;
    /// Previous state of an input, for take_back().
    struct Before {
        std::int32_t input = -1;
        double value = 0.0, applied = 0.0;    ///< Requested value and value in force.
        std::int32_t body[3] = {-1, -1, -1};  ///< Bodies that it disturbs …
        /// … and the number of steps for which they had been at rest.
        std::int32_t quiet[3] = {0, 0, 0};
        double asked = 0.0;
        bool clamped = false;
        bool moved = false;  ///< True if the value in force changed.
    };
    /// Set an input.
    /// @return false if it does not exist or the value is not finite.
    virtual bool set(InputId id, double value, Before& before) noexcept = 0;
    /// Set an input without a report to the listener.
    virtual bool set_unreported(InputId id, double value, Before& before) noexcept = 0;
    /// True if the input drives one end of a range, and the minimum of this range is above its
    /// maximum.
    [[nodiscard]] virtual bool leaves_empty_range(std::int32_t input) const noexcept = 0;
    [[nodiscard]] virtual InputId id_of(std::int32_t input) const noexcept = 0;
    virtual void take_back(const Before& before) noexcept = 0;
    /// Send an event if a requested value was outside its range. @param before  The input and the
    /// requested value.
    virtual void tell(const Before& before) noexcept = 0;
    /// Begin edits by a system: save the state to which a failed step returns, unless this step has
    /// done so.
    /// @return false if allocation fails.
    [[nodiscard]] virtual bool begin_edits() noexcept = 0;
    /// Remove the forces of inputs in body frames from the applied forces. The next function adds
    /// them again, with the current inputs and poses. During a step they are rotated into world
    /// axes.
    virtual void unrotate_forces() noexcept = 0;
    virtual void rotate_forces() noexcept = 0;
    /// Return the number of inputs of the world.
    [[nodiscard]] virtual std::size_t count() const noexcept = 0;
};

class Systems final : public context::Actors {
  public:
    explicit Systems(InputAccess& door) : input_access_(door) {}
    virtual ~Systems() = default;
    Systems(const Systems&) = delete;
    Systems& operator=(const Systems&) = delete;

    /// Add a system.
    /// @throws DefError, std::bad_alloc; nothing has then changed.
    System& add(std::unique_ptr<System> system);
    /// Remove a system.
    /// @throws DefError.
    std::unique_ptr<System> remove(const System& system);
    /// Move all systems of a world to this one, which has none.
    void move_systems(Systems& from) noexcept {
        list_.swap(from.list_);
        signals_.swap(from.signals_);
    }
    [[nodiscard]] std::size_t count() const noexcept { return list_.size(); }
    [[nodiscard]] System& at(std::size_t i) const { return *list_[i]; }
    [[nodiscard]] System* find(std::string_view name) const noexcept;
    [[nodiscard]] const std::vector<SystemSignal>& signals() const noexcept { return signals_; }
    /// Return a signal.
    /// @throws DefError with the nearest name.
    [[nodiscard]] const SystemSignal& signal(std::string_view name) const;

    /// Set the world that systems receive in a step.
    void use(const World& world) noexcept { world_ = &world; }
    /// Call f for the objects that each system refers to, with the name of the system. @throws
    /// std::bad_alloc, and exceptions of f.
    template <class F>
    void for_each_hold_table(F&& f) const {
        for (const auto& s : list_) {
            held_.bodies.clear();
            held_.interactions.clear();
            held_.shapes.clear();
            held_.inputs.clear();
            s->holds(held_);
            f(s->name(), held_);
        }
    }
    /// Return the mass of an element that systems carry (System::carried_mass()) [kg]; negative if
    /// a drum has hauled in more than existed.
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept {
        double sum = 0.0;
        for (const auto& s : list_) sum += s->carried_mass(element);
        return sum;
    }
    /// Return System::paid_out() of the system that counts an element [m], otherwise kDefault.
    [[nodiscard]] double paid_out(const World& world, InteractionId element) const noexcept {
        for (const auto& s : list_)
            if (const double paid = s->paid_out(world, element); !std::isnan(paid)) return paid;
        return kDefault;
    }
    /// True while begin_step() is running.
    [[nodiscard]] bool edits_allowed() const noexcept { return editing_; }
    /// Return true if only systems may insert and remove nodes: a system that carries an element
    /// counts its length.
    [[nodiscard]] bool only_systems_edit_nodes(InteractionId element) const noexcept {
        return !editing_ && carried_mass(element) != 0.0;
    }
    /// True if the step was undone because systems requested edits. The caller makes these edits
    /// and repeats the step with the recorded actions of the systems.
    [[nodiscard]] bool has_requested_edits() const noexcept {
        return queue_.size() > 0 && pending_action_.is_known;
    }
    /// Make the requested edits.
    /// @return Status::ok if all edits were made, else the error, which is also stored in `bad`.
    Status make_edits(World& world) noexcept;
    [[nodiscard]] std::size_t queued() const noexcept { return queue_.left(); }
    /// Return true if a system would remove more nodes at a higher level of coarsening.
    [[nodiscard]] bool coarsens() const noexcept {
        return std::any_of(list_.begin(), list_.end(),
                           [](const auto& system) { return system->coarsens(); });
    }
    /// Begin a step: save the states of systems and let them insert and remove nodes of wires.
    /// @return ok or out_of_memory.
    Status begin_step(World& world) noexcept;
    /// Undo a failed step: restore the states of systems at its start.
    void undo_step() noexcept;
    /// Discard the recorded actions of a step that was undone, because the state has changed since.
    void discard_actions() noexcept;
    Status act(context::StepContext& ctx) noexcept override;
    void accept(context::StepContext& ctx) noexcept override;
    void go_back(context::StepContext& ctx) noexcept override;

    /// Return a hash of the names of all systems and the sizes of their states.
    [[nodiscard]] std::uint64_t layout() const;
    [[nodiscard]] static std::uint64_t no_layout() noexcept;  ///< Layout without systems.
    [[nodiscard]] std::size_t state_bytes() const;
    void save(std::byte* to) const;
    void restore(const std::byte* from);
    /// Check the states read by restore().
    /// @throws DefError with the names of system and quantity.
    void check_states(const World& world) const;
    /// Continue a hash with the states of all systems.
    [[nodiscard]] std::uint64_t hash(std::uint64_t h) const;

    BadLoad bad;

  private:
    class StepAccess;
    // The class is final; clang-tidy checks this declaration, which cannot say so.
    class NodeEditAccess;  // NOLINT(cppcoreguidelines-virtual-class-destructor)
    /// Recorded actions of systems in a step that ended for their edits, to be repeated.
    struct SystemAction {
        struct Load {
            BodyId body;
            std::vector<double> numbers;  ///< f, A, D, K.
        };
        std::vector<std::byte> states;  ///< States after the actions.
        std::vector<std::pair<InputId, double>> inputs;
        std::vector<Load> loads;
        std::vector<Event> reported;
        bool is_known = false;
    };
    void check_ranges(std::size_t first) noexcept;
    Status act_all(context::StepContext& ctx);
    void save_states_to(std::vector<std::byte>& to) const;
    void restore_states(const std::vector<std::byte>& from) const;
    void save_action(const context::StepContext& ctx);
    void repeat_action(context::StepContext& ctx);

    InputAccess& input_access_;
    const World* world_ = nullptr;
    std::vector<std::unique_ptr<System>> list_;
    std::vector<SystemSignal> signals_;
    mutable HoldTable held_;  ///< Scratch of for_each_hold_table(); its memory is reused.
    bool acted_ = false;      ///< True if systems have acted in the current step.
    bool editing_ = false;    ///< True during begin_step().
    std::vector<std::byte> step_start_states_;  ///< States at the start of the step, …
    bool begun_valid_ = false;                  ///< … valid if there was memory for them.
    std::vector<std::byte> saved_states_;       ///< States before prestep().
    std::vector<InputAccess::Before> set_;      ///< Inputs set by prestep(), in order.
    std::vector<Event> reported_;               ///< Events that systems reported.
    bool events_dropped_ = false;               ///< True if there was no capacity for an event.
    double drive_ = 0.0;                        ///< Ledger::drive before prestep().
    QueuedEdits queue_;
    SystemAction pending_action_;
    std::string edit_fault_;  ///< BadLoad::reason of an edit.
};

}  // namespace hawser::world
