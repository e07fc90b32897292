// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file systems.h
/// The systems of a world: in order, with their signals, and with what a step that fails takes
/// back.

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

/// What a world lets its systems do between the beginning of a step and its end.
class InputDoor {
  public:
    virtual ~InputDoor() = default;
    /// How the input was, so that set() can be taken back.
    struct Before {
        std::int32_t input = -1;
        double value = 0.0, applied = 0.0;    ///< Asked for, and in force.
        std::int32_t body[3] = {-1, -1, -1};  ///< What it disturbs …
        std::int32_t quiet[3] = {0, 0, 0};    ///< … and how long that had been at rest.
        double asked = 0.0;
        bool clamped = false;
    };
    /// @return false: there is no such input, or the value is not finite.
    virtual bool set(InputId id, double value, Before& before) noexcept = 0;
    /// The same of what has been told already.
    virtual bool set_untold(InputId id, double value, Before& before) noexcept = 0;
    /// True if the input drives one end of a range whose minimum is above its maximum.
    [[nodiscard]] virtual bool empties_range(std::int32_t input) const noexcept = 0;
    [[nodiscard]] virtual InputId id_of(std::int32_t input) const noexcept = 0;
    virtual void take_back(const Before& before) noexcept = 0;
    /// Tell that it asked for a value beyond its range.
    virtual void tell(const Before& before) noexcept = 0;
    /// A system is about to edit the world: copy the state to which a failed step returns, unless
    /// this step has done so. @return false: no memory.
    [[nodiscard]] virtual bool begin_edits() noexcept = 0;
    /// While a step is taken, forces of inputs in the frames of their bodies are turned into the
    /// world and stand among the applied ones. Without them, and with them again as inputs and
    /// poses are by then.
    virtual void unturn_forces() noexcept = 0;
    virtual void turn_forces() noexcept = 0;
    /// How many inputs the world has.
    [[nodiscard]] virtual std::size_t count() const noexcept = 0;
};

class Systems final : public stepper::Actors {
  public:
    explicit Systems(InputDoor& door) : door_(door) {}
    virtual ~Systems() = default;
    Systems(const Systems&) = delete;
    Systems& operator=(const Systems&) = delete;

    /// @throws DefError, std::bad_alloc; nothing has changed then.
    System& add(std::unique_ptr<System> system);
    /// @throws DefError.
    std::unique_ptr<System> remove(const System& system);
    /// All systems of a world go over to this one, which has none.
    void take_all(Systems& from) noexcept {
        list_.swap(from.list_);
        signals_.swap(from.signals_);
    }
    [[nodiscard]] std::size_t count() const noexcept { return list_.size(); }
    [[nodiscard]] System& at(std::size_t i) const { return *list_[i]; }
    [[nodiscard]] System* find(std::string_view name) const noexcept;
    [[nodiscard]] const std::vector<SystemSignal>& signals() const noexcept { return signals_; }
    /// @throws DefError with the nearest name.
    [[nodiscard]] const SystemSignal& signal(std::string_view name) const;

    /// Set the world whose step systems see.
    void use(const World& world) noexcept { world_ = &world; }
    /// What systems hold, each told with its name. @throws std::bad_alloc, and what f throws.
    template <class F>
    void each_held(F&& f) const {
        for (const auto& s : list_) {
            held_.bodies.clear();
            held_.interactions.clear();
            held_.shapes.clear();
            held_.inputs.clear();
            s->holds(held_);
            f(s->name(), held_);
        }
    }
    /// What systems carry of an element (System::carried_mass()) [kg]; below 0 where a drum has
    /// hauled in more than there was of it.
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept {
        double sum = 0.0;
        for (const auto& s : list_) sum += s->carried_mass(element);
        return sum;
    }
    /// System::paid_out() of the system that keeps account of an element [m]; else kDefault.
    [[nodiscard]] double paid_out(const World& world, InteractionId element) const noexcept {
        for (const auto& s : list_)
            if (const double paid = s->paid_out(world, element); !std::isnan(paid)) return paid;
        return kDefault;
    }
    /// In begin_step().
    [[nodiscard]] bool editing() const noexcept { return editing_; }
    /// Whether nodes are systems' to put and take: those that carry an element keep its account.
    [[nodiscard]] bool refuses_nodes(InteractionId element) const noexcept {
        return !editing_ && carried_mass(element) != 0.0;
    }
    /// The step has ended since systems asked for edits, and has gone back: they are to be made,
    /// and then the step taken once more, with what the systems did in it.
    [[nodiscard]] bool wants_edits() const noexcept { return queue_.size() > 0 && deed_.known; }
    /// Make them. @return what is wrong, in BadLoad too; Status::ok: all are made.
    Status make_edits(World& world) noexcept;
    [[nodiscard]] std::size_t queued() const noexcept { return queue_.left(); }
    /// Whether some of them would leave out more at a higher level of coarsening.
    [[nodiscard]] bool coarsens() const noexcept {
        return std::any_of(list_.begin(), list_.end(),
                           [](const auto& system) { return system->coarsens(); });
    }
    /// A step begins: keep the states of systems, and have these put and take nodes of wires.
    /// @return ok or out_of_memory.
    Status begin_step(World& world) noexcept;
    /// The step failed: states of systems as they were when it began.
    void undo_step() noexcept;
    /// What systems did for a step that has not been taken is forgotten: the state is another.
    void forget() noexcept;
    Status act(stepper::StepContext& ctx) noexcept override;
    void accept(stepper::StepContext& ctx) noexcept override;
    void go_back(stepper::StepContext& ctx) noexcept override;

    /// Names and sizes of states.
    [[nodiscard]] std::uint64_t layout() const;
    [[nodiscard]] static std::uint64_t no_layout() noexcept;  ///< Of none.
    [[nodiscard]] std::size_t state_bytes() const;
    void save(std::byte* to) const;
    void restore(const std::byte* from);
    /// Check the states that restore() has read. @throws DefError that names system and quantity.
    void check_states(const World& world) const;
    /// Continues a hash with all states.
    [[nodiscard]] std::uint64_t hash(std::uint64_t h) const;

    BadLoad bad;

  private:
    class Hands;
    class NodeHands;
    /// What systems did in a step that ended for their edits, to be done again.
    struct Deed {
        struct Load {
            BodyId body;
            std::vector<double> numbers;  ///< f, A, D, K.
        };
        std::vector<std::byte> states;  ///< Afterwards.
        std::vector<std::pair<InputId, double>> inputs;
        std::vector<Load> loads;
        std::vector<Event> told;
        bool known = false;
    };
    void check_ranges(std::size_t first) noexcept;
    Status act_all(stepper::StepContext& ctx);
    void keep_states(std::vector<std::byte>& to) const;
    void take_states(const std::vector<std::byte>& from) const;
    void keep_deed(const stepper::StepContext& ctx);
    void repeat_deed(stepper::StepContext& ctx);

    InputDoor& door_;
    const World* world_ = nullptr;
    std::vector<std::unique_ptr<System>> list_;
    std::vector<SystemSignal> signals_;
    mutable HoldTable held_;              ///< Scratch of each_held(), whose memory is kept.
    bool acted_ = false;                  ///< In the step being taken.
    bool editing_ = false;                ///< In begin_step().
    std::vector<std::byte> begun_;        ///< States when the step began, …
    bool begun_known_ = false;            ///< … if there was memory for them.
    std::vector<std::byte> kept_;         ///< States before prestep().
    std::vector<InputDoor::Before> set_;  ///< Inputs that it set, in that order.
    std::vector<Event> told_;             ///< Events that they told of.
    bool untold_ = false;                 ///< There was no room for one of them.
    double drive_ = 0.0;                  ///< Ledger::drive before it.
    QueuedEdits queue_;
    Deed deed_;
    std::string edit_fault_;  ///< BadLoad::reason of an edit.
};

}  // namespace hawser::world
