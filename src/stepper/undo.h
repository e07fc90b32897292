// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file undo.h
/// The way back to the state of the last good step, for whatever fails: memory that ends, a bound,
/// a step that is cancelled or diverges.
///
/// Most of a step writes nothing of the state before stage integrate, which cannot fail. What comes
/// earlier is kept first: velocities before an impact or the staggered start changes them, and
/// before the system changes (bodies touch for the first time, fall asleep or wake, groups move,
/// something was added) what the analysis goes on from. To go back allocates nothing. The system
/// itself is not kept, it would take as much again: it is *mended* before it is needed next, like
/// that of a restored world, to the same bits (factor::AnalysisState).
///
/// Limits: what a step computes for readers (contacts, residuals, times) is that of the step that
/// failed.

#include "assembly/system.h"
#include "base/memory.h"
#include "collide/contacts.h"
#include "collide/match.h"
#include "model/bodies.h"
#include "model/interactions.h"
#include "stepper/cuts.h"
#include "stepper/judge.h"
#include "stepper/regroup.h"
#include "stepper/wires.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::stepper {

struct StepContext;

/// What has to be done before the system may be used.
enum class Mend : std::uint8_t {
    nothing,
    rebuild,  ///< Analyse as it was, at the poses of that analysis.
    follow,   ///< Analyse for what is awake now, at the poses of the last analysis.
};

/// Copies of the last good state, of what has changed or is about to.
class Undo {
  public:
    /// How much may change beside velocities and impulses.
    enum class Depth : std::uint8_t {
        system,  ///< Links, cuts in force, groups, what sleeps: what stages graph to analyse do.
        model,   ///< Also images and copies of cuts.
        all,     ///< Also what a step leaves behind: for another state.
    };

    /// Room to keep motions without allocating. @throws std::bad_alloc.
    void reserve(const StepContext& ctx);
    /// Before v, λ or spin_change change outside stage integrate; later calls keep nothing more.
    void keep_motion(const StepContext& ctx) noexcept;
    /// Steps in which links were used last. @throws std::bad_alloc where there are more of them.
    void keep_links(const StepContext& ctx);
    /// Before the system changes. @throws std::bad_alloc, and nothing has changed then.
    void keep(const StepContext& ctx, Depth depth);
    /// keep() was called since.
    [[nodiscard]] bool holds() const noexcept { return depth_ >= 0; }
    /// Velocities and impulses are among what was kept.
    [[nodiscard]] bool moved() const noexcept { return moved_; }
    /// Everything as it was when it was kept first.
    void go_back(StepContext& ctx) noexcept;
    /// All is well.
    void drop() noexcept;

  private:
    struct Scalars {
        std::int64_t step;
        double time, work, drag, drive, friction, contact, damped, system_work, added;
        int refine_unasked;
        bool started;
        std::array<std::int64_t, kEventKindCount> event_count;
        JudgeState judge;
    };
    void keep_system(const StepContext& ctx);
    static Scalars read(const StepContext& ctx) noexcept;
    static void write(const Scalars& from, StepContext& ctx) noexcept;
    void go_back_system(StepContext& ctx) noexcept;
    void go_back_all(StepContext& ctx) noexcept;

    bool moved_ = false, linked_ = false;
    int depth_ = -1;  ///< −1: the system is as it was.

    // Motion.
    base::Array<double> v_, spin_change_, lambda_, active_;
    base::Array<std::uint8_t> repeats_, coarse_;
    std::vector<double> credit_;
    std::vector<std::int32_t> alert_;
    Scalars scalars_{};
    std::vector<std::int64_t> link_used_;

    // System.
    Mend mend_ = Mend::nothing;
    bool topology_changed_ = false;
    assembly::System::Kept system_;
    base::Array<double> analysed_x_, analysed_r_;
    base::Array<std::uint8_t> asleep_;
    base::Array<std::int32_t> quiet_;
    std::int32_t asleep_count_ = 0;
    std::vector<assembly::Contacts::Link> links_;
    std::vector<Cut> cuts_;
    std::uint64_t asked_ = 0;
    int interfaces_ = 0;
    std::vector<std::int32_t> group_;
    std::vector<Coupling> coupling_;
    graph::Partition parts_;
    Wires wires_;  ///< Where they are about to be found anew.
    std::int64_t made_ = 0, seen_ = -1;
    bool stale_ = true, grouped_ = false;
    std::int32_t grouped_interactions_ = 0;

    // Model.
    model::Bodies bodies_;
    model::Interactions interactions_;
    Cuts all_cuts_;

    // All.
    base::Array<collide::KeptContact> kept_;
    std::size_t kept_awake_ = 0;
    base::Array<assembly::ContactMemory> memory_;
    base::Array<assembly::ResistanceMemory> resistances_;
    collide::ContactSet contacts_;
    base::Array<double> contact_impulse_;
    base::Array<std::uint8_t> contact_sliding_;
    std::int32_t contact_count_ = 0;
};

/// Analyse as ctx.mend says. The state stays as it is, whatever happens. @throws std::bad_alloc,
/// LimitError.
void mend(StepContext& ctx);

/// Have the system be one for the state: mend what failed, prepare what is new. What changes is
/// kept first. @throws std::bad_alloc, LimitError.
void make_ready(StepContext& ctx);

/// Goes back where it is left without done(); within another one, that one does.
class Transaction {
  public:
    explicit Transaction(StepContext& ctx) noexcept;
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void done() noexcept;

  private:
    StepContext& ctx_;
    bool done_;
};

/// make_ready(), all or nothing, between steps. @throws std::bad_alloc, LimitError.
void ready(StepContext& ctx);

}  // namespace hawser::stepper
