// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contacts.h
/// Contact points of a step as rows of the system: from geometry to cones, and to the matrix.
///
/// Contacts are always condensed: Σ > 0. They appear and vanish, so that separate nodes would
/// change the structure at every contact. The structure changes only if two bodies touch for the
/// first time. The pair becomes a *link*, an edge of the pattern. It stays until it has not been
/// used for kKeepLinks steps and another link is needed. A contact with the ground needs no link:
/// it uses the diagonal block of the body.
///
/// Memory: while a contact sticks, its tangential rows act as a spring between two anchors. Each is
/// fixed in the frame of one side. On a segment the anchor is fixed at a position along it; if a
/// body holds an end, in the frame of that body. The spring depends on positions, not on
/// accumulated velocities, so that bodies at rest do not creep, even on a moving carrier. The
/// violation g_t is the tangential part of anchor 1 minus anchor 0; b_t = −(4/h)Υ g_t.
///
/// If the point slides, the anchors follow so that g_t = −ε_t λ_t/h, the deflection that belongs to
/// the friction force. If the point moves along the surfaces without sliding (rolling), the anchors
/// are reset at the point with the present g_t.

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

/// Number of steps for which an unused link stays.
inline constexpr std::int64_t kKeepLinks = 120;

/// State of a contact that is kept between steps. Plain data: part of the state.
struct ContactMemory {
    std::int32_t body[2][2];  ///< Bodies of each side; second −1: one body only.
    double fraction[2];       ///< Weight of the first body of each side at its anchor.
    /// Anchor of each side. Rigid body: in its frame. Point masses: relative to their weighted
    /// mean, in world axes. A point mass and a turning body: in axes of the body.
    double anchor[2][3];
    /// g_t from the velocities, for use if the point has moved away, world axes.
    double rolled[3];
    double lambda[3];  ///< Impulse of the last step, world axes [N s].
};

/// Memory of a point that appeared while its bodies fell asleep.
inline constexpr ContactMemory kNoMemory{{{-1, -1}, {-1, -1}}, {}, {}, {}, {}};

class Contacts {
  public:
    /// Pair of bodies, first < second.
    struct Link {
        std::int32_t first, second;
        friend auto operator<=>(const Link&, const Link&) = default;
    };

    /// Change of the blocks.
    enum class Blocks : std::uint8_t {
        same,
        own,  ///< Only diagonal blocks of bodies without links were added or removed.
        links
    };
    /// Set the bodies that have shapes. Call if they change. @throws std::bad_alloc.
    Blocks set_bodies(std::span<const std::int32_t> touching, const model::Bodies& bodies);

    /// Begin a step with `count` active contacts, followed by `asleep` contacts of sleeping bodies.
    /// The latter have no rows and keep their stored friction. @throws std::bad_alloc if the number
    /// grows.
    void begin(std::size_t count, std::size_t asleep);
    /// Mark contact `index` of this step as sleeping.
    void set_asleep(std::size_t index, std::int32_t previous) noexcept {
        next_[index] = previous >= 0 ? memory[static_cast<std::size_t>(previous)] : kNoMemory;
    }
    void set(std::size_t index, const collide::Contact& in, const collide::Surface& surface,
             const model::Bodies& bodies, double h) noexcept;
    /// Connect contacts with blocks and bodies, after all set(). @return false if pairs touch that
    /// are not links yet. Then call relink(), analyse the system, and call this again.
    [[nodiscard]] bool connect(std::int64_t step) noexcept;
    /// Add the missing links, and drop links that have not been used for many steps. @throws
    /// std::bad_alloc.
    void relink(std::int64_t step);

    /// Remove contacts of the last step with their rows and stored friction. @param stays  1 for
    /// each contact of `memory` to keep.
    void forget(const std::vector<std::uint8_t>& stays) noexcept;

    /// Discard the contact rows of a step that failed while they were being written.
    void forget_rows() noexcept {
        rows.clear();
        cones.clear();
        resistances.rows.clear();
        resistances.laws.clear();
    }

    /// Discard the missing links that connect() found.
    void forget_missing() noexcept { missing_.clear(); }

    /// Make blocks for the present links. @throws std::bad_alloc.
    void make_blocks();

    /// Compute u, λ and the impulses on bodies for contacts [begin, end).
    /// @param v  Velocities of the bodies; null: at rest.
    void update(const double* v, std::int32_t begin, std::int32_t end) noexcept;
    /// Compute u, λ and the impulses on bodies of resistances [begin, end), after update() of the
    /// contacts.
    void update_resistances(const double* v, std::int32_t begin, std::int32_t end) noexcept;
    /// Set the impulse λ of contact k to that of the last step, as a start of the solution.
    void recall_lambda(std::size_t k) noexcept;
    /// Return the number of bodies with contacts in this step.
    [[nodiscard]] std::size_t touched() const noexcept { return touched_.size(); }
    /// Compute the impulses Jᵀλ of contacts on the touched bodies [begin, end). Call after update()
    /// of all contacts.
    void gather(std::int32_t begin, std::int32_t end) noexcept;
    /// Add the momentum Jᵀx to the solver's vector, for an impulse x on each contact (three entries
    /// per contact, then three per resistance).
    void scatter(const double* x, double* solution, const std::int32_t* offset) const noexcept;
    /// Compute the relative velocities J u of contacts from the velocities in the solver's vector.
    void collect(const double* solution, const std::int32_t* offset, double* u) const noexcept;
    /// Mark the blocks to which a contact with `changed` set adds, and the blocks whose S is
    /// unsymmetric.
    void mark_blocks() noexcept;
    void write_blocks(std::int32_t begin, std::int32_t end) noexcept;

    /// Store friction anchors and impulses of contacts [begin, end) for the next step. Call after
    /// the solve and before the bodies move. Call keep() after all ranges have been stored.
    void remember(const model::Bodies& bodies, double h, std::int32_t begin,
                  std::int32_t end) noexcept;
    void keep(double h) noexcept;

    [[nodiscard]] std::size_t count() const noexcept { return rows.size(); }
    /// Return the number of contacts and resistances, with three rows each.
    [[nodiscard]] std::size_t triples() const noexcept { return count() + resistances.count(); }
    [[nodiscard]] std::size_t bytes() const noexcept;
    /// Return the moving bodies with shapes, ascending, as set by the latest set_bodies(). The next
    /// function returns those of the call before.
    [[nodiscard]] std::span<const std::int32_t> touching() const noexcept { return touching_; }
    [[nodiscard]] std::span<const std::int32_t> touching_before() const noexcept {
        return touching_before_;
    }

    base::Array<ContactRow> rows;
    base::Array<nonsmooth::Cone> cones;
    Resistances resistances;
    /// Memory of the contacts of the last finished step, in the order of its set. Part of the
    /// state.
    base::Array<ContactMemory> memory;
    std::vector<ContactBlock> blocks;  ///< Own blocks of bodies, then links; sorted.
    base::Array<double> block_value;
    std::vector<std::uint8_t> block_used;
    std::vector<std::uint8_t> block_changed, block_skew;  ///< See mark_blocks().
    std::vector<std::uint8_t> changed;                    ///< By contact: 1 if its S changed.
    base::Array<double> impulse;          ///< Impulse on bodies, packed like velocities.
    base::Array<double> slot_impulse;     ///< 24 per contact.
    std::vector<Link> links;              ///< Ascending.
    std::vector<std::int64_t> link_used;  ///< Latest step that needed each link.

  private:
    void drop_links() noexcept;
    void list_blocks();
    /// True if the blocks match the present bodies and links.
    [[nodiscard]] bool has_blocks() const noexcept;
    [[nodiscard]] std::int32_t block_of(std::int32_t a, std::int32_t b) const noexcept;
    /// True if contacts act on the bodies on which they acted in the previous call.
    [[nodiscard]] bool same_bodies() noexcept;
    // Find the blocks on which contacts act (step of connect()). The list functions below then
    // build the lists.
    [[nodiscard]] bool find_blocks(std::int64_t step) noexcept;
    void list_terms() noexcept;
    void list_slots() noexcept;

    struct Extra {
        double epsilon_t;
        double tangent_gap[3];  ///< Tangential violation g_t, world axes [m].
        double point[3];        ///< Contact point, world frame [m].
    };
    base::Array<ContactMemory> next_;  ///< Memory of the contacts of this step.
    std::vector<Extra> extra_;
    std::vector<std::int32_t> own_block_;  ///< By body; −1: no shape or no degrees of freedom.
    std::vector<std::int32_t> touching_, touching_before_;
    std::vector<std::int32_t> needed_;  ///< Block of each pair of slots, 16 per contact.
    std::vector<ContactTerm> terms_;
    std::vector<std::int32_t> cursor_;
    std::vector<std::int32_t> incident_begin_, incident_;  ///< Slots of each touched body.
    std::vector<std::int32_t> touched_, touched_before_;   ///< Bodies.
    std::vector<std::int32_t> place_;                      ///< By body: index in touched_.
    std::vector<Link> missing_;
    bool connected_ = false;  ///< True if blocks, terms and incidences match bodies_of_.
    std::vector<std::array<std::int32_t, 4>> bodies_of_;  ///< Bodies of each contact.
    std::vector<std::int32_t> dof_begin_, dof_;
};

}  // namespace hawser::assembly
