// SPDX-License-Identifier: Apache-2.0
// Values that are filled in during the factorisation, and a solution that starts with it.
#include "factor/matrices.h"
#include "runtime/tasks.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <atomic>

namespace hawser::test {
namespace {

/// Copies ranges of panels filled before, and counts the requests.
class Copy {
  public:
    Copy(const BlockMatrix& m, const factor::Symbolic& s)
        : panels_(static_cast<std::size_t>(s.panel_size), 0.0) {
        test::fill(m, s, panels_.data());
    }
    [[nodiscard]] factor::Fill fill(const factor::Numeric& numeric) {
        numeric_ = &numeric;
        auto write = [](void* self, int piece, double* panels) noexcept {
            static_cast<Copy*>(self)->write(static_cast<std::size_t>(piece), panels);
        };
        return {write, this};
    }
    std::atomic<std::int64_t> dirty_ = 0, filled_ = 0;

  private:
    void write(std::size_t piece, double* panels) noexcept {
        const factor::Piece& p = numeric_->pieces()[piece];
        for (std::int64_t i = p.panel_begin; i < p.panel_end; ++i) {
            dirty_ += panels[i] != 0.0;
            panels[i] = panels_[static_cast<std::size_t>(i)];
        }
        filled_ += p.panel_end - p.panel_begin;
    }

    const factor::Numeric* numeric_ = nullptr;
    std::vector<double> panels_;
};

TEST(Pieces, GivesTheBitsOfFillingFactoringAndSolving) {
    int resumed = 0;  // pieces that start within a batch
    const auto all = seeds(1, 10, 40, 400);
    for (const std::uint32_t seed : all) {
        Random random(seed);
        const bool grid = seed % 3 == 0;  // otherwise with chains in batches
        const BlockMatrix m = grid ? random_quasi_definite(random, 60, 0.05) : wires(random, 9, 40);
        const factor::Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
        const Vector b = random_matrix(random, m.scalars(), 1);
        base::SerialExecutor serial;
        const Solved want = solve(m, s, b, serial);
        Copy source(m, s);
        for (const int threads : {1, 3}) {
            runtime::Pool pool(threads);
            pool.resume();
            factor::Numeric numeric;
            numeric.piece_size = 500;
            if (seed % 2 == 0) numeric.streamed_size = 0;
            numeric.reserve(s, threads);
            for (const factor::Piece& p : numeric.pieces())
                resumed += p.begin == p.end &&
                           p.step_begin > s.batches[static_cast<std::size_t>(p.begin)].step_begin;
            for (int round = 0; round < 2; ++round) {  // the second round finds L in the panels
                Vector x = Vector::Zero(b.size() + 8);
                x.head(b.size()) = permuted(m, s, b, false);
                source.filled_ = source.dirty_ = 0;
                EXPECT_EQ(numeric.factor_forward(s, source.fill(numeric), x.data(), pool),
                          want.wrong);
                numeric.backward(s, x.data(), pool);
                const Vector got = permuted(m, s, x.head(b.size()), true);
                EXPECT_EQ(std::memcmp(want.x.data(), got.data(),
                                      sizeof(double) * static_cast<std::size_t>(got.size())),
                          0)
                    << "seed " << seed << ", threads " << threads << ", round " << round;
                EXPECT_EQ(source.dirty_, 0);
                // All values except for gaps after fronts.
                EXPECT_LE(source.filled_, s.panel_size);
                EXPECT_GE(source.filled_,
                          s.panel_size - 128 - 8 * static_cast<std::int64_t>(s.fronts.size()));
            }
        }
    }
    if (all.size() > 1) {
        EXPECT_GT(resumed, static_cast<int>(all.size()) * 2 / 3);
    }
}

}  // namespace
}  // namespace hawser::test
