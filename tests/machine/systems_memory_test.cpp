// SPDX-License-Identifier: Apache-2.0
/// Allocation fails while systems are added and while they act.
#include "machine/retry.h"
#include "systems/acting.h"

#include "support/recipe.h"

#include <memory>
#include <string>

namespace hawser::test {
namespace {

/// A system that loads one more body in each step.
class Growing final : public System {
  public:
    explicit Growing(std::string name) : name_(std::move(name)) {}
    [[nodiscard]] std::string_view name() const noexcept override { return name_; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        count_ += 1.0;
        for (int b = 0; b < now.world.body_count() && b < 2.0 * count_; ++b) {
            loads.add_mass(BodyId{b}, Mat3(Mat3::Identity() * 3.0));
            loads.add_force(BodyId{b}, {count_, 0, 0});
        }
        now.set_input(InputId{0}, count_);
        for (int e = 0; e < 20 * count_; ++e) now.tell(EventKind::layer, BodyId{1}, e);
    }
    void visit_state(StateVisitor& v) override { v.visit(count_); }
    void signals(SignalTable& table) override {
        table.output("a signal with a name that is longer than a short string", "1", count_);
    }

  private:
    std::string name_;
    double count_ = 0.0;
};

TEST(MemoryEnds, WhereSystemsActAndLoad) {
    expect_same_bits("systems", [&](Retry& retry) {
        Recipe r = chains(2, 2, 6);
        r.world.threads = 2;
        World w = r.make();
        w.add_input({.name = "push", .interaction = {}, .param = {}, .body = BodyId{1}});
        for (const char* name : {"one", "another with a name that is longer than a short string"})
            retry.call(w, "add_system", throwing([&](World& to) {
                           to.add_system(std::make_unique<Growing>(name));
                       }));
        for (int i = 0; i < 6; ++i) retry.call(w, "step", step_once, i > 0);
        // Each of both reports 20, 40, … 120 events, for any failed allocations before.
        EXPECT_EQ(w.events().extremes(EventKind::layer).count, 2 * 20 * 21);
        retry.call(w, "remove_system",
                   throwing([](World& to) { (void)to.remove_system(to.system(0)); }));
        for (int i = 0; i < 2; ++i) retry.call(w, "step", step_once, i > 0);
    });
}

}  // namespace
}  // namespace hawser::test
