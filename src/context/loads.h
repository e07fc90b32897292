// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file loads.h
/// Loads of systems: where they add up, and what the step takes them for.
///
/// Of a load f, A, D, K (hawser/system.h) a step has the impulse
/// ```
///     h f − (A + (h²/4) K)(v₊ − v) − h D (θ v₊ + (1 − θ) v)
/// ```
/// so that B = A + h θ D + (h²/4) K joins the matrix and h f + (A + (h²/4) K − h (1 − θ) D) v the
/// right-hand side. θ is that of model/damping.h with z = tr (M + A)⁻¹(h D + (h²/4) K), which is
/// not less than what any motion of the body sees. Blocks of three translations and of three
/// rotations join those of the body (View::body_block); what couples translations and rotations is
/// kept here, as few bodies have some (View::coupled).

#include <hawser/stats.h>
#include <hawser/system.h>

#include "assembly/view.h"
#include "base/executor.h"
#include "base/memory.h"
#include "context/judge_data.h"
#include "model/bodies.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace hawser::stepper {

inline constexpr std::int32_t kLoadChunk = 128;  ///< Bodies or entries of one task.
[[nodiscard]] constexpr int load_chunks(std::int32_t count) {
    return (count + kLoadChunk - 1) / kLoadChunk;
}

/// f(begin, end) over chunks of [0, count).
template <class F>
void over_loads(base::Executor& executor, std::int32_t count, F&& f) noexcept {
    auto task = [&](int i, int) noexcept {
        f(i * kLoadChunk, std::min((i + 1) * kLoadChunk, count));
    };
    executor.for_each(load_chunks(count), task);
}

class LoadStore {
  public:
    /// What loads do from one velocity to the next [J].
    struct Works {
        double work = 0.0;    ///< Of f, and of K by its change.
        double damped = 0.0;  ///< Taken by D.
        double added = 0.0;   ///< ½ vᵀA v afterwards.
        double water = 0.0;   ///< Impulses of the water's loads · v̄.
    };

    /// For the bodies there are; loads stay. @throws std::bad_alloc.
    void prepare(const model::Bodies& bodies);
    /// Zeros, before systems act. Does nothing where no system did.
    void clear() noexcept;

    // What systems call in their prestep().
    BodyLoad of(BodyId id) noexcept;
    void reserve(std::span<const BodyId> bodies) noexcept;
    /// Whose loads those to come are. Threads may be at work only where `parallel`.
    /// @param of_water  They are those of water.
    void begin_system(int number, bool of_water = false) noexcept {
        system_ = number + 1;
        water_now_ = of_water;
        touched_.store(false, std::memory_order_relaxed);
    }
    void share(bool parallel) noexcept { parallel_ = parallel; }
    /// It has loaded some body.
    [[nodiscard]] bool touched() const noexcept { return touched_.load(std::memory_order_relaxed); }
    [[nodiscard]] bool out_of_memory() const noexcept { return out_of_memory_; }

    /// What is wrong with the loads of the system that has just acted; reason "" if nothing. The
    /// body with the smallest index.
    [[nodiscard]] BadLoad fault(base::Executor& executor) noexcept;
    /// θ and B, once all systems have acted; bodies that sleep wake.
    void finish(model::Bodies& bodies, double h, base::Executor& executor) noexcept;

    /// The step is done; or it has failed, and bodies that loads woke sleep on.
    void accept() noexcept;
    void take_back(model::Bodies& bodies) noexcept;

    /// Some body has a load in this step.
    [[nodiscard]] bool any() const noexcept { return any_; }
    [[nodiscard]] bool loaded(std::int32_t body) const noexcept {
        return any_ && used(entry_of_[static_cast<std::size_t>(body)]);
    }
    /// Point the kernels' view to the matrices of loads that couple bodies.
    void show(assembly::View& view) const noexcept;
    /// Blocks and right-hand sides of bodies [begin, end) take their loads.
    void add_terms(const assembly::View& view, std::int32_t begin, std::int32_t end) const noexcept;
    /// What joins the right-hand side, h f + (A + (h²/4) K − h (1 − θ) D) v, and the matrix, of one
    /// body. @return whether it has a load.
    bool terms_of(std::int32_t body, double h, const double* v, double* impulse,
                  const double** block) const noexcept;
    /// v += (M + B)⁻¹ (p + h f − h D v): where an impulse p and its load take a body that has one.
    void push(const model::Bodies& bodies, std::int32_t body, double h, const double* p,
              double* v) const noexcept;
    /// Load of a body of another world.
    void copy_entry(const LoadStore& from, std::int32_t its, std::int32_t mine) noexcept;

    /// ½ vᵀA v of all loads of the step [J].
    [[nodiscard]] double added_energy(const model::Bodies& bodies, const double* v,
                                      base::Executor& executor) noexcept;
    /// What A has become since the last step changes the energy that is in it: work of systems.
    void count_change(const model::Bodies& bodies, base::Executor& executor) noexcept;
    /// What loads do from v to the velocities of a step that has been solved.
    void measure(const model::Bodies& bodies, double h, const double* v, const double* next,
                 base::Executor& executor) noexcept;
    /// Impulses h f of loads, times by how much velocities change in the step [J].
    [[nodiscard]] double gain(const model::Bodies& bodies, double h, const double* v,
                              const double* next) const noexcept;
    /// The step is good: what was measured joins the sums. @return what D took [J].
    double count() noexcept;
    /// ½ vᵀA v after the step that has been solved, for the A of the last one [J].
    [[nodiscard]] double added_after() const noexcept {
        return measured_ ? taken_.added - change_ : added;
    }

    /// Bodies with loads, ascending. @throws std::bad_alloc.
    [[nodiscard]] std::vector<LoadView> view() const;
    [[nodiscard]] std::size_t bytes() const noexcept;

    // State.
    double work = 0.0;   ///< Since the start, see Energy::system [J].
    double water = 0.0;  ///< Since the start, see Energy::water [J].
    double added = 0.0;  ///< ½ vᵀA v after the last step [J].

  private:
    /// Sum of f(begin, end, works) over chunks of bodies, in their order.
    template <class F>
    Works sum(base::Executor& executor, F&& f) noexcept;
    [[nodiscard]] double added_between(const model::Bodies& bodies, const double* v,
                                       std::int32_t begin, std::int32_t end) const noexcept;
    /// Of bodies [begin, end) between v and u.
    void works(const model::Bodies& bodies, double h, const double* v, const double* u,
               std::int32_t begin, std::int32_t end, Works& sum) const noexcept;

    struct Entry {
        std::int32_t body, place, freedom;
    };
    /// Whose loads an entry has in this step.
    enum Source : std::uint8_t { kNobody = 0, kOther = 1, kWater = 2 };
    /// Where water and another system load the same body: what of f, A, D, K is the water's. Room
    /// for an entry's is made once.
    struct Shared {
        double water[69] = {};   ///< The water's so far.
        double before[69] = {};  ///< All there was when the water that acts now began.
    };
    // Of an entry, all in load_water.cpp.
    /// Is the next load of the system that acts the first one that tells water from others?
    [[nodiscard]] bool needs_shared(std::size_t entry) const noexcept;
    /// Room for both parts. @return false: there is no memory.
    bool make_shared(std::size_t entry) noexcept;
    /// The system that acts begins to load it: what of the sum is the water's is set apart.
    void note_source(std::size_t entry) noexcept;
    /// All systems have acted: so is what water added last.
    void finish_water(std::size_t entry) noexcept;
    /// f, A, D, K of the water's loads of an entry; null: none.
    [[nodiscard]] const double* water_of(std::size_t entry) const noexcept;
    [[nodiscard]] bool there(BodyId id) const noexcept {
        return id.index >= 0 && static_cast<std::size_t>(id.index) < generation_.size() &&
               generation_[static_cast<std::size_t>(id.index)] == id.generation;
    }
    [[nodiscard]] BodyId id_of(std::size_t body) const noexcept {
        return {static_cast<std::int32_t>(body), generation_[body]};
    }
    [[nodiscard]] bool used(std::int32_t entry) const noexcept {
        return entry >= 0 && used_[static_cast<std::size_t>(entry)] != 0;
    }
    [[nodiscard]] BodyLoad at_place(std::int32_t place, int freedom) noexcept;
    bool add_entry(std::int32_t body, int freedom) noexcept;

    std::vector<Works> part_;  ///< One a chunk of bodies.
    std::vector<std::int32_t> woken_,
        woken_quiet_;                       ///< Bodies that a load woke, and Bodies::quiet.
    std::vector<std::int32_t> entry_of_;    ///< By body, −1: none.
    std::vector<std::int32_t> generation_;  ///< By body, −1: none is there.
    std::vector<std::uint8_t> freedom_;     ///< By body.
    std::vector<std::int32_t> coupled_;     ///< By body: place of a B that couples, −1.
    std::vector<Entry> entries_;            ///< In the order of their first loads.
    std::vector<std::int32_t> used_;        ///< By entry: last system + 1 in this step, 0: none.
    std::vector<double> late_;              ///< By entry: θ.
    std::vector<std::uint8_t> sources_;     ///< By entry: Source, both bits where two load it.
    std::vector<std::uint8_t> last_water_;  ///< By entry: who acted last on it is water.
    std::vector<std::int32_t> shared_of_;   ///< By entry: into `shared_`, −1.
    std::vector<Shared> shared_;
    std::vector<std::int32_t> fault_;  ///< Scratch, one a chunk of entries.
    base::Array<double> data_;         ///< Of each entry f, A, D, K, B.
    double scratch_[96] = {};          ///< For what cannot be loaded.
    Works taken_;                      ///< By the step that has been solved, if `measured_`.
    double change_ = 0.0;  ///< Of `added` by what A has become, in the step being taken [J].
    int system_ = 0;
    std::int32_t coupled_count_ = 0;
    bool any_ = false, parallel_ = false, out_of_memory_ = false, measured_ = false;
    bool water_now_ = false;  ///< The system that acts is water.
    std::atomic<bool> touched_{false};
    std::atomic<bool> unreserved_{
        false};  ///< Threads asked for a body that reserve() did not name.
    std::atomic<bool> no_body_{false};
};

}  // namespace hawser::stepper
