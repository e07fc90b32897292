// SPDX-License-Identifier: Apache-2.0
/// Energy that rows absorb in a step, eight rows at a time; formulas in solve/losses.cpp.
#include "assembly/isa/rows.h"
#include "base/lanes.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::View;

constexpr double kElastic = 1e-11;  // model::kElasticCompliance

/// Return the compliance up to which a row counts as rigid. Rows with a larger one store energy, as
/// in model::holds_energy().
inline double rigid_up_to(const View& view, std::int32_t id) {
    return view.rest_length[id] > 0.0 ? 0.0 : kElastic;
}

// Values of model::InteractionFlag and RowFlag.
constexpr int kPullsOnly = 1, kRange = 2, kByInput = 16, kCarried = 32, kFriction = 128;
constexpr int kVelocityRow = 1, kTurns = 16, kSecant = 64;
/// Values as in model::half_step_gap().
constexpr double kMaxTurn = 2.0, kUnbounded = 1e300;

/// Properties of the rows of consecutive interactions: counted, tension only, completed. Also the
/// compliance above which they store energy, and the largest possible violation of a difference of
/// directions.
struct Marks {
    static constexpr int kRoom = assembly::kLossChunk * kMaxInteractionRows + kLanes;
    double counts[kRoom], pulls[kRoom], rigid[kRoom], completed[kRoom], most[kRoom];

    /// Set the properties of eight rows from one on. The rows of the next interaction overwrite the
    /// surplus.
    HAWSER_INLINE void set(int row, double count, double pull, double least, double complete,
                           double largest) {
        const V8 none{};
        store(counts + row, none + count);
        store(pulls + row, none + pull);
        store(rigid + row, none + least);
        store(completed + row, none + complete);
        store(most + row, none + largest);
    }
};

bool any_faded(const View& view, std::int32_t first, std::int32_t rows) {
    const V8 none{};
    V8 faded = none;
    for (int i = 0; i < rows; i += kLanes) {
        const int n = rows - i < kLanes ? rows - i : kLanes;
        const V8 recall = load_first(view.recall + first + i, n);
        const V8 size = select_greater(recall, none, recall, -recall);
        const V8 less = select_greater(none + assembly::kMinRecall, size, none + 1.0, none);
        faded += n == kLanes ? less : first_lanes(less, n);
    }
    return any(faded);
}

int any_bits(const std::uint8_t* some, std::int32_t count) {
    int bits = 0;
    for (std::int32_t i = 0; i < count; ++i) bits |= some[i];
    return bits;
}

/// True if all interactions are two-sided joints without drives and without rows of direction
/// differences, and none is completed. Such rows need no flags.
bool all_plain(const View& view, std::int32_t begin, std::int32_t end, std::int32_t first,
               std::int32_t rows) {
    const std::int32_t n = end - begin;
    constexpr int kMarked = kPullsOnly | kRange | kByInput | kCarried | kFriction;
    if ((any_bits(view.flags + begin, n) & kMarked) || any_bits(view.parted + begin, n) ||
        any_bits(view.completed + begin, n) ||
        (any_bits(view.row_flags + first, rows) & (kVelocityRow | kTurns | kSecant)))
        return false;
    int marked = 0;
    for (std::int32_t id = begin; id < end; ++id)
        marked |=
            static_cast<int>(view.active[id] == 0.0) | static_cast<int>(view.rest_length[id] > 0.0);
    return marked == 0;
}

/// Set the properties of rows of interactions [begin, end). @param faded  True if rows may have a
/// small recall. @param left  Output: interactions left to the caller. @return their number.
int mark(const View& view, std::int32_t begin, std::int32_t end, std::int32_t first, bool faded,
         Marks& marks, std::int32_t* left) {
    int count = 0;
    for (std::int32_t id = begin; id < end; ++id) {
        const int flags = view.flags[id], row = view.row_begin[id], rows = view.rows[id];
        const bool inactive = view.active[id] == 0.0, pulls = (flags & kPullsOnly) != 0;
        const bool none = (flags & kFriction) || view.parted[id] || (inactive && !pulls);
        bool own = none || inactive || (flags & (kCarried | kRange));
        int any_of = 0, all_of = 0xff;
        for (int r = row; r < row + rows; ++r) {
            any_of |= view.row_flags[r];
            all_of &= view.row_flags[r];
            if (faded) own |= __builtin_fabs(view.recall[r]) < assembly::kMinRecall;
        }
        own |= (any_of & kSecant) != 0;
        if (own && !none) left[count++] = id;
        const double rigid = rigid_up_to(view, id);
        marks.set(row - first, own ? 0.0 : 1.0, pulls ? 1.0 : 0.0, rigid, view.completed[id],
                  all_of & kTurns ? kMaxTurn : kUnbounded);
        if (any_of == all_of && !(any_of & kVelocityRow) && !(flags & kByInput)) continue;
        for (int r = row; r < row + rows; ++r) {
            const bool driven = (view.row_flags[r] & kVelocityRow) ||
                                ((flags & kByInput) && !(view.epsilon[r] > rigid));
            if (driven) marks.counts[r - first] = 0.0;
            marks.most[r - first] = view.row_flags[r] & kTurns ? kMaxTurn : kUnbounded;
        }
    }
    return count;
}

/// Limit a to [−most, most].
inline V8 within(const V8& a, const V8& most) {
    const V8 below = select_greater(a, most, most, a);
    return select_greater(-most, below, -most, below);
}

/// Add the losses of `rows` rows from `first` on. @param marks  Unused for kPlain rows. Otherwise
/// `pulls` is set to 1 for lines that were slack and to 0 for the others. @return true if there are
/// such lines.
template <bool kPlain>
HAWSER_INLINE bool add_losses(const View& view, std::int32_t first, std::int32_t rows, Marks* marks,
                              V8& taken) {
    const V8 none{}, half = none + 0.5 * view.h, per_h4 = none + 4.0 / view.h;
    bool was_slack = false;
    for (int i = 0; i < rows; i += kLanes) {
        const int n = rows - i < kLanes ? rows - i : kLanes;
        auto of = [&](const double* array) { return load_first(array + first + i, n); };
        const V8 g = of(view.g), c = of(view.c), epsilon = of(view.epsilon);
        const V8 lambda = of(view.lambda);
        V8 before = (c * (1.0 / of(view.upsilon)) + per_h4 * g) * (1.0 / of(view.recall));
        const V8 after = c - of(view.sigma) * lambda - of(view.residual);
        V8 old, now, rigid = none + kElastic, used{};
        if constexpr (kPlain) {
            old = g - half * before;
            now = g + half * after;
            used = first_lanes(none + 1.0, n);
        } else {
            // c of a completed row does not follow from its earlier speed.
            const V8 completed = load(marks->completed + i);
            if (any(completed)) before = select_greater(completed, none, of(view.rate), before);
            const V8 most = load(marks->most + i), pulls = load(marks->pulls + i);
            old = within(g - half * before, most);
            now = within(g + half * after, most);
            // A line that was slack at the last half step has a modified c (when_slack()).
            const V8 size = select_greater(g, none, g, -g);
            const V8 slack = select_greater(old, 1e-9 * size, none, pulls);
            used = load(marks->counts + i) * (none + 1.0 - slack);
            was_slack |= any(slack);
            store(marks->pulls + i, slack);
            old = select_greater(pulls, none, positive_part(old), old);
            now = select_greater(pulls, none, positive_part(now), now);
            rigid = load(marks->rigid + i);
        }
        const V8 stiffness = select_greater(epsilon, rigid, 0.5 / epsilon, none);
        const V8 loss = stiffness * (old * old - now * now) - 0.5 * (lambda * (before + after));
        taken += select_greater(used, none, loss, none);
    }
    return was_slack;
}

}  // namespace

double row_losses(const View& view, std::int32_t begin, std::int32_t end, std::int32_t* left,
                  int* left_count) noexcept {
    const std::int32_t first = view.row_begin[begin];
    const std::int32_t rows = view.row_begin[end - 1] + view.rows[end - 1] - first;
    const bool faded = any_faded(view, first, rows);
    V8 loss_sums{};
    *left_count = 0;
    if (!faded && all_plain(view, begin, end, first, rows)) {
        (void)add_losses<true>(view, first, rows, nullptr, loss_sums);
        return sum(loss_sums);
    }
    Marks marks;
    *left_count = mark(view, begin, end, first, faded, marks, left);
    marks.set(rows, 0.0, 0.0, 0.0, 0.0, 0.0);
    if (add_losses<false>(view, first, rows, &marks, loss_sums)) {
        for (std::int32_t id = begin; id < end; ++id) {
            const std::int32_t row = view.row_begin[id] - first;
            if (view.rows[id] > 0 && marks.counts[row] != 0.0 && marks.pulls[row] != 0.0)
                left[(*left_count)++] = id;
        }
    }
    return sum(loss_sums);
}

}  // namespace hawser::HAWSER_ISA
