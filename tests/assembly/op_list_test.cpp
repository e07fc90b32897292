// SPDX-License-Identifier: Apache-2.0
/// List of contributions against one made by a direct method. Bodies, interactions, links of
/// contacts and forms of these worlds change at random.
#include "assembly/op_list.h"
#include "context/context.h"
#include "context/view.h"
#include "support/random.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

using context::StepContext;

/// A model that is changed without calls of the stepper.
class Changing {
  public:
    Changing(std::uint32_t seed, Form form) : random_(100ULL + seed) {
        Recipe r = seed % 2 == 0 ? chains(seed, 11, 9) : wires(seed);
        r.world.form = form;
        ctx_ = r.context();
    }
    StepContext& ctx() { return *ctx_; }
    void analyse() {
        model::Bodies& b = bodies();
        ctx_->model.system.analyse(b, interactions(), ctx_->model.def, 1);
    }
    void expect_plain() {
        const assembly::View v = context::view(*ctx_);
        expect_plain_ops(ctx_->model.system, bodies(), v);
    }
    /// Expect that the index of a body lists the interactions that a search of all interactions
    /// finds.
    void expect_holders() {
        using Holder = std::pair<std::int32_t, std::size_t>;
        constexpr auto kSlots = static_cast<std::size_t>(kMaxInteractionBodies);
        std::vector<std::vector<Holder>> wanted(static_cast<std::size_t>(bodies().count()));
        for (std::int32_t i = 0; i < interactions().count(); ++i)
            for (std::size_t slot = 0; slot < kSlots; ++slot)
                if (const std::int32_t b =
                        interactions().body[kSlots * static_cast<std::size_t>(i) + slot];
                    b >= 0)
                    wanted[static_cast<std::size_t>(b)].emplace_back(i, slot);
        for (std::int32_t b = 0; b < bodies().count(); ++b) {
            std::vector<Holder> found;
            interactions().for_each_holder(b, bodies(), [&](std::int32_t id, std::size_t slot) {
                found.emplace_back(id, slot);
            });
            std::sort(found.begin(), found.end());
            ASSERT_EQ(found, wanted[static_cast<std::size_t>(b)]) << b;
        }
    }
    /// Make a random change. @return true if only links changed: relink() is enough.
    bool change() {
        switch (random_.integer(0, 5)) {
            case 0:
                add_line();
                return false;
            case 1:
                remove_line();
                return false;
            case 2:
                add_lump();
                return false;
            case 3:
                remove_lump();
                return false;
            case 4:
                change_touching();
                return false;
            default:
                change_links();
                return true;
        }
    }

  private:
    /// Make wires of point masses in parallel between two bodies, in three lengths, and some free
    /// point masses.
    static Recipe wires(std::uint64_t seed) {
        Random random(seed);
        Recipe r;
        const BodyId ground = r.ground();
        const BodyId hull = r.rigid({0, 0, 5}, Quat::Identity(), 1e4, Vec3(1e4, 1e4, 1e4));
        for (int w = 0; w < 12; ++w) {
            std::vector<BodyId> nodes{ground};
            const int count = 8 + 4 * random.integer(0, 2);
            for (int k = 0; k < count; ++k) nodes.push_back(r.lump({k + 1.0, w * 2.0, 0}, 3.0));
            if (w % 3 != 0) nodes.push_back(hull);
            for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
                r.add(between(InteractionKind::Stretch, {nodes[k], nodes[k + 1]})
                          .set("EA", 1e5)
                          .set("length", 1.0));
            for (std::size_t k = 0; k + 2 < nodes.size() && w % 2 == 0; ++k)
                if (nodes[k] != ground && nodes[k + 2] != hull)
                    r.add(between(InteractionKind::Bend, {nodes[k], nodes[k + 1], nodes[k + 2]})
                              .set("EI", 1.0));
        }
        for (int k = 0; k < 5; ++k) r.lump({-5.0, 1.0 * k, 0}, 2.0);
        return r;
    }

    model::Bodies& bodies() { return ctx_->model.bodies; }
    model::Interactions& interactions() { return ctx_->model.interactions; }
    assembly::Contacts& contacts() { return ctx_->model.system.contacts; }
    std::int32_t some_moving() {
        const auto& moving = bodies().moving;
        return moving[static_cast<std::size_t>(
            random_.integer(0, static_cast<int>(moving.size()) - 1))];
    }
    void add_line(std::int32_t a, std::int32_t b) {
        if (a == b) return;
        InteractionDef d = between(InteractionKind::Stretch, {bodies().id(a), bodies().id(b)});
        interactions().add(d.set("EA", 1e4).set("length", 2.0), bodies(), ctx_->model.def.step);
    }
    void add_line() { add_line(some_moving(), some_moving()); }
    void remove_line() {
        std::vector<std::int32_t> there;
        for (std::int32_t i = 0; i < interactions().count(); ++i)
            if (!interactions().gone(i)) there.push_back(i);
        if (there.empty()) return;
        interactions().remove(
            there[static_cast<std::size_t>(random_.integer(0, static_cast<int>(there.size()) - 1))],
            bodies());
    }
    void add_lump() {
        const std::int32_t to = some_moving();
        const int body = bodies().add({.kind = BodyKind::lump,
                                       .position = {0.0, -1.0, random_.uniform(-3.0, 3.0)},
                                       .mass = 1.0});
        add_line(to, body);
    }
    void remove_lump() {
        const std::int32_t body = some_moving();
        if (bodies().dof(body) != 3) return;
        for (std::int32_t i = 0; i < interactions().count(); ++i)
            for (int b = 0; b < interactions().bodies[static_cast<std::size_t>(i)]; ++b)
                if (interactions().body[static_cast<std::size_t>(kMaxInteractionBodies) *
                                            static_cast<std::size_t>(i) +
                                        static_cast<std::size_t>(b)] == body) {
                    interactions().remove(i, bodies());
                    break;
                }
        drop_contacts_of(body);
        bodies().remove(body);
    }
    void drop_contacts_of(std::int32_t body) {
        std::erase(touching_, body);
        set_touching();
    }
    void set_touching() {
        std::sort(touching_.begin(), touching_.end());
        touching_.erase(std::unique(touching_.begin(), touching_.end()), touching_.end());
        (void)contacts().set_bodies(touching_, bodies());
    }
    void change_touching() {
        const std::int32_t body = some_moving();
        if (std::erase(touching_, body) == 0) touching_.push_back(body);
        set_touching();
    }
    void change_links() {
        if (touching_.size() < 2) return;
        auto& links = contacts().links;
        const auto one = [&] {
            return touching_[static_cast<std::size_t>(
                random_.integer(0, static_cast<int>(touching_.size()) - 1))];
        };
        const std::int32_t a = one(), b = one();
        if (a == b) return;
        const assembly::Contacts::Link link{std::min(a, b), std::max(a, b)};
        const auto found = std::lower_bound(links.begin(), links.end(), link);
        const auto used = contacts().link_used.begin() + (found - links.begin());
        if (found != links.end() && *found == link) {
            contacts().link_used.erase(used);
            links.erase(found);
        } else {
            contacts().link_used.insert(used, 0);
            links.insert(found, link);
        }
        contacts().make_blocks();
    }

    Random random_;
    std::unique_ptr<StepContext> ctx_;
    std::vector<std::int32_t> touching_;
};

/// Number of steps, and of batches that an analysis kept from the one before.
struct Carried {
    std::ptrdiff_t kept = 0, steps = 0;
};

void change_at_random(std::uint32_t seed, Form form, Carried& carried) {
    Changing model(seed, form);
    model.expect_plain();
    EXPECT_GT(model.ctx().model.system.lane_ops.size(), 20U);
    for (int k = 0; k < 120; ++k) {
        SCOPED_TRACE("change " + std::to_string(k));
        bool links_alone = true;
        for (int n = k % 4 == 0 ? 3 : 1; n > 0; --n) links_alone &= model.change();
        if (links_alone)
            model.ctx().model.system.relink(model.ctx().model.bodies,
                                            model.ctx().model.interactions, 1);
        else
            model.analyse();
        model.expect_plain();
        model.expect_holders();
        if (testing::Test::HasFatalFailure()) return;
        carried.kept += model.ctx().model.system.carried();
        carried.steps += std::ssize(model.ctx().model.system.symbolic.batch_steps);
    }
}

class OpList : public testing::TestWithParam<Form> {};
INSTANTIATE_TEST_SUITE_P(Changes, OpList,
                         testing::Values(Form::automatic, Form::saddle, Form::condensed));

TEST_P(OpList, IsThatOfThePlainWay) {
    Carried carried;
    const auto all = seeds(1, 4, 16, 160);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        change_at_random(seed, GetParam(), carried);
        if (HasFailure()) return;
    }
    if (all.size() == 1) return;
    // Expect that some batches are kept and some are not.
    EXPECT_GT(carried.kept, carried.steps / 20);
    EXPECT_LT(carried.kept, carried.steps);
}

}  // namespace
}  // namespace hawser::test
