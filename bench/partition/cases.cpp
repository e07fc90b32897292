// SPDX-License-Identifier: Apache-2.0
#include "partition/cases.h"

#include "graph/islands.h"
#include "index.h"
#include "paper_matrix/dice.h"
#include "paper_matrix/paper_matrix.h"

#include <utility>

namespace hawser::bench {

void PartCase::finish() {
    std::vector<std::int32_t> from, to;
    for (std::size_t e = 0; e + 1 < begin.size(); ++e)
        for (std::int32_t i = begin[e]; i < begin[e + 1]; ++i)
            for (std::int32_t j = begin[e]; j < i; ++j) {
                from.push_back(members[at(i)]);
                to.push_back(members[at(j)]);
            }
    std::vector<std::int8_t> sizes(size.begin(), size.end()), signs(size.size(), 1);
    pattern = factor::make_pattern(std::move(sizes), std::move(signs), from, to);
}

PartCase make_case(const BlockSystem& system) {
    PartCase c;
    c.name = system.name;
    const factor::Pattern& p = system.pattern;
    std::vector<std::int32_t> body(at(p.nodes()), -1);
    for (int v = 0; v < p.nodes(); ++v)
        if (p.sign[at(v)] > 0) {
            body[at(v)] = c.bodies();
            c.size.push_back(static_cast<std::uint8_t>(p.size[at(v)]));
        }
    for (int v = 0; v < p.nodes(); ++v) {
        std::vector<int> nodes;
        for (const std::int32_t u : p.neighbours(v)) {
            if (p.sign[at(u)] < 0) continue;
            if (p.sign[at(v)] > 0 && u < v) c.edge({body[at(u)], body[at(v)]});
            if (p.sign[at(v)] < 0) nodes.push_back(body[at(u)]);
        }
        if (p.sign[at(v)] < 0) c.edge(nodes);
    }
    c.finish();
    return c;
}

PartCase paper_case(bool rigid, int scale, int elements, std::uint64_t seed) {
    PaperOptions options;
    options.form = rigid ? CableForm::rigid : CableForm::lumped;
    options.scale = scale;
    options.elements = elements;
    options.seed = seed;
    PaperScene scene(options);
    PartCase c = make_case(scene.system());
    c.name = std::string(rigid ? "paper rigid" : "paper lumped") +
             (scale == 1 ? "" : " x" + std::to_string(scale));
    // Bodies are first and keep their numbers; the edge of node n is n − bodies.
    const int joints = scene.contact_node(0) - scene.bodies();
    const auto count = static_cast<int>(scene.contacts().size());
    (void)joints;
    for (int i = 0; i < count; ++i) c.contacts.push_back(scene.contact_node(i) - scene.bodies());
    if (scale > 1) return c;  // contacts change in every copy then
    for (const int i : scene.change_contacts(20, 1)) {
        c.edited.push_back(scene.contact_node(i) - scene.bodies());
        c.edited_to.push_back(scene.contacts()[at(i)].first);
        c.edited_to.push_back(scene.contacts()[at(i)].second);
    }
    return c;
}

PartCase random_case(int bodies, std::uint64_t seed) {
    PartCase c;
    c.name = "random " + std::to_string(bodies);
    Dice dice(seed);
    for (int b = 0; b < bodies; ++b) c.size.push_back(dice.below(4) == 0 ? 6 : 3);
    // A tree first, for one island; then edges between near numbers, like those of contacts, and a
    // few between any.
    for (int b = 1; b < bodies; ++b) c.edge({b - 1 - dice.below(std::min(b, 8)), b});
    for (int e = 0; e < 2 * bodies; ++e) {
        const int a = dice.below(bodies), reach = dice.below(50) == 0 ? bodies : 20;
        const int b = (a + 1 + dice.below(std::min(reach, bodies - 1))) % bodies;
        if (dice.below(3) == 0)
            c.edge({a, b, (b + 1) % bodies});
        else
            c.edge({a, b});
    }
    c.finish();
    return c;
}

PartCase star_case(int wires, int length, std::uint64_t seed) {
    PartCase c;
    c.name = "star of " + std::to_string(wires) + " x " + std::to_string(length);
    Dice dice(seed);
    c.size.push_back(6);
    for (int w = 0; w < wires; ++w) {
        int a = -1, b = 0;
        for (int i = 0; i < length; ++i) {
            const int v = c.bodies();
            c.size.push_back(3);
            c.edge({b, v});
            if (a >= 0) c.edge({a, b, v});
            if (dice.below(5) == 0) c.edge({0, v});
            a = b;
            b = v;
        }
    }
    c.finish();
    return c;
}

std::vector<PartCase> islands_of(const PartCase& all) {
    const std::vector<std::uint8_t> include(all.size.size(), 1);
    const graph::Islands islands = graph::find_islands(include, all.begin, all.members);
    std::vector<PartCase> result(at(islands.count));
    std::vector<std::int32_t> index(all.size.size());
    for (std::size_t b = 0; b < all.size.size(); ++b) {
        PartCase& c = result[at(islands.label[b])];
        index[b] = c.bodies();
        c.size.push_back(all.size[b]);
    }
    for (std::size_t e = 0; e + 1 < all.begin.size(); ++e) {
        std::vector<int> nodes;
        for (std::int32_t k = all.begin[e]; k < all.begin[e + 1]; ++k)
            nodes.push_back(index[at(all.members[at(k)])]);
        if (!nodes.empty())
            result[at(islands.label[at(all.members[at(all.begin[e])])])].edge(nodes);
    }
    for (PartCase& c : result) {
        c.name = all.name;
        c.finish();
    }
    return result;
}

}  // namespace hawser::bench
