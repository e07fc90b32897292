// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contacts.h
/// Contact points of a step as rows of the system: from geometry to cones, and to the matrix.
///
/// Contacts are always condensed: Σ > 0, and they come and go, so that a node of their own would
/// change the structure at every touch. What changes it now is a pair of bodies that has not
/// touched before: it becomes a *link*, an edge of the pattern that stays until it has not been
/// used for kKeepLinks steps and another link is needed anyway. A contact with the ground
/// needs none: its block is that of the body itself.
///
/// **Memory.** While a contact sticks, its tangential rows hold a spring between two anchors, one
/// fixed in the frame of each side (of a segment: at a place along it, and where a body holds an
/// end in the frame of that body): a position, not an accumulated velocity, so that what rests does
/// not creep, however its carrier moves. The violation g_t is the tangential part of anchor 1 minus
/// anchor 0; b_t = −(4/h)Υ g_t. When the point slides, the anchors follow so that g_t = −ε_t λ_t/h,
/// what the spring of the friction force amounts to; when the point wanders along the surfaces
/// without sliding (rolling), they are set anew at the point with g_t as it is.

#include <hawser/def.h>

#include "assembly/contact_rows.h"
#include "assembly/resistances.h"
#include "base/memory.h"
#include "collide/contacts.h"
#include "model/bodies.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::assembly {

/// Steps that an unused link stays for.
inline constexpr std::int64_t kKeepLinks = 120;

/// What a contact remembers. Plain data: part of the state.
struct ContactMemory {
    std::int32_t body[2][2];  ///< Of each side; −1: one body only.
    double share[2];          ///< Weight of the first body of each side at its anchor.
    /// Rigid: body's frame. Lumps: from their weighted mean, world axes; of a lump and a body that
    /// turns the body's.
    double anchor[2][3];
    double rolled[3];  ///< g_t by the velocities, should the point have wandered, world axes.
    double lambda[3];  ///< Impulse of the last step, world axes [N s].
};

/// Of a point that bodies came to have while they fell asleep.
inline constexpr ContactMemory kNoMemory{{{-1, -1}, {-1, -1}}, {}, {}, {}, {}};

class Contacts {
  public:
    /// Bodies first < second.
    struct Link {
        std::int32_t first, second;
        friend auto operator<=>(const Link&, const Link&) = default;
    };

    /// What changed of the blocks.
    enum class Blocks : std::uint8_t {
        same,
        own,  ///< Bodies have one now, or none any more, that no link joins with another one.
        links
    };
    /// Bodies that have shapes; call when that changes. @throws std::bad_alloc.
    Blocks set_bodies(std::span<const std::int32_t> touching, const model::Bodies& bodies);

    /// Begin a step with so many contacts, and `asleep` behind them that have no rows but keep what
    /// they remember. @throws std::bad_alloc when the number grows.
    void begin(std::size_t count, std::size_t asleep);
    /// Contact `index` of the step's set sleeps.
    void set_asleep(std::size_t index, std::int32_t previous) noexcept {
        next_[index] = previous >= 0 ? memory[static_cast<std::size_t>(previous)] : kNoMemory;
    }
    void set(std::size_t index, const collide::Contact& in, const collide::Surface& surface,
             const model::Bodies& bodies, double h) noexcept;
    /// After all set(): blocks and incidences. @return false: pairs touch that are no links yet;
    /// then relink(), analyse the system, and call this again.
    [[nodiscard]] bool connect(std::int64_t step) noexcept;
    /// Add the pairs needed, drop those long unused. @throws std::bad_alloc.
    void relink(std::int64_t step);

    /// Contacts of the last step that leave; their rows and memories go. @param stays  1 a contact
    /// of `memory`: it stays.
    void forget(const std::vector<std::uint8_t>& stays) noexcept;

    /// What connect() missed is not asked for any more.
    void forget_missing() noexcept { missing_.clear(); }

    /// Blocks for the links there are. @throws std::bad_alloc.
    void make_blocks();

    /// u, λ and the impulses on bodies at velocities v; null: at rest.
    void update(const double* v, std::int32_t begin, std::int32_t end) noexcept;
    /// u, λ and the impulses on bodies of resistances [begin, end), after those of contacts.
    void update_resistances(const double* v, std::int32_t begin, std::int32_t end) noexcept;
    /// λ of contact k: that of the last step.
    void recall_lambda(std::size_t k) noexcept;
    /// Bodies with contacts in this step.
    [[nodiscard]] std::size_t touched() const noexcept { return touched_.size(); }
    /// Jᵀλ of some of these, after update() of all.
    void gather(std::int32_t begin, std::int32_t end) noexcept;
    /// Jᵀx added to the solver's vector, for an impulse x on each contact (three a contact, then
    /// three a resistance).
    void scatter(const double* x, double* solution, const std::int32_t* offset) const noexcept;
    /// J times the solver's vector.
    void collect(const double* solution, const std::int32_t* offset, double* u) const noexcept;
    /// Blocks to which a contact with `changed` set adds, and blocks whose S is unsymmetric.
    void mark_blocks() noexcept;
    void write_blocks(std::int32_t begin, std::int32_t end) noexcept;

    /// After the solve, before the bodies move: the memory that the next step starts from, of
    /// contacts [begin, end). When all have been done, keep().
    void remember(const model::Bodies& bodies, double h, std::int32_t begin,
                  std::int32_t end) noexcept;
    void keep(double h) noexcept;

    [[nodiscard]] std::size_t count() const noexcept { return rows.size(); }
    /// Contacts and resistances: rows in threes.
    [[nodiscard]] std::size_t triples() const noexcept { return count() + resistances.count(); }
    [[nodiscard]] std::size_t bytes() const noexcept;
    /// Bodies with shapes that move, ascending: the first blocks are their own. As set_bodies() was
    /// given them, and the time before.
    [[nodiscard]] std::span<const std::int32_t> touching() const noexcept { return touching_; }
    [[nodiscard]] std::span<const std::int32_t> touching_before() const noexcept {
        return touching_before_;
    }

    base::Array<ContactRow> rows;
    base::Array<nonsmooth::Cone> cones;
    Resistances resistances;
    /// Of the contacts of the last step that was done, in the order of its set. Part of the state.
    base::Array<ContactMemory> memory;
    std::vector<ContactBlock> blocks;  ///< Bodies' own, then links; sorted.
    base::Array<double> block_value;
    std::vector<std::uint8_t> block_used;
    std::vector<std::uint8_t> block_changed, block_skew;  ///< See mark_blocks().
    std::vector<std::uint8_t> changed;                    ///< By contact: its S changed.
    base::Array<double> impulse;                          ///< Packed like velocities.
    base::Array<double> slot_impulse;                     ///< 24 a contact.
    std::vector<Link> links;                              ///< Ascending.
    std::vector<std::int64_t> link_used;                  ///< Step in which each was needed last.

  private:
    void drop_links() noexcept;
    void list_blocks();
    /// Whether the blocks are those of the bodies and links that there are.
    [[nodiscard]] bool has_blocks() const noexcept;
    [[nodiscard]] std::int32_t block_of(std::int32_t a, std::int32_t b) const noexcept;
    /// Whether contacts act on the same bodies as when this was last asked.
    [[nodiscard]] bool same_bodies() noexcept;
    // connect() in three parts: which blocks contacts act on, and the lists made from them.
    [[nodiscard]] bool find_blocks(std::int64_t step) noexcept;
    void list_terms() noexcept;
    void list_slots() noexcept;

    struct Extra {
        double epsilon_t;
        double tangent_gap[3];  ///< g_t, world axes [m].
        double point[3];        ///< World frame [m].
    };
    base::Array<ContactMemory> next_;  ///< Of this step's contacts.
    std::vector<Extra> extra_;
    std::vector<std::int32_t> own_block_;  ///< By body; −1: no shape or no freedom.
    std::vector<std::int32_t> touching_, touching_before_;
    std::vector<std::int32_t> needed_;  ///< Block of each slot pair of each contact, 16 a contact.
    std::vector<ContactTerm> terms_;
    std::vector<std::int32_t> cursor_;
    std::vector<std::int32_t> incident_begin_, incident_;  ///< Slots of each touched body.
    std::vector<std::int32_t> touched_, touched_before_;   ///< Bodies.
    std::vector<std::int32_t> place_;                      ///< By body: index in touched_.
    std::vector<Link> missing_;
    bool connected_ = false;  ///< Blocks, terms and incidences are those of bodies_of_.
    std::vector<std::array<std::int32_t, 4>> bodies_of_;  ///< Bodies of each contact.
    std::vector<std::int32_t> dof_begin_, dof_;
};

}  // namespace hawser::assembly
