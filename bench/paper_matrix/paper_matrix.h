// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file paper_matrix.h
/// The system of one step of a scene of the size of the paper (Lacoursière, Nordfeldth, Linde,
/// "A partitioning method for parallelization of large systems in realtime"). It has two ships and
/// a rig, 20 bodies attached to each, ten cables of 93-94 elements, and 1000 contacts.
///
/// ```
///     a copy has                                  count    rows
///     hulls and attached bodies, 6 DoF each       3 + 60
///     cable elements, 3 DoF (lumped) or 6 (rigid) 937
///     hinge, lock: an attached body on its hull   48, 12   5, 6
///     motor between the same two                  60       1
///     link of a cable, ends included              947      3 (lumped: 1 between elements)
///     bend of three neighbours                    933      2
///     contact                                     1000     3
/// ```
///
/// 1000 bodies and 3000 interactions: n = 9414 lumped, 14079 rigid; 2496 pairs of bodies touch
/// the same interaction; the rig touches 132 others. Four cables end in the ground. Copies are
/// joined to one island: a ground end of each becomes an end at the first ship of the next. This
/// adds one bend, two rows.

#include "paper_matrix/block_system.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::bench {

class Dice;

enum class CableForm : std::uint8_t { lumped, rigid };

struct PaperOptions {
    CableForm form = CableForm::lumped;
    int scale = 1;      ///< Copies.
    int elements = 94;  ///< Largest number of elements a cable; at least 30. 94 = paper.
    std::uint64_t seed = 1;
};

/// A contact between two bodies, or of one with the ground (second = −1).
struct Contact {
    enum class Kind : std::uint8_t { hull_cable, hull_attached, attached, cables, ground };
    Kind kind = Kind::ground;
    int first = -1, second = -1;  ///< Bodies of the whole system.
};

class PaperScene {
  public:
    explicit PaperScene(const PaperOptions& options);

    [[nodiscard]] int bodies() const noexcept { return static_cast<int>(place_.size()); }
    [[nodiscard]] int interactions() const noexcept {
        return static_cast<int>(joints_.size() + contacts_.size());
    }
    [[nodiscard]] const std::vector<Contact>& contacts() const noexcept { return contacts_; }
    /// Return the node of contact i in system(). Changed contacts keep their nodes.
    [[nodiscard]] int contact_node(int i) const noexcept {
        const int copy = i / contacts_per_copy();
        return bodies() + joint_end_[static_cast<std::size_t>(copy)] + i;
    }

    /// Replace `count` contacts of every copy by others of the same kind nearby, as between steps.
    /// Step `step` is reproducible within the same sequence of steps. @return the contacts changed,
    /// ascending.
    std::vector<int> change_contacts(int count, int step);

    /// Return the whole system. The first nodes are bodies, followed by joints and contacts, copy
    /// by copy.
    [[nodiscard]] BlockSystem system() const;

  private:
    using Vec = std::array<double, 3>;
    enum class Kind : std::uint8_t { hinge, lock, motor, link, end, bend };
    struct Joint {
        Kind kind;
        std::array<int, 3> body{-1, -1, -1};  ///< Bend: previous, middle, next.
        Vec point{};                          ///< Point of a hinge, lock, link or end [m].
        Vec axis{};  ///< Axis of a hinge or motor, or direction of a cable.
    };
    struct CableEnds {
        int from, to;  ///< Bodies of the copy; to = −1: the ground.
    };

    void add_copy(int copy);
    void add_cable(int copy, int cable, const CableEnds& ends);
    void add_contacts(int copy);
    [[nodiscard]] Contact moved(const Contact& contact, Dice& dice) const;
    [[nodiscard]] int elements_of(int cable) const noexcept;
    [[nodiscard]] int element(int copy, int cable, int index) const noexcept;
    [[nodiscard]] bool wide(int body) const noexcept;  ///< Six degrees of freedom.
    [[nodiscard]] int dof(int body) const noexcept;
    [[nodiscard]] int per_copy() const noexcept;
    [[nodiscard]] int contacts_per_copy() const noexcept {
        return static_cast<int>(contacts_.size()) / options_.scale;
    }

    void emit_body(SystemBuilder& builder, int body) const;
    void emit_joint(SystemBuilder& builder, const Joint& joint) const;
    void emit_contact(SystemBuilder& builder, const Contact& contact, int index) const;
    /// Return rows of G for a body: direction · (velocity of the body at `point`).
    [[nodiscard]] std::vector<double> point_rows(int body, const std::vector<Vec>& directions,
                                                 const Vec& point, double factor) const;

    PaperOptions options_;
    std::vector<Vec> place_;      ///< Centre of each body [m].
    std::vector<Vec> along_;      ///< Cable elements: direction.
    std::vector<double> length_;  ///< Cable elements [m].
    std::vector<Joint> joints_;
    std::vector<int> joint_end_;  ///< Joints of each copy and those before it.
    std::vector<Contact> contacts_;
};

}  // namespace hawser::bench
