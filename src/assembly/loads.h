// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file loads.h
/// Loads of systems: their sums, and their terms in a step.
///
/// A load f, A, D, K (hawser/system.h) has this impulse.
/// ```
///     h f − (A + (h²/4) K)(v₊ − v) − h D (θ v₊ + (1 − θ) v)
/// ```
/// The term in the matrix is B = A + h θ D + (h²/4) K, in the right-hand side h f + (A + (h²/4) K −
/// h (1 − θ) D) v. The value θ follows from model/damping.h with z = tr (M + A)⁻¹(h D + (h²/4) K),
/// an upper bound over all motions of the body. The 3×3 blocks of translations and of rotations are
/// added to those of the body (View::body_block). The coupling of translations and rotations is
/// stored here, because few bodies have one (View::coupled).

#include <hawser/stats.h>
#include <hawser/system.h>

#include "assembly/view.h"
#include "base/executor.h"
#include "base/memory.h"
#include "model/bodies.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace hawser::assembly {

inline constexpr std::int32_t kLoadChunk = 128;  ///< Bodies or entries of one task.
[[nodiscard]] constexpr int load_chunks(std::int32_t count) {
    return (count + kLoadChunk - 1) / kLoadChunk;
}

/// Call f(begin, end) for chunks of [0, count).
template <class F>
void over_loads(base::Executor& executor, std::int32_t count, F&& f) noexcept {
    auto task = [&](int i, int) noexcept {
        f(i * kLoadChunk, std::min((i + 1) * kLoadChunk, count));
    };
    executor.for_each(load_chunks(count), task);
}

class LoadStore {
  public:
    /// Energies of loads between two velocities [J].
    struct Works {
        double work = 0.0;    ///< Work of f, and of the change of K.
        double damped = 0.0;  ///< Energy absorbed by D.
        double added = 0.0;   ///< ½ vᵀA v after the step.
        double water = 0.0;   ///< Impulses of water loads · v̄.
    };

    /// Prepare for the present bodies. Loads of remaining bodies are kept. @throws std::bad_alloc.
    void prepare(const model::Bodies& bodies);
    /// Set loads to zero before systems act. No effect if no system acted.
    void clear() noexcept;

    // Return the load of a body, to which a system adds in its prestep().
    BodyLoad of(BodyId id) noexcept;
    void reserve(std::span<const BodyId> bodies) noexcept;
    /// Set the system of the following loads. Several threads may add loads only after share(true).
    /// @param of_water  True for loads of water.
    void begin_system(int number, bool of_water = false) noexcept {
        system_ = number + 1;
        water_now_ = of_water;
        repeat_now_ = false;
        touched_.store(false, std::memory_order_relaxed);
    }
    /// Mark the following loads of the present system as repeatable or not. A replay must compute
    /// repeatable loads again, and reads the others from the recording (LoadRecord).
    void repeat(bool repeatable) noexcept {
        repeat_now_ = repeatable;
        repeats_ = repeats_ || repeatable;
    }
    /// Mark a body because an input of one of its elements has changed. Its repeatable loads in
    /// this step then differ from loads computed from the state after the change.
    void alter(std::int32_t body) noexcept;
    void share(bool parallel) noexcept { parallel_ = parallel; }
    /// True if the present system has loaded a body.
    [[nodiscard]] bool touched() const noexcept { return touched_.load(std::memory_order_relaxed); }
    [[nodiscard]] bool out_of_memory() const noexcept { return out_of_memory_; }

    /// Return the first fault in the loads of the last system: the body with the smallest index,
    /// and a reason; "" if there is no fault.
    [[nodiscard]] BadLoad fault(base::Executor& executor) noexcept;
    /// Compute θ and B after all systems have acted. Wakes loaded bodies.
    void finish(model::Bodies& bodies, double h, base::Executor& executor) noexcept;

    /// End a step. accept(): it succeeded. take_back(): it failed; bodies that loads woke sleep
    /// again.
    void accept() noexcept;
    void take_back(model::Bodies& bodies) noexcept;

    /// True if any body has a load in this step.
    [[nodiscard]] bool any() const noexcept { return any_; }
    [[nodiscard]] bool loaded(std::int32_t body) const noexcept {
        return any_ && used(entry_of_[static_cast<std::size_t>(body)]);
    }
    /// Set the pointers of a view to the matrices by which loads couple the motions of a body.
    void show(assembly::View& view) const noexcept;
    /// Add loads to the blocks and right-hand sides of bodies [begin, end).
    void add_terms(const assembly::View& view, std::int32_t begin, std::int32_t end) const noexcept;
    /// Compute the terms of one body: h f + (A + (h²/4) K − h (1 − θ) D) v for the right-hand side
    /// (`impulse`), and the block for the matrix. @return true if the body has a load.
    bool terms_of(std::int32_t body, double h, const double* v, double* impulse,
                  const double** block) const noexcept;
    /// Add (M + B)⁻¹ (p + h f − h D v) to v of a loaded body, which is the effect of an impulse p
    /// and the load of the body.
    void push(const model::Bodies& bodies, std::int32_t body, double h, const double* p,
              double* v) const noexcept;
    /// Copy the load of body `its` of another world to body `mine`.
    void copy_entry(const LoadStore& from, std::int32_t its, std::int32_t mine) noexcept;

    /// Return ½ vᵀA v of all loads of the step [J].
    [[nodiscard]] double added_energy(const model::Bodies& bodies, const double* v,
                                      base::Executor& executor) noexcept;
    /// Compute the change of ½ vᵀA v due to the change of A since the last step, and count it as
    /// work of systems.
    void count_change(const model::Bodies& bodies, base::Executor& executor) noexcept;
    /// Measure the energies of loads from v to the velocities of the solved step.
    void measure(const model::Bodies& bodies, double h, const double* v, const double* next,
                 base::Executor& executor) noexcept;
    /// Return the impulses h f of loads times the change of velocities in the step [J].
    [[nodiscard]] double gain(const model::Bodies& bodies, double h, const double* v,
                              const double* next) const noexcept;
    /// Add the energies of measure() to the sums `work`, `water` and `added` after a successful
    /// step. @return energy absorbed by the damping D of the loads [J].
    double count() noexcept;
    /// Return ½ vᵀA v after the solved step, for A of the last step [J].
    [[nodiscard]] double added_after() const noexcept {
        return measured_ ? taken_.added - change_ : added;
    }

    /// Return the bodies with loads, ascending. @throws std::bad_alloc.
    [[nodiscard]] std::vector<LoadView> view() const;
    /// Return the loads that are not repeatable. @throws std::bad_alloc.
    [[nodiscard]] LoadRecord record() const;
    [[nodiscard]] std::size_t bytes() const noexcept;

    // State:
    double work = 0.0;   ///< Sum since the start, see Energy::system [J].
    double water = 0.0;  ///< Sum since the start, see Energy::water [J].
    double added = 0.0;  ///< ½ vᵀA v after the last step [J].

  private:
    /// Return the sum of f(begin, end, works) over chunks of bodies, in their order.
    template <class F>
    Works sum(base::Executor& executor, F&& f) noexcept;
    [[nodiscard]] double added_between(const model::Bodies& bodies, const double* v,
                                       std::int32_t begin, std::int32_t end) const noexcept;
    /// Compute the energies of the loads on bodies [begin, end) between the velocities v and u.
    void works(const model::Bodies& bodies, double h, const double* v, const double* u,
               std::int32_t begin, std::int32_t end, Works& sum) const noexcept;

    struct Entry {
        std::int32_t body, place, freedom;
    };
    /// Systems whose loads an entry has in this step.
    enum Source : std::uint8_t { kNobody = 0, kOther = 1, kWater = 2 };
    /// Part of f, A, D, K that belongs to water, for a body loaded by water and another system. An
    /// entry allocates it once.
    struct Shared {
        double water[69] = {};   ///< Sum of the loads of water up to now.
        double before[69] = {};  ///< Sum of all loads when the present water system began.
    };
    // True if the next load of the present system requires a separate sum of water loads for this
    // entry, which does not exist yet. (This and the next functions are in load_water.cpp.)
    [[nodiscard]] bool needs_shared(std::size_t entry) const noexcept;
    /// Allocate the separate sums of an entry. @return false if allocation fails.
    bool make_shared(std::size_t entry) noexcept;
    /// Record that the present system is the first to load an entry, and keep loads of water in a
    /// separate sum.
    void note_source(std::size_t entry) noexcept;
    /// Complete the sum of water loads after all systems have acted.
    void finish_water(std::size_t entry) noexcept;
    /// Return f, A, D, K of the water loads of an entry; null: none.
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
    [[nodiscard]] LoadView view_of(std::size_t body) const;
    [[nodiscard]] BodyLoad at_slot(std::int32_t place, int freedom) noexcept;
    bool add_entry(std::int32_t body, int freedom) noexcept;

    std::vector<Works> part_;  ///< One per chunk of bodies.
    std::vector<std::int32_t> woken_,
        woken_quiet_;                       ///< Bodies that a load woke, and their Bodies::quiet.
    std::vector<std::int32_t> entry_of_;    ///< By body, −1: none.
    std::vector<std::int32_t> generation_;  ///< Generation of each body, −1: vacant slot.
    std::vector<std::uint8_t> freedom_;     ///< By body.
    std::vector<std::int32_t> coupled_;     ///< By body: offset of a coupling matrix B, −1: none.
    std::vector<Entry> entries_;            ///< Entries in the order of their first loads.
    std::vector<std::int32_t> used_;        ///< By entry: last system + 1 in this step, 0: none.
    std::vector<double> late_;              ///< By entry: θ.
    /// By entry: Source, both bits if water and another system load it.
    std::vector<std::uint8_t> sources_;
    std::vector<std::uint8_t> last_water_;  ///< By entry: 1 if the last system was water.
    std::vector<std::int32_t> shared_of_;   ///< By entry: index in `shared_`, −1: none.
    std::vector<Shared> shared_;
    std::vector<std::uint8_t> repeatable_;  ///< By entry: 1 if all its loads are repeatable.
    std::vector<std::int32_t> altered_;     ///< Bodies of alter() in this step.
    std::vector<std::int32_t> fault_;       ///< Scratch, one per chunk of entries.
    base::Array<double> data_;              ///< f, A, D, K, B of each entry.
    double scratch_[96] = {};               ///< Target for loads of bodies that cannot be loaded.
    Works taken_;                           ///< Energies of the solved step, if `measured_`.
    double change_ = 0.0;  ///< Change of `added` by the change of A in the present step [J].
    int system_ = 0;
    std::int32_t coupled_count_ = 0;
    bool any_ = false, parallel_ = false, out_of_memory_ = false, measured_ = false;
    bool water_now_ = false;   ///< True if the present system is water.
    bool repeat_now_ = false;  ///< True if the present loads are repeatable.
    bool repeats_ = false;     ///< True if a system had repeatable loads in this step.
    std::atomic<bool> touched_{false};
    std::atomic<bool> unreserved_{
        false};  ///< True if a thread requested a body that reserve() did not name.
    std::atomic<bool> no_body_{false};
};

}  // namespace hawser::assembly
