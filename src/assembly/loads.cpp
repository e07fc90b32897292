// SPDX-License-Identifier: Apache-2.0
#include "assembly/loads.h"

#include "assembly/load_matrix.h"
#include "base/index.h"
#include "model/damping.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace hawser {

BodyLoad Loads::of(BodyId body) noexcept { return store_.of(body); }
void Loads::reserve(std::span<const BodyId> bodies) noexcept { store_.reserve(bodies); }
void Loads::repeat(bool repeatable) noexcept { store_.repeat(repeatable); }

void Loads::add_force(BodyId body, const Vec3& force, const Vec3& torque) noexcept {
    const BodyLoad load = of(body);
    for (int k = 0; k < load.freedom; ++k) load.force[k] += k < 3 ? force[k] : torque[k - 3];
}

namespace assembly {
namespace {

/// Return the number of doubles of an entry: f, A, D, K, B.
constexpr int size_of(int freedom) { return freedom + 4 * entries_of(freedom); }

bool all_finite(const double* v, int n) noexcept {
    for (int i = 0; i < n; ++i)
        if (!(std::fabs(v[i]) <= 1e300)) return false;
    return true;
}

/// Return the fraction θ of a damper (model::late_fraction(z)). Small z, as in most loads of nodes,
/// use a series without exponential and division. The first omitted term is below 1e-15.
double late_fraction_of(double z) noexcept {
    if (!(z > 0.0 && z < 0.3)) return model::late_fraction(z);
    const double s = z * z;
    const double high = 1.0 / 30240.0 - s * (1.0 / 1209600.0 - s * (1.0 / 47900160.0));
    return 0.5 + z * (1.0 / 12.0 - s * (1.0 / 720.0 - s * high));
}

bool any_of(const double* v, int n) noexcept {
    return std::any_of(v, v + n, [](double x) { return x != 0.0; });
}

/// Positions of the entries of a 3×3 matrix in the block of a body, ordered xx, xy, xz, yy, yz, zz.
constexpr int kInBlock[6] = {0, 1, 3, 2, 4, 5};

}  // namespace

void LoadStore::prepare(const model::Bodies& bodies) {
    const auto count = at(bodies.count());
    entry_of_.reserve(count);
    coupled_.reserve(count);
    freedom_.resize(count);
    generation_.resize(count);
    part_.resize(at(load_chunks(bodies.count())));
    // The following code does not throw.
    for (std::size_t b = 0; b < count; ++b) {
        const auto body = static_cast<std::int32_t>(b);
        generation_[b] = bodies.slots.holds(body) ? bodies.slots.generation(body) : -1;
        freedom_[b] = static_cast<std::uint8_t>(bodies.dof(static_cast<int>(b)));
    }
    entry_of_.resize(count, -1);
    coupled_.resize(count, -1);
    if (std::all_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
            return at(e.body) < count && freedom_[at(e.body)] == e.freedom;
        }))
        return;
    // Some slots contain other bodies now.
    std::fill(entry_of_.begin(), entry_of_.end(), -1);
    std::fill(coupled_.begin(), coupled_.end(), -1);
    entries_.clear();
    used_.clear();
    late_.clear();
    sources_.clear();
    last_water_.clear();
    shared_of_.clear();
    shared_.clear();
    repeatable_.clear();
    data_.clear();
    coupled_count_ = 0;
    any_ = false;
}

void LoadStore::clear() noexcept {
    const bool dirty = any_ || touched();
    out_of_memory_ = false;
    unreserved_.store(false, std::memory_order_relaxed);
    no_body_.store(false, std::memory_order_relaxed);
    touched_.store(false, std::memory_order_relaxed);
    repeat_now_ = repeats_ = false;
    altered_.clear();
    accept();
    if (!dirty) return;
    for (std::size_t e = 0; e < entries_.size(); ++e) {
        if (used_[e] == 0) continue;
        const Entry& entry = entries_[e];
        std::fill_n(&data_[at(entry.place)], size_of(entry.freedom), 0.0);
        used_[e] = 0;
        sources_[e] = kNobody;
        coupled_[at(entry.body)] = -1;
    }
    coupled_count_ = 0;
    any_ = false;
}

BodyLoad LoadStore::at_slot(std::int32_t place, int freedom) noexcept {
    double* f = &data_[at(place)];
    const int n = entries_of(freedom);
    double* a = f + freedom;
    return {freedom, f, a, a + n, a + 2 * n};
}

bool LoadStore::add_entry(std::int32_t body, int freedom) noexcept {
    try {
        base::reserve_more(entries_, 1);
        base::reserve_more(used_, 1);
        base::reserve_more(late_, 1);
        base::reserve_more(sources_, 1);
        base::reserve_more(last_water_, 1);
        base::reserve_more(shared_of_, 1);
        base::reserve_more(repeatable_, 1);
        base::reserve_more(data_, at(size_of(freedom)));
        base::reserve_more(woken_, entries_.size() + 1);
        base::reserve_more(woken_quiet_, entries_.size() + 1);
        fault_.reserve(at(load_chunks(static_cast<int>(entries_.capacity()))));
    } catch (const std::bad_alloc&) {
        out_of_memory_ = true;
        return false;
    }
    entry_of_[at(body)] = static_cast<std::int32_t>(entries_.size());
    entries_.push_back({body, static_cast<std::int32_t>(data_.size()), freedom});
    used_.push_back(0);
    late_.push_back(0.5);
    sources_.push_back(kNobody);
    last_water_.push_back(0);
    shared_of_.push_back(-1);
    repeatable_.push_back(0);
    data_.resize(data_.size() + at(size_of(freedom)), 0.0);
    return true;
}

BodyLoad LoadStore::of(BodyId id) noexcept {
    const std::int32_t body = id.index;
    const int n = entries_of(6);
    const BodyLoad nowhere{0, scratch_, scratch_ + 6, scratch_ + 6 + n, scratch_ + 6 + 2 * n};
    touched_.store(true, std::memory_order_relaxed);
    if (!there(id)) {
        no_body_.store(true, std::memory_order_relaxed);
        return nowhere;
    }
    const int freedom = freedom_[at(body)];
    if (freedom == 0) return nowhere;
    if (entry_of_[at(body)] < 0) {
        if (parallel_) unreserved_.store(true, std::memory_order_relaxed);
        if (parallel_ || !add_entry(body, freedom)) return nowhere;
    }
    const auto e = at(entry_of_[at(body)]);
    if (used_[e] != system_) {
        if (needs_shared(e)) {
            if (parallel_) unreserved_.store(true, std::memory_order_relaxed);
            if (parallel_ || !make_shared(e)) return nowhere;
        }
        note_source(e);
        if (used_[e] == 0) repeatable_[e] = 1;
        used_[e] = system_;
    }
    if (!repeat_now_) repeatable_[e] = 0;
    return at_slot(entries_[e].place, freedom);
}

void LoadStore::alter(std::int32_t body) noexcept {
    // Before the repeatable loads, they see the change. Only nodes have such loads.
    if (!repeats_ || at(body) >= freedom_.size() || freedom_[at(body)] != 3) return;
    try {
        altered_.push_back(body);
    } catch (const std::bad_alloc&) {
        out_of_memory_ = true;
    }
}

void LoadStore::reserve(std::span<const BodyId> bodies) noexcept {
    for (const BodyId id : bodies) {
        if (!there(id) || freedom_[at(id.index)] == 0) continue;
        const std::int32_t e = entry_of_[at(id.index)];
        if (e < 0 && !add_entry(id.index, freedom_[at(id.index)])) return;
        if (e >= 0 && needs_shared(at(e)) && !make_shared(at(e))) return;
    }
}

BadLoad LoadStore::fault(base::Executor& executor) noexcept {
    BadLoad bad;
    if (no_body_.load(std::memory_order_relaxed)) {
        bad.reason = "there is no such body";
        return bad;
    }
    if (unreserved_.load(std::memory_order_relaxed)) {
        bad.reason = "threads load a body that Loads::reserve() has not named";
        return bad;
    }
    any_ = true;
    const auto count = static_cast<std::int32_t>(entries_.size());
    fault_.assign(at(load_chunks(count)), -1);  // reserved with the entries
    const auto wrong = [&](const Entry& e) -> const char* {
        const int n = entries_of(e.freedom);
        const double* f = &data_[at(e.place)];
        if (!all_finite(f, e.freedom + 3 * n)) return "it is not finite";
        static constexpr const char* kNames[] = {
            "its added mass is not positive semi-definite",
            "its damping is not positive semi-definite",
            "its stiffness is not positive semi-definite",
        };
        for (int k = 0; k < 3; ++k)
            if (!semidefinite(f + e.freedom + k * n, e.freedom)) return kNames[k];
        return nullptr;
    };
    over_loads(executor, count, [&](std::int32_t a, std::int32_t b) {
        std::int32_t& first = fault_[at(a / kLoadChunk)];
        for (std::int32_t e = a; e < b; ++e) {
            if (used_[at(e)] != system_ || wrong(entries_[at(e)]) == nullptr) continue;
            if (first < 0 || entries_[at(e)].body < entries_[at(first)].body) first = e;
        }
    });
    std::int32_t worst = -1;
    for (const std::int32_t e : fault_)
        if (e >= 0 && (worst < 0 || entries_[at(e)].body < entries_[at(worst)].body)) worst = e;
    if (worst < 0) return bad;
    bad.body = id_of(at(entries_[at(worst)].body));
    bad.reason = wrong(entries_[at(worst)]);
    return bad;
}

void LoadStore::finish(model::Bodies& bodies, double h, base::Executor& executor) noexcept {
    over_loads(executor, static_cast<std::int32_t>(entries_.size()),
               [&](std::int32_t begin, std::int32_t end) {
                   for (std::int32_t e = begin; e < end; ++e) {
                       if (used_[at(e)] == 0) continue;
                       const Entry& entry = entries_[at(e)];
                       const int n = entry.freedom, size = entries_of(n);
                       double* a = &data_[at(entry.place + n)];
                       const double *d = a + size, *k = d + size;
                       double* block = a + 3 * size;
                       double whole[21], fast[21];
                       late_[at(e)] = 0.5;
                       finish_water(at(e));
                       if (any_of(d, size)) {
                           mass_matrix(bodies, entry.body, n, whole);
                           for (int i = 0; i < size; ++i) {
                               whole[i] += a[i];
                               fast[i] = h * d[i] + 0.25 * h * h * k[i];
                           }
                           late_[at(e)] = late_fraction_of(trace_over(whole, fast, n));
                       }
                       for (int i = 0; i < size; ++i)
                           block[i] = a[i] + h * late_[at(e)] * d[i] + 0.25 * h * h * k[i];
                   }
               });
    for (std::size_t e = 0; e < entries_.size(); ++e) {
        if (used_[e] == 0) continue;
        const std::int32_t body = entries_[e].body;
        if (bodies.asleep[at(body)] != 0) {
            woken_.push_back(body);
            woken_quiet_.push_back(bodies.quiet[at(body)]);
            bodies.quiet[at(body)] = 0;
        }
        if (entries_[e].freedom < 6) continue;
        const std::int32_t place = entries_[e].place + 6 + 3 * entries_of(6);
        const double* block = &data_[at(place)];
        bool couples = false;
        for (int i = 3; i < 6; ++i) couples = couples || any_of(block + triangle(i, 0), 3);
        if (!couples) continue;
        coupled_[at(body)] = place;
        ++coupled_count_;
    }
}

void LoadStore::show(assembly::View& view) const noexcept {
    if (coupled_count_ == 0) return;
    view.coupled = coupled_.data();
    view.coupling = data_.data();
}

bool LoadStore::terms_of(std::int32_t body, double h, const double* v, double* impulse,
                         const double** block) const noexcept {
    if (!loaded(body)) return false;
    const auto e = at(entry_of_[at(body)]);
    const int n = entries_[e].freedom, size = entries_of(n);
    const double* f = &data_[at(entries_[e].place)];
    const double *a = f + n, *d = a + size, *k = d + size;
    for (int i = 0; i < n; ++i) impulse[i] = h * f[i];
    double now[21];
    for (int i = 0; i < size; ++i)
        now[i] = a[i] + 0.25 * h * h * k[i] - h * (1.0 - late_[e]) * d[i];
    add_product(now, n, 1.0, v, impulse);
    *block = k + size;
    return true;
}

void LoadStore::add_terms(const assembly::View& view, std::int32_t begin,
                          std::int32_t end) const noexcept {
    if (!any_) return;
    for (std::int32_t body = begin; body < end; ++body) {
        const int n = view.dof[body];
        if (n == 0 || at(body) >= entry_of_.size()) continue;
        const std::int32_t first = view.dof_begin[body];
        double impulse[6];
        const double* b = nullptr;
        if (!terms_of(body, view.h, view.v + first, impulse, &b)) continue;
        double* own = view.body_block + assembly::block_offset(first);
        for (int i = 0; i < n; ++i) view.a[first + i] += impulse[i];
        for (int part = 0; part < n; part += 3)
            for (int i = 0, k = 0; i < std::min(n, 3); ++i)
                for (int j = 0; j <= i; ++j, ++k)
                    own[2 * part + kInBlock[k]] += b[triangle(part + i, part + j)];
    }
}

void LoadStore::push(const model::Bodies& bodies, std::int32_t body, double h, const double* p,
                     double* v) const noexcept {
    const Entry& e = entries_[at(entry_of_[at(body)])];
    const int n = e.freedom, size = entries_of(n);
    const double* f = &data_[at(e.place)];
    const double *d = f + n + size, *block = f + n + 3 * size;
    double whole[21], x[6];
    mass_matrix(bodies, body, n, whole);
    for (int i = 0; i < size; ++i) whole[i] += block[i];
    for (int i = 0; i < n; ++i) x[i] = p[i] + h * f[i];
    add_product(d, n, -h, v, x);
    factor_triangle(whole, n);
    solve_triangle(whole, n, x);
    for (int i = 0; i < n; ++i) v[i] += x[i];
}

void LoadStore::copy_entry(const LoadStore& from, std::int32_t its, std::int32_t mine) noexcept {
    if (!from.loaded(its)) return;
    const BodyLoad to = of(id_of(at(mine)));
    if (to.freedom == 0) return;
    any_ = true;
    const Entry& entry = from.entries_[at(from.entry_of_[at(its)])];
    std::copy_n(&from.data_[at(entry.place)], entry.freedom + 3 * entries_of(entry.freedom),
                to.force);
}

std::vector<LoadView> LoadStore::view() const {
    std::vector<LoadView> out;
    if (!any_) return out;
    for (std::size_t b = 0; b < entry_of_.size(); ++b) {
        if (used(entry_of_[b])) out.push_back(view_of(b));
    }
    return out;
}

LoadView LoadStore::view_of(std::size_t body) const {
    const auto e = at(entry_of_[body]);
    const auto n = at(entries_[e].freedom), size = at(entries_of(entries_[e].freedom));
    const double *f = &data_[at(entries_[e].place)], *a = f + n;
    LoadView out{id_of(body), {f, n}, {a, size}, {a + size, size}, {a + 2 * size, size}, late_[e]};
    if (const double* part = water_of(e); part != nullptr) out.water = {part, n + 3 * size};
    return out;
}

LoadRecord LoadStore::record() const {
    LoadRecord out;
    out.repeats = repeats_;
    std::vector<bool> altered(entry_of_.size());
    for (const std::int32_t body : altered_) altered[at(body)] = true;
    for (std::size_t b = 0; b < entry_of_.size(); ++b) {
        const bool loaded = any_ && used(entry_of_[b]);
        if (loaded && (altered[b] || repeatable_[at(entry_of_[b])] == 0))
            out.loads.push_back(view_of(b));
        else if (!loaded && altered[b])
            out.loads.emplace_back().body = id_of(b);
    }
    return out;
}

std::size_t LoadStore::bytes() const noexcept {
    return base::bytes(entry_of_) + base::bytes(freedom_) + base::bytes(coupled_) +
           base::bytes(entries_) + base::bytes(used_) + base::bytes(late_) + base::bytes(data_) +
           base::bytes(shared_) + base::bytes(repeatable_) + base::bytes(altered_);
}

void LoadStore::accept() noexcept {
    measured_ = false;
    change_ = 0.0;
    woken_.clear();
    woken_quiet_.clear();
}

void LoadStore::take_back(model::Bodies& bodies) noexcept {
    for (std::size_t i = 0; i < woken_.size(); ++i) bodies.quiet[at(woken_[i])] = woken_quiet_[i];
    accept();
}

}  // namespace assembly
}  // namespace hawser
