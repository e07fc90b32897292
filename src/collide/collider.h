// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file collider.h
/// All shapes of a world, and stage collide: poses in, contacts out.
///
/// 1. Place every shape; box what it can reach within the step (placing.h).
/// 2. Broad phase: pairs of boxes that meet (broad.h), as far as the filter allows (filter.h).
/// 3. Narrow phase: the manifold of each pair (geometry.h), reduced (touch.h).
/// 4. Duplicates at shared lumps go; each contact finds itself in the last step's set (match.h).
///    What is asleep goes to the end (set_aside()).
///
/// Pairs are dealt out in chunks of fixed size and results are put together in the order of their
/// keys, so threads, and what the broad phase remembers, change no bit of them. Nothing is
/// allocated while the numbers of shapes, pairs and contacts stay below what they have been.
///
/// Continuous detection: boxes and margins grow with the velocities, so that a contact is there in
/// the step before two shapes would pass through each other; the solver then keeps gap + h v_n ≥ 0.
/// Not covered: a speed that first arises within the step (more than margin/h per step), and the
/// solver holds a shape off the tangent plane at the closest points, so that fast shapes can touch
/// beside an edge which they would just have missed.

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
    /// Shapes closer than this are in contact before they touch [m], see touch().
    double margin = 0.02;
    /// Contacts of a step, and eight times as many pairs of shapes, that collide() finds at most.
    std::int32_t most_contacts = 1'000'000'000;
    double most_bytes = 1e15;  ///< That its arrays may take.

    /// The definition has been checked (world/shape_checks.h) and its bodies exist. @return its
    /// index. @throws DefError for vertices without volume, std::bad_alloc.
    std::int32_t add(const ShapeDef& def, const model::Bodies& bodies);
    /// So that remove() does not throw. @throws std::bad_alloc.
    void make_room() {
        places.make_room();
        base::make_room(new_, shapes_.size() + 2);  // all of them may go
    }
    /// Nothing touches it any more. What was remembered of its contacts is for the caller to
    /// forget: kept().
    void remove(std::int32_t shape) noexcept;
    /// A segment goes between other bodies, one of which may hold it at a point of its frame [m].
    /// What was remembered of its contacts is for the caller to forget.
    void rewire(std::int32_t shape, std::int32_t first, std::int32_t second, const Vec3& point,
                const model::Bodies& bodies) noexcept;
    /// Take away the places from `kept` on, whose shapes have touched nothing yet.
    void truncate(std::int32_t kept) noexcept;
    /// Whether the box of a shape, at the present poses and with the margin, meets that of another
    /// one there: what is near must not depend on steps before. @param f  Called with the other
    /// one.
    template <class F>
    void each_near(std::int32_t shape, const model::Bodies& bodies, double h, F&& f) const;
    base::Places places;
    [[nodiscard]] int count() const noexcept { return static_cast<int>(shapes_.size()); }
    [[nodiscard]] const std::vector<Shape>& shapes() const noexcept { return shapes_; }

    /// Set up for the shapes, materials, interactions that there are now. Keeps a pointer to
    /// `interactions`: a segment of a line that has parted touches nothing any more, and one that a
    /// body holds begins where the line does.
    /// @throws std::bad_alloc.
    void prepare(const model::Bodies& bodies, const model::Interactions& interactions, double h);

    /// Contacts at the present poses; `out.surfaces` stays as surfaces() filled it.
    /// @return false where memory could not grow, or over() or finite() say more; `out` is then
    /// empty.
    [[nodiscard]] bool collide(const model::Bodies& bodies, double h, ContactSet& out,
                               base::Executor& pool) noexcept;
    /// The bound that the last collide() met, if any.
    [[nodiscard]] const BoundMet& over() const noexcept { return over_; }
    /// Whether all shapes had a place in the last collide(): else bodies move beyond all numbers.
    [[nodiscard]] bool finite() const noexcept { return finite_; }
    /// The step with these contacts is done: from now on they are what Contact::previous counts.
    /// Before it, collide() may be called again (a step that failed is tried again).
    void keep() noexcept {
        kept_.swap(found_);
        kept_awake_ = found_awake_;
    }
    /// Contacts that act on a body asleep go behind the others: each either has no other body with
    /// freedom, or only such as sleep too. @param asleep  1 a body. @return false where memory
    /// could not grow.
    [[nodiscard]] bool set_aside(ContactSet& out, const base::Array<std::uint8_t>& asleep) noexcept;
    /// Contacts of the last step that was done, in the order of its set: the memory that a restored
    /// world needs to go on bit for bit.
    [[nodiscard]] base::Array<KeptContact>& kept() noexcept { return kept_; }
    [[nodiscard]] const base::Array<KeptContact>& kept() const noexcept { return kept_; }

    /// The same in the set that the step under way found. @param stays  1 a contact: the others
    /// are forgotten.
    void forget(const std::vector<std::uint8_t>& stays) noexcept;
    /// Of kept(), those that took part: they come first.
    [[nodiscard]] std::size_t& kept_awake() noexcept { return kept_awake_; }
    [[nodiscard]] const std::size_t& kept_awake() const noexcept { return kept_awake_; }

    void surfaces(double h, ContactSet& out) const { materials.surfaces(h, out.surfaces); }
    /// Copy of the shapes and of what is remembered of their contacts.
    struct Kept {
        base::Places places;
        std::vector<Shape> shapes;
        std::vector<std::shared_ptr<const ShapeData>> data;
        base::Array<KeptContact> contacts;
        std::size_t awake = 0;
    };
    /// @throws std::bad_alloc.
    void keep(Kept& out) const;
    /// Back to a copy; prepare() before the next use.
    void go_back(Kept& to) noexcept;

    /// Where each shape was in the last collide().
    [[nodiscard]] const base::Array<Placed>& placed() const noexcept { return placed_; }
    [[nodiscard]] std::size_t pairs() const noexcept { return pairs_.size(); }
    /// Times that capacity grew in collide() since the start.
    [[nodiscard]] std::int64_t growths() const noexcept { return growths_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void place_all(const model::Bodies& bodies, double h, base::Executor& pool) noexcept;
    void narrow(double h, base::Executor& pool);
    void make_chunks(int tasks);
    void put_together(ContactSet& out, base::Executor& pool);
    void find_owners(int body_count);
    void find_lines(const model::Interactions& interactions, int body_count);

    std::vector<Shape> shapes_;
    std::vector<std::shared_ptr<const ShapeData>> data_;  ///< Of each shape, or null.
    const model::Interactions* lines_ = nullptr;
    Filter filter_;
    Broad broad_;
    base::Array<Placed> placed_;
    base::Array<Pair> pairs_;
    std::vector<std::unique_ptr<Contact[]>> chunks_;  ///< Contacts by task of the narrow phase.
    std::vector<std::int32_t> chunk_size_;
    base::Array<KeptContact> kept_, found_, aside_kept_;
    std::vector<Contact> aside_;
    std::size_t kept_awake_ = 0, found_awake_ = 0;
    BoundMet over_;
    bool finite_ = true;
    base::Array<std::uint8_t> drop_, taken_;
    std::vector<std::int32_t> new_;  ///< Shapes that came or went since prepare().
    bool all_new_ = false;           ///< All did.
    /// A piece of a line, listed at its end with the lower index.
    struct Line {
        std::int32_t other, id, before;  ///< `before`: in the same list, −1: none.
    };
    std::vector<Line> lines_of_bodies_;  ///< Scratch of prepare().
    std::vector<std::int32_t> of_body_;  ///< Scratch of prepare().
    std::size_t held_ = 0;               ///< Bytes at the last count of growths.
    std::int64_t growths_ = 0;
};

template <class F>
void Collider::each_near(std::int32_t shape, const model::Bodies& bodies, double h, F&& f) const {
    const auto now = [&](const Shape& s) {
        Placed placed{};
        placed.geometry = s.geometry;
        place(s, bodies, lines_, h, margin, placed);
        return placed.swept;
    };
    const Bounds own = now(shapes_[static_cast<std::size_t>(shape)]);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (shapes_[i].gone() || static_cast<std::int32_t>(i) == shape) continue;
        const Bounds box = now(shapes_[i]);
        bool meets = true;
        for (int k = 0; k < 3 && meets; ++k)
            meets = box.low[k] <= own.high[k] && own.low[k] <= box.high[k];
        if (meets) f(shapes_[i]);
    }
}

}  // namespace hawser::collide
