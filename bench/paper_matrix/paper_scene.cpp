// SPDX-License-Identifier: Apache-2.0
// Topology: bodies, cables, contacts and their changes. Values are in paper_values.cpp.
#include "paper_matrix/dice.h"

#include "index.h"
#include "paper_matrix/paper_matrix.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser::bench {
namespace {

constexpr int kHulls = 3, kAttached = 20, kLocked = 4, kCables = 10, kMoorings = 4;
constexpr int kFirstElement = kHulls + kHulls * kAttached;
constexpr int kRig = 2;
constexpr double kSeparation = 3000.0;  ///< Distance of copies [m].

std::array<double, 3> hull_index(int copy, int hull) {
    constexpr std::array<std::array<double, 3>, 3> place{
        {{-420.0, 60.0, 0.0}, {410.0, -50.0, 0.0}, {0.0, 300.0, 0.0}}};
    std::array<double, 3> p = place[at(hull)];
    p[1] += kSeparation * copy;
    return p;
}

/// Contacts of cables on a hull: elements `first`, first + step, … of a cable.
struct DeckZone {
    int hull, cable;
    bool far_end;  ///< True if counted backwards from the last element.
    int count;
};
constexpr DeckZone kDeck[] = {
    {2, 0, false, 17}, {2, 1, false, 17}, {2, 2, false, 17}, {2, 3, false, 17}, {2, 4, false, 16},
    {2, 5, false, 16}, {0, 4, true, 24},  {0, 6, false, 24}, {0, 7, false, 24}, {0, 9, false, 23},
    {1, 5, true, 24},  {1, 6, true, 24},  {1, 8, false, 24}, {1, 9, true, 23}};

/// Pairs of cables side by side for 52 elements, from element 25 on. An element touches the other
/// cable up to 16 elements before or after. With this disorder the factors have the measured size
/// of the paper's scene: 62,000 entries lumped, 206,000 rigid.
constexpr std::array<std::array<int, 2>, 5> kSideBySide{{{0, 1}, {2, 3}, {4, 5}, {6, 9}, {7, 8}}};
constexpr int kSide = 52, kSideFrom = 25, kSlip = 16;

}  // namespace

PaperScene::PaperScene(const PaperOptions& options) : options_(options) {
    if (options.elements < 30 || options.scale < 1)
        throw std::invalid_argument("paper_matrix: at least 30 elements and one copy");
    for (int copy = 0; copy < options.scale; ++copy) {
        add_copy(copy);
        joint_end_.push_back(static_cast<int>(joints_.size()));
    }
    for (int copy = 0; copy < options.scale; ++copy) add_contacts(copy);
}

int PaperScene::elements_of(int cable) const noexcept {
    return options_.elements - (cable >= 7 ? 1 : 0);
}
int PaperScene::element(int copy, int cable, int index) const noexcept {
    return copy * per_copy() + kFirstElement + cable * options_.elements - std::max(0, cable - 7) +
           index;
}
int PaperScene::per_copy() const noexcept {
    return kFirstElement + kCables * options_.elements - 3;
}
bool PaperScene::wide(int body) const noexcept { return body % per_copy() < kFirstElement; }
int PaperScene::dof(int body) const noexcept {
    return wide(body) || options_.form == CableForm::rigid ? 6 : 3;
}

void PaperScene::add_copy(int copy) {
    const int base = copy * per_copy();
    Dice dice(options_.seed + 1000 * static_cast<std::uint64_t>(copy));
    for (int h = 0; h < kHulls; ++h) place_.push_back(hull_index(copy, h));
    for (int h = 0; h < kHulls; ++h)
        for (int i = 0; i < kAttached; ++i) {
            Vec p = hull_index(copy, h);
            p[0] += dice.uniform(-35.0, 35.0);
            p[1] += dice.uniform(-9.0, 9.0);
            p[2] += dice.uniform(5.0, 15.0);
            Joint j{i < kLocked ? Kind::lock : Kind::hinge, {}, p, {}};
            j.body = {base + h, base + static_cast<int>(place_.size()) % per_copy(), -1};
            j.axis = i % 2 == 0 ? Vec{0.0, 0.0, 1.0} : Vec{0.0, 1.0, 0.0};
            j.point[2] -= 2.0;
            place_.push_back(p);
            joints_.push_back(j);
            j.kind = Kind::motor;
            joints_.push_back(j);
        }
    along_.resize(place_.size(), Vec{});
    length_.resize(place_.size(), 0.0);
    const int a = 3, b = 3 + kAttached, rig = 3 + 2 * kAttached;  // first attached body of each
    const CableEnds ends[kCables] = {{kRig, -1},       {kRig, -1},    {kRig, -1}, {kRig, -1},
                                     {kRig, 0},        {kRig, 1},     {0, 1},     {a + 5, rig + 6},
                                     {b + 5, rig + 9}, {a + 8, b + 8}};
    for (int c = 0; c < kCables; ++c) add_cable(copy, c, ends[c]);
}

void PaperScene::add_cable(int copy, int cable, const CableEnds& ends) {
    const int n = elements_of(cable), base = copy * per_copy();
    const int from = base + ends.from;
    int to = ends.to < 0 ? -1 : base + ends.to;
    Vec start = place_[at(from)], stop{};
    if (to >= 0) {
        stop = place_[at(to)];
    } else {
        const double turn = 0.25 + 0.5 * cable;
        stop = {start[0] + 350.0 * std::cos(turn), start[1] + 350.0 * std::sin(turn), -100.0};
    }
    if (cable == 0 && copy + 1 < options_.scale) {  // joins this copy to the next one
        to = base + per_copy();
        stop = hull_index(copy + 1, 0);
    }
    auto point = [&](double t) {
        Vec p{};
        for (std::size_t k = 0; k < 3; ++k) p[k] = start[k] + t * (stop[k] - start[k]);
        p[2] -= 0.2 * 350.0 * t * (1.0 - t);
        return p;
    };
    for (int i = 0; i < n; ++i) {
        const Vec p = point((i + 0.5) / n), left = point(1.0 * i / n), right = point((i + 1.0) / n);
        Vec u{};
        double length = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            u[k] = right[k] - left[k];
            length += u[k] * u[k];
        }
        length = std::sqrt(length);
        for (double& x : u) x /= length;
        place_.push_back(p);
        along_.push_back(u);
        length_.push_back(length);
    }
    for (int i = 0; i <= n; ++i) {
        const int left = i == 0 ? from : element(copy, cable, i - 1);
        const int right = i == n ? to : element(copy, cable, i);
        const Kind kind = i == 0 || i == n ? Kind::end : Kind::link;
        joints_.push_back({kind,
                           {left, right, -1},
                           point(1.0 * i / n),
                           along_[at(element(copy, cable, std::min(i, n - 1)))]});
        if (i == n || (i == n - 1 && to < 0)) continue;
        const int next = i == n - 1 ? to : element(copy, cable, i + 1);
        joints_.push_back({Kind::bend,
                           {left, right, next},
                           point((i + 0.5) / n),
                           along_[at(element(copy, cable, i))]});
    }
}

void PaperScene::add_contacts(int copy) {
    using K = Contact::Kind;
    const int base = copy * per_copy();
    const std::size_t begin = contacts_.size();
    Dice dice(options_.seed + 41 + 1000 * static_cast<std::uint64_t>(copy));
    // Shorter cables keep all contacts; several are then on one element.
    auto add_element = [&](K kind, int cable, int index, int second) {
        contacts_.push_back({kind, element(copy, cable, index % elements_of(cable)), second});
    };
    for (const DeckZone& z : kDeck)
        for (int i = 0; i < z.count; ++i)
            add_element(K::hull_cable, z.cable, z.far_end ? elements_of(z.cable) - 4 - i : 3 + i,
                        base + z.hull);
    for (int h = 0; h < kHulls; ++h)  // 10 pairs of neighbours on deck
        for (int i = 0; i < (h == 0 ? 4 : 3); ++i) {
            const int first = base + kHulls + h * kAttached + 4 + 2 * i;
            contacts_.push_back({K::attached, first, first + 1});
        }
    for (const auto& pair : kSideBySide)
        for (int i = 0; i < kSide; ++i) {
            const int other =
                (kSideFrom + i + dice.below(2 * kSlip + 1) - kSlip) % elements_of(pair[1]);
            add_element(K::cables, pair[0], kSideFrom + i, element(copy, pair[1], other));
        }
    for (int i = 0; i < kHulls * kAttached; ++i)  // three points of each on its own hull
        for (int k = 0; k < 3; ++k)
            contacts_.push_back({K::hull_attached, base + kHulls + i, base + i / kAttached});
    for (int c = 0; c < kMoorings; ++c)
        for (int i = 0; i < 50; ++i)
            add_element(K::ground, c, elements_of(c) - 1 - i % elements_of(c), -1);
    for (std::size_t i = 0; i < 60; ++i)  // a second point of touching pairs
        contacts_.push_back(contacts_[begin + 4 * i]);
}

Contact PaperScene::moved(const Contact& c, Dice& dice) const {
    Contact next = c;
    if (c.kind == Contact::Kind::hull_attached || c.kind == Contact::Kind::attached) {
        // Another body of the same hull; hull_attached keeps the hull as second.
        const int base = c.first - c.first % per_copy();
        const int hull = (c.first - base - kHulls) / kAttached;
        const int first = base + kHulls + hull * kAttached;
        const int i = dice.below(kAttached);
        next.first = first + i;
        if (c.kind == Contact::Kind::attached) next.second = first + (i + 1) % kAttached;
        return next;
    }
    // Another element of the same cable, at most eight away.
    const int base = c.first - c.first % per_copy();
    int cable = 0;
    while (cable + 1 < kCables && element(base / per_copy(), cable + 1, 0) <= c.first) ++cable;
    const int begin = element(base / per_copy(), cable, 0), n = elements_of(cable);
    const int step = (1 + dice.below(8)) * (dice.below(2) == 0 ? 1 : -1);
    next.first = begin + (c.first - begin + step + n) % n;
    return next;
}

std::vector<int> PaperScene::change_contacts(int count, int step) {
    const int per = contacts_per_copy();
    if (count > per) throw std::invalid_argument("paper_matrix: more changes than contacts");
    std::vector<int> changed;
    for (int copy = 0; copy < options_.scale; ++copy) {
        Dice dice(options_.seed + 77 + 1000 * static_cast<std::uint64_t>(copy) +
                  1000003 * static_cast<std::uint64_t>(step));
        std::vector<char> taken(at(per), 0);
        for (int k = 0; k < count;) {
            const int i = dice.below(per);
            if (taken[at(i)]) continue;
            taken[at(i)] = 1;
            ++k;
        }
        for (int i = 0; i < per; ++i)
            if (taken[at(i)]) {
                Contact& c = contacts_[at(copy * per + i)];
                c = moved(c, dice);
                changed.push_back(copy * per + i);
            }
    }
    return changed;
}

}  // namespace hawser::bench
