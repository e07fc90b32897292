// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file collider.h
/// All shapes of a world, and the stage that computes contacts from poses.
///
/// 1. Place every shape; compute the box that it can reach within the step (placing.h).
/// 2. Broad phase: find the pairs of boxes that meet (broad.h), as far as the filter allows
///    (filter.h).
/// 3. Narrow phase: compute the manifold of each pair (geometry.h) and reduce it (touch.h).
/// 4. Remove duplicates at shared nodes; find each contact in the set of the last step (match.h).
///    Move contacts of bodies asleep to the end (set_aside()).
///
/// Tasks process chunks of pairs of fixed size, and results are merged in the order of their keys.
/// Neither threads nor the memory of the broad phase change a bit of the results. No memory is
/// allocated while the numbers of shapes, pairs and contacts stay below their maxima so far.
///
/// Continuous detection: boxes and margins grow with the velocities. A contact exists in the step
/// before two shapes would pass through each other. The solver then keeps gap + h v_n ≥ 0.
///
/// Limits: a speed of more than margin/h that first arises within the step is not covered. The
/// solver keeps a shape on one side of the tangent plane at the closest points. Fast shapes can
/// therefore touch the plane next to an edge that they would have missed.

#include "base/executor.h"
#include "base/memory.h"
#include "base/places.h"
#include "collide/broad.h"
#include "collide/contacts.h"
#include "collide/filter.h"
#include "collide/match.h"
#include "collide/materials.h"
#include "collide/placing.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace hawser::collide {

class Collider {
  public:
    Materials materials;
    /// Largest gap at which shapes are in contact [m], see touch().
    double margin = 0.02;
    /// Maximum number of contacts of a step. The maximum number of pairs of shapes is eight times
    /// as large.
    std::int32_t most_contacts = 1'000'000'000;
    double max_bytes = 1e15;  ///< Limit of the memory of the arrays [B].

    /// Add a shape. Its definition has been checked (world/shape_checks.cpp) and its bodies exist.
    /// @return its index. @throws DefError for vertices without volume, std::bad_alloc.
    std::int32_t add(const ShapeDef& def, const model::Bodies& bodies);
    /// Allocate, so that remove() does not throw. @throws std::bad_alloc.
    void reserve_more() {
        slots.reserve_more();
        base::reserve_more(new_, shapes_.size() + 2);  // all of them may be removed
    }
    /// Remove a shape without contacts. The caller first removes the stored contacts by
    /// forget_contacts().
    void remove(std::int32_t shape) noexcept;
    /// Attach a segment to other bodies. One of them may hold it at a point of its frame [m]. The
    /// caller first removes the stored contacts by forget_contacts().
    void attach_segment(std::int32_t shape, std::int32_t first, std::int32_t second,
                        const Vec3& point, const model::Bodies& bodies) noexcept;
    /// Remove all slots with an index ≥ `kept`. Their shapes must not have had contacts yet.
    void truncate(std::int32_t kept) noexcept;
    /// Call f for each shape whose box overlaps the box of a given shape. Boxes are at the present
    /// poses and include the margin. The result does not depend on earlier steps. @param f  Called
    /// with the Shape.
    template <class F>
    void for_each_overlapping(std::int32_t shape, const model::Bodies& bodies, double h,
                              F&& f) const;
    base::Slots slots;
    [[nodiscard]] int count() const noexcept { return static_cast<int>(shapes_.size()); }
    [[nodiscard]] const std::vector<Shape>& shapes() const noexcept { return shapes_; }

    /// Prepare for the present shapes, materials and interactions. The collider keeps a pointer to
    /// `interactions`, for two reasons: the segment of a broken line has no contacts, and a segment
    /// held by a body begins at the end of the line.
    /// @throws std::bad_alloc.
    void prepare(const model::Bodies& bodies, const model::Interactions& interactions, double h);

    /// Compute the contacts at the present poses; `out.surfaces` stays as surfaces() set it.
    /// @return false if memory could not grow, or for the reason in limit_reached() or finite();
    /// `out` is
    ///        then empty.
    [[nodiscard]] bool collide(const model::Bodies& bodies, double h, ContactSet& out,
                               base::Executor& pool) noexcept;
    /// Return the limit that the last collide() reached, if any.
    [[nodiscard]] const BoundMet& limit_reached() const noexcept { return over_; }
    /// @return true if all boxes in the last collide() were finite; else a motion diverges.
    [[nodiscard]] bool finite() const noexcept { return finite_; }
    /// Make the contacts of the last collide() the stored contacts, to which Contact::previous
    /// refers in the next step. Call after the step is complete. If a step fails, collide() may be
    /// repeated before this call.
    void keep() noexcept {
        last_contacts_.swap(found_);
        last_awake_count_ = found_awake_;
    }
    /// Move contacts of sleeping bodies behind the others. Both bodies of such a contact sleep or
    /// have no degrees of freedom. @param asleep  1 for a sleeping body. @return false if memory
    /// could not grow.
    [[nodiscard]] bool set_aside(ContactSet& out, const base::Array<std::uint8_t>& asleep) noexcept;
    /// Return the contacts of the last completed step, in the order of its set. A restored world
    /// needs them to continue with the same bits.
    [[nodiscard]] base::Array<KeptContact>& last_contacts() noexcept { return last_contacts_; }
    [[nodiscard]] const base::Array<KeptContact>& last_contacts() const noexcept {
        return last_contacts_;
    }

    /// Remove stored contacts from last_contacts(). @param stays  For each contact: 0 to remove it.
    void forget_contacts(const std::vector<std::uint8_t>& stays) noexcept;
    /// Return the number of contacts in last_contacts() that took part in the step. They are first
    /// in the list.
    [[nodiscard]] std::size_t& last_awake_count() noexcept { return last_awake_count_; }
    [[nodiscard]] const std::size_t& last_awake_count() const noexcept { return last_awake_count_; }

    void surfaces(double h, ContactSet& out) const { materials.surfaces(h, out.surfaces); }
    /// Copy of the shapes and of the memory of their contacts.
    struct Kept {
        base::Slots slots;
        std::vector<Shape> shapes;
        std::vector<std::shared_ptr<const ShapeData>> data;
        base::Array<KeptContact> contacts;
        std::size_t awake = 0;
    };
    /// Save the state of the collider. @throws std::bad_alloc
    void keep(Kept& out) const;
    /// Restore a saved state. Call prepare() before the next use.
    void restore_shapes(Kept& to) noexcept;

    /// Return the placement of each shape in the last collide().
    [[nodiscard]] const base::Array<Placed>& placed() const noexcept { return placements_; }
    [[nodiscard]] std::size_t pairs() const noexcept { return pairs_.size(); }
    /// Return how often capacity grew in collide() since the start.
    [[nodiscard]] std::int64_t growth_count() const noexcept { return growth_count_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void place_shapes(const model::Bodies& bodies, double h, base::Executor& pool) noexcept;
    void collide_pairs(double h, base::Executor& pool);
    void make_chunks(int tasks);
    void merge_tasks(ContactSet& out, base::Executor& pool);
    void find_owners(int body_count);
    void find_lines(const model::Interactions& interactions, int body_count);

    std::vector<Shape> shapes_;
    std::vector<std::shared_ptr<const ShapeData>> data_;  ///< Data of each shape, or null.
    const model::Interactions* lines_ = nullptr;
    Filter filter_;
    Broad broad_;
    base::Array<Placed> placements_;
    base::Array<Pair> pairs_;
    std::vector<std::unique_ptr<Contact[]>> chunks_;  ///< Contacts by task of the narrow phase.
    std::vector<std::int32_t> chunk_size_;
    base::Array<KeptContact> last_contacts_, found_, last_set_aside_;
    std::vector<Contact> sleeping_;
    std::size_t last_awake_count_ = 0, found_awake_ = 0;
    BoundMet over_;
    bool finite_ = true;
    base::Array<std::uint8_t> is_dropped_, is_taken_;
    std::vector<std::int32_t> new_;  ///< Shapes added or removed since prepare().
    bool all_new_ = false;           ///< All did.
    /// A piece of a line, listed at its end with the lower index.
    struct Line {
        std::int32_t other, id, before;  ///< `before`: in the same list, −1: none.
    };
    std::vector<Line> lines_of_bodies_;  ///< Scratch of prepare().
    std::vector<std::int32_t> of_body_;  ///< Scratch of prepare().
    std::size_t held_ = 0;               ///< Bytes at the last count of growths.
    std::int64_t growth_count_ = 0;
};

template <class F>
void Collider::for_each_overlapping(std::int32_t shape, const model::Bodies& bodies, double h,
                                    F&& f) const {
    const auto now = [&](const Shape& s) {
        Placed placed{};
        placed.geometry = s.geometry;
        place(s, bodies, lines_, h, margin, placed);
        return placed.swept;
    };
    const Bounds own = now(shapes_[static_cast<std::size_t>(shape)]);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (shapes_[i].is_removed() || static_cast<std::int32_t>(i) == shape) continue;
        const Bounds box = now(shapes_[i]);
        bool meets = true;
        for (int k = 0; k < 3 && meets; ++k)
            meets = box.low[k] <= own.high[k] && own.low[k] <= box.high[k];
        if (meets) f(shapes_[i]);
    }
}

}  // namespace hawser::collide
