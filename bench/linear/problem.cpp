// SPDX-License-Identifier: Apache-2.0
#include "linear/problem.h"

#include "index.h"

#include <hawser/inspect.h>
#include <hawser/scene.h>
#include <hawser/world.h>

#include "paper_matrix/dice.h"
#include "paper_matrix/matrix_market.h"
#include "paper_matrix/structures.h"

#include <filesystem>

namespace hawser::bench {
Problem::Problem(BlockSystem system_) : system(std::move(system_)) {
    system.rhs.reserve(system.rhs.size() + 8);  // vector loads read past the end
    for (const bool condensed : {false, true}) {
        form[condensed] = make_form(system, condensed);
        matrix[condensed] = std::make_unique<ScalarMatrix>(system, form[condensed]);
    }
    inverse.assign(at(system.scalars()) + 8, 0.0);
}

BlockSystem ProblemSource::system() const {
    BlockSystem s = paper                                       ? PaperScene(*paper).system()
                    : make                                      ? make(scale)
                    : !blocks.empty() || file.ends_with(".mtx") ? read_matrix_market(file, blocks)
                                                                : scene_system(file, scale);
    s.name = name;
    return s;
}

std::vector<ProblemSource> standard_problems(const std::vector<int>& scales,
                                             const std::string& scene) {
    std::vector<ProblemSource> all;
    auto named = [](const std::string& name, int scale) {
        return scale == 1 ? name : name + " x" + std::to_string(scale);
    };
    for (const int scale : scales)
        for (const CableForm form : {CableForm::lumped, CableForm::rigid}) {
            ProblemSource p{
                named(form == CableForm::lumped ? "paper lumped" : "paper rigid", scale)};
            p.paper = PaperOptions{};
            p.paper->form = form;
            p.paper->scale = p.scale = scale;
            all.push_back(p);
        }
    for (const int scale : scales) {
        ProblemSource p{named(std::filesystem::path(scene).stem().string(), scale)};
        p.scale = scale;
        p.file = scene;
        all.push_back(p);
    }
    all.push_back({"chain of 100,000", [](int) { return chain(100'000); }});
    all.push_back({"tree of 511 chains", [](int) { return tree_of_chains(9, 40); }});
    all.push_back({"net 50 x 50", [](int) { return net(50); }});
    all.push_back({"solid 18 x 18 x 18", [](int) { return solid(18); }});
    all.back().named_only = true;
    all.push_back({"1,076,748 links", [](int) { return moored_floats(1'076'748, 108, 9); }});
    return all;
}

BlockSystem scene_system(const std::string& file, int scale) {
    scene::Options options;
    options.scale = scale;
    options.form = hawser::Form::saddle;
    const scene::Scene scene = scene::load_file(file, options);
    const SystemView view = scene.world.solver().matrix();
    // Bodies first: a row of G is then stored contiguously.
    std::vector<int> node(view.nodes.size());
    SystemBuilder builder;
    Dice dice(21);
    for (const bool bodies : {true, false})
        for (std::size_t a = 0; a < view.nodes.size(); ++a) {
            if (view.nodes[a].body.valid() != bodies) continue;
            const int n = view.nodes[a].size;
            if (!bodies) {
                node[a] = builder.add_rows(std::vector<double>(at(n), 1e-6));
                continue;
            }
            std::vector<double> block(at(n) * at(n));
            for (int i = 0; i < n; ++i)
                for (int j = 0; j <= i; ++j)
                    block[at(i * n + j)] = block[at(j * n + i)] =
                        i == j ? dice.uniform(500.0, 1500.0) : dice.uniform(-20.0, 20.0);
            node[a] = builder.add_body(n, block);
        }
    for (std::size_t a = 0; a < view.nodes.size(); ++a)
        for (std::int32_t k = view.edge_start[a]; k < view.edge_start[a + 1]; ++k) {
            const auto b = at(view.edges[at(k)]);
            if (node[b] > node[a]) continue;
            const bool both = view.nodes[a].body.valid();  // then b, the lower one, is a body too
            // Bodies: all couplings of a row sum to less than half the least mass.
            const auto degree = std::max(view.edge_start[a + 1] - view.edge_start[a],
                                         view.edge_start[b + 1] - view.edge_start[b]);
            const double size = both ? 40.0 / degree : 1.0;
            std::vector<double> block(at(view.nodes[a].size) * at(view.nodes[b].size));
            for (double& v : block) v = dice.uniform(-size, size);
            builder.add_block(node[a], node[b], block);
        }
    return builder.finish("scene", 21);
}

}  // namespace hawser::bench
