// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file queued_edits.h
/// What systems ask to be added and removed in a step, until it is done.

#include <hawser/system.h>

#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace hawser::world {

/// Definitions and ids in the order in which they were asked for. What an addition returns is a
/// stand-in, with an index below −1: −2 is the first body that was queued, −3 the second, …
class QueuedEdits final : public Edits::Hands {
  public:
    BodyId add(const BodyDef& def) noexcept override;
    InteractionId add(const InteractionDef& def) noexcept override;
    ShapeId add(const ShapeDef& def) noexcept override;
    WireId add(const WireDef& def) noexcept override;
    void remove(BodyId id) noexcept override { put(id); }
    void remove(InteractionId id) noexcept override { put(id); }
    void remove(ShapeId id) noexcept override { put(id); }
    void remove(WireId id) noexcept override { put(id); }
    void part(InteractionId id) noexcept override { put(Part{id}); }

    /// Whose edits those to come are.
    void begin_system(std::string_view name) noexcept { system_ = name; }
    void clear() noexcept;
    [[nodiscard]] std::size_t size() const noexcept { return list_.size(); }
    [[nodiscard]] std::size_t left() const noexcept { return list_.size() - done_; }
    [[nodiscard]] bool out_of_memory() const noexcept { return out_of_memory_; }
    /// Name of the system that asked for the next edit.
    [[nodiscard]] std::string_view next_system() const noexcept { return list_[done_].system; }
    /// Make the next one. @throws what World's function does; it is then still to be made.
    void make_next(World& world);

  private:
    struct Part {
        InteractionId id;
    };
    using Edit = std::variant<BodyDef, InteractionDef, ShapeDef, WireDef, BodyId, InteractionId,
                              ShapeId, WireId, Part>;
    struct Entry {
        Edit edit;
        std::string_view system;
    };
    /// What additions have become.
    struct Made {
        std::vector<BodyId> bodies;
        std::vector<InteractionId> interactions;
        std::vector<ShapeId> shapes;
        std::vector<WireId> wires;
    };
    template <class T>
    bool put(const T& edit) noexcept;
    static void make(const Edit& edit, World& world, Made& made);

    std::vector<Entry> list_;
    std::size_t done_ = 0;
    Made made_;
    std::int32_t bodies_ = 0, interactions_ = 0, shapes_ = 0, wires_ = 0;  ///< Queued.
    std::string_view system_;
    bool out_of_memory_ = false;
};

}  // namespace hawser::world
