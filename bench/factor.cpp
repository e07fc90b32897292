// SPDX-License-Identifier: Apache-2.0
// hawser-bench factor: the matrix of a scene's step, factored and solved by us and by libraries.
//
// The pattern and the order are the scene's own (World::inspect). The values are drawn at random
// with the sign structure of the real matrix and a dominant diagonal, the same for everyone; the
// libraries get it as a scalar matrix in their own best order.
#include <hawser/inspect.h>

#include "base/executor.h"
#include "commands.h"
#include "factor/numeric.h"
#include "factor/ordering.h"
#include "scene/scene.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <Eigen/Sparse>
#include <nlohmann/json.hpp>

#if HAWSER_HAVE_CHOLMOD
#include <cholmod.h>
#endif

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <random>

namespace hawser::bench {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

double seconds(const std::function<void()>& f) {
    const auto from = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

/// The block matrix: one dense block for each node and edge, in the order of the pattern.
struct Problem {
    factor::Pattern pattern;
    std::vector<std::int32_t> scalar;  ///< First scalar of each node, natural order.
    Sparse lower;                      ///< Lower triangle, natural order.
    Vector rhs;
};

Problem make_problem(const SystemView& view) {
    Problem p;
    std::vector<std::int8_t> size, sign;
    std::int32_t at = 0;
    for (const SystemNode& n : view.nodes) {
        size.push_back(static_cast<std::int8_t>(n.size));
        sign.push_back(n.body.valid() ? 1 : -1);
        p.scalar.push_back(at);
        at += n.size;
    }
    p.pattern.size = size;
    p.pattern.sign = sign;
    p.pattern.start = view.edge_start;
    p.pattern.adjacent = view.edges;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> entry(-1.0, 1.0);
    std::vector<Eigen::Triplet<double>> triplets;
    Vector row_sum = Vector::Zero(at);
    auto put = [&](std::int32_t i, std::int32_t j) {
        const double v = entry(random);
        triplets.emplace_back(std::max(i, j), std::min(i, j), v);
        row_sum[i] += std::abs(v);
        row_sum[j] += std::abs(v);
    };
    for (int a = 0; a < p.pattern.nodes(); ++a) {
        const auto na = static_cast<std::size_t>(a);
        for (int i = 0; i < size[na]; ++i)
            for (int j = 0; j < i; ++j) put(p.scalar[na] + i, p.scalar[na] + j);
        for (std::int32_t b : p.pattern.neighbours(a)) {
            if (b > a) continue;
            const auto nb = static_cast<std::size_t>(b);
            for (int i = 0; i < size[na]; ++i)
                for (int j = 0; j < size[nb]; ++j) put(p.scalar[na] + i, p.scalar[nb] + j);
        }
    }
    for (int a = 0; a < p.pattern.nodes(); ++a) {
        const auto na = static_cast<std::size_t>(a);
        for (int i = 0; i < size[na]; ++i)
            triplets.emplace_back(p.scalar[na] + i, p.scalar[na] + i,
                                  sign[na] * (row_sum[p.scalar[na] + i] + 1.0));
    }
    p.lower.resize(at, at);
    p.lower.setFromTriplets(triplets.begin(), triplets.end());
    p.rhs = Vector::Random(at);
    return p;
}

/// A solver under test: analyse once, then refactor and solve.
struct Candidate {
    std::string name;
    std::function<void()> analyse, refactor_solve;
    Vector x;
    std::vector<double> analyse_ms, work_ms;
};

double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

struct Ours {
    factor::Symbolic symbolic;
    factor::Numeric numeric;
    base::SerialExecutor serial;
    std::vector<std::pair<std::int64_t, double>> scatter;  ///< Panel address, value.
    std::vector<double> x;

    void analyse(const Problem& p) {
        symbolic = factor::analyse(p.pattern, factor::order_nodes(p.pattern));
        numeric.reserve(symbolic, 1);
    }
    void map(const Problem& p) {
        std::vector<std::int32_t> node(static_cast<std::size_t>(p.lower.rows()));
        for (int a = 0; a < p.pattern.nodes(); ++a)
            for (int i = 0; i < p.pattern.size[static_cast<std::size_t>(a)]; ++i)
                node[static_cast<std::size_t>(p.scalar[static_cast<std::size_t>(a)] + i)] = a;
        for (int j = 0; j < p.lower.outerSize(); ++j)
            for (Sparse::InnerIterator it(p.lower, j); it; ++it) {
                std::int64_t r = it.row(), c = it.col();
                auto nr = static_cast<std::size_t>(node[static_cast<std::size_t>(r)]);
                auto nc = static_cast<std::size_t>(node[static_cast<std::size_t>(c)]);
                if (symbolic.position[nr] < symbolic.position[nc]) {
                    std::swap(r, c);
                    std::swap(nr, nc);
                }
                const factor::BlockTarget t =
                    symbolic.target(static_cast<std::int32_t>(nr), static_cast<std::int32_t>(nc));
                scatter.emplace_back(
                    t.address + (r - p.scalar[nr]) * t.step + (c - p.scalar[nc]) * t.ld,
                    it.value());
            }
    }
    void refactor_solve(const Problem& p, Vector& out) {
        numeric.clear(symbolic, serial);
        for (const auto& [address, value] : scatter) numeric.values()[address] = value;
        if (numeric.factor(symbolic, serial) != 0) throw std::runtime_error("wrong pivot");
        x.resize(static_cast<std::size_t>(symbolic.scalars) + 8);
        auto each = [&](auto&& f) {
            for (int a = 0; a < p.pattern.nodes(); ++a) {
                const auto n = static_cast<std::size_t>(a);
                for (int i = 0; i < p.pattern.size[n]; ++i)
                    f(x[static_cast<std::size_t>(symbolic.node_offset[n] + i)], p.scalar[n] + i);
            }
        };
        each([&](double& to, std::int32_t i) { to = p.rhs[i]; });
        numeric.solve(symbolic, x.data(), serial);
        out.resize(p.rhs.size());
        each([&](const double& from, std::int32_t i) { out[i] = from; });
    }
};

#if HAWSER_HAVE_CHOLMOD
/// CHOLMOD with AMD; simplicial LDLᵀ takes the quasi-definite matrix as it is.
struct Cholmod {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_sparse matrix{};
    explicit Cholmod(Problem& p) {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SIMPLICIAL;
        common.final_ll = 0;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        common.postorder = 1;
        p.lower.makeCompressed();
        matrix.nrow = matrix.ncol = static_cast<std::size_t>(p.lower.rows());
        matrix.nzmax = static_cast<std::size_t>(p.lower.nonZeros());
        matrix.p = p.lower.outerIndexPtr();
        matrix.i = p.lower.innerIndexPtr();
        matrix.x = p.lower.valuePtr();
        matrix.stype = -1;
        matrix.itype = CHOLMOD_INT;
        matrix.xtype = CHOLMOD_REAL;
        matrix.sorted = matrix.packed = 1;
    }
    ~Cholmod() {
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;
    void analyse() {
        cholmod_free_factor(&factor, &common);
        factor = cholmod_analyze(&matrix, &common);
    }
    void refactor_solve(Problem& p, Vector& out) {
        cholmod_factorize(&matrix, factor, &common);
        cholmod_dense b{};
        b.nrow = b.nzmax = b.d = static_cast<std::size_t>(p.rhs.size());
        b.ncol = 1;
        b.x = p.rhs.data();
        b.xtype = CHOLMOD_REAL;
        cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, &b, &common);
        out = Eigen::Map<Vector>(static_cast<double*>(x->x), p.rhs.size());
        cholmod_free_dense(&x, &common);
    }
};
#endif

nlohmann::json run_scale(const std::string& file, int scale, int rounds, Form form) {
    scene::Options options;
    options.scale = scale;
    options.form = form;
    scene::Scene scene = scene::load_file(file, options);
    const SystemView view = scene.world.inspect();
    Problem p = make_problem(view);
    Ours ours;
    Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> eigen;
    std::vector<Candidate> all(2);
    all[0].name = "hawser";
    all[0].analyse = [&] { ours.analyse(p); };
    all[0].refactor_solve = [&] { ours.refactor_solve(p, all[0].x); };
    all[1].name = "Eigen SimplicialLDLT";
    all[1].analyse = [&] { eigen.analyzePattern(p.lower); };
    all[1].refactor_solve = [&] {
        eigen.factorize(p.lower);
        all[1].x = eigen.solve(p.rhs);
    };
#if HAWSER_HAVE_CHOLMOD
    Cholmod cholmod(p);
    all.resize(3);
    all[2].name = "CHOLMOD simplicial";
    all[2].analyse = [&] { cholmod.analyse(); };
    all[2].refactor_solve = [&] { cholmod.refactor_solve(p, all[2].x); };
#endif
    for (Candidate& c : all) c.analyse();
    ours.map(p);
    for (int round = 0; round < rounds; ++round)
        for (Candidate& c : all) {
            if (round < 3 && c.name != "hawser") c.analyse_ms.push_back(1e3 * seconds(c.analyse));
            if (round < 3 && c.name == "hawser") {
                Ours fresh;  // the mapped one keeps its addresses
                c.analyse_ms.push_back(1e3 * seconds([&] { fresh.analyse(p); }));
            }
            c.work_ms.push_back(1e3 * seconds(c.refactor_solve));
        }
    fmt::print("scale {}: {} scalars, nnz {} (matrix), {} (our L), {:.2f} Mflop\n", scale,
               p.rhs.size(), view.matrix_nnz, ours.symbolic.factor_nnz,
               1e-6 * static_cast<double>(ours.symbolic.flops));
    fmt::print("  {:<22} {:>12} {:>18} {:>8} {:>12}\n", "solver", "analyse ms", "factor+solve ms",
               "ratio", "residual");
    nlohmann::json rows = nlohmann::json::array();
    const double base = median(all[0].work_ms);
    for (Candidate& c : all) {
        const Vector r = p.lower.selfadjointView<Eigen::Lower>() * c.x - p.rhs;
        const double residual = r.norm() / p.rhs.norm();
        fmt::print("  {:<22} {:>12.3f} {:>18.4f} {:>8.2f} {:>12.1e}\n", c.name,
                   median(c.analyse_ms), median(c.work_ms), median(c.work_ms) / base, residual);
        rows.push_back({{"solver", c.name},
                        {"analyse_ms", median(c.analyse_ms)},
                        {"factor_solve_ms", median(c.work_ms)},
                        {"ratio", median(c.work_ms) / base},
                        {"residual", residual}});
    }
    return {{"scale", scale}, {"scalars", p.rhs.size()}, {"solvers", rows}};
}

}  // namespace

int factor_command(int argc, char** argv) {
    CLI::App app(
        "Factor and solve the matrix of a scene: ours against libraries, one thread,\n"
        "alternated in one run. Values are scattered, factored and solved by everyone.",
        "hawser-bench factor");
    std::string file = "scenes/anchor_lines.json", json, form = "auto";
    std::vector<int> scales{1, 10, 100};
    int rounds = 15;
    app.add_option("SCENE", file, "Scene file")->capture_default_str();
    app.add_option("--scale", scales, "Copies of the site")->capture_default_str();
    app.add_option("--form", form, "auto, saddle or condensed")
        ->check(CLI::IsMember({"auto", "saddle", "condensed"}));
    app.add_option("--rounds", rounds, "Turns of each solver")->check(CLI::Range(3, 1000));
    app.add_option("--json", json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);
    const Form which = form == "saddle"      ? Form::saddle
                       : form == "condensed" ? Form::condensed
                                             : Form::automatic;
    fmt::print("{}, form {}, {}\n", file, form, instruction_set());
    nlohmann::json all = nlohmann::json::array();
    for (const int scale : scales)
        all.push_back(run_scale(file, scale, scale >= 100 ? std::min(rounds, 5) : rounds, which));
    if (!json.empty()) std::ofstream(json) << all.dump(2) << '\n';
    return 0;
}

}  // namespace hawser::bench
