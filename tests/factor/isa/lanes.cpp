// SPDX-License-Identifier: Apache-2.0
/// Functions that move or add lanes, against loops over entries. Entries are small integers, so
/// that every sum is exact and results are compared bit for bit.
#include "factor/isa/lanes.h"

#include "base/lanes.h"
#include "base/transpose.h"

namespace hawser::HAWSER_ISA {
namespace {

constexpr int kSize = 80;
constexpr double kOutside = -1000.0;  // no function may touch it

struct Numbers {
    double at[kSize];
    explicit Numbers(double first) {
        for (int i = 0; i < kSize; ++i) at[i] = first + 3.0 * i;
    }
};

bool equal(const V8& v, const double (&want)[kLanes]) {
    for (int i = 0; i < kLanes; ++i)
        if (lane(v, i) != want[i]) return false;
    return true;
}

bool transposes() {
    const Numbers x(1.0);
    V8 v[kLanes];
    for (int i = 0; i < kLanes; ++i) v[i] = load(x.at + kLanes * i);
    transpose(v);
    bool good = true;
    for (int i = 0; i < kLanes; ++i)
        for (int j = 0; j < kLanes; ++j) good &= lane(v[i], j) == x.at[kLanes * j + i];
    return good;
}

template <int N>
bool strides() {
    const Numbers x(2.0);
    V8 v[N];
    load_every<N>(x.at, v);
    bool good = true;
    for (int k = 0; k < N; ++k)
        for (int l = 0; l < kLanes; ++l) good &= lane(v[k], l) == x.at[N * l + k];
    double back[N * kLanes + 1] = {};
    back[N * kLanes] = kOutside;
    store_every<N>(back, v);
    for (int i = 0; i < N * kLanes; ++i) good &= back[i] == x.at[i];
    return good && back[N * kLanes] == kOutside;
}

bool shifts() {
    const Numbers x(5.0);
    double want[kLanes];
    for (int i = 0; i < kLanes; ++i) want[i] = i + 1 < kLanes ? x.at[i + 1] : 77.0;
    return equal(shift_in(load(x.at), 77.0), want);
}

template <int N>
bool sums_of() {
    const Numbers x(3.0);
    V8 v[N];
    double want[kLanes] = {};
    for (int i = 0; i < N; ++i) {
        v[i] = load(x.at + kLanes * i);
        for (int l = 0; l < kLanes; ++l) want[i] += x.at[kLanes * i + l];
    }
    return equal(sums<N>(v), want);
}

template <int N>
bool first_entries() {
    const Numbers x(4.0), y(9.0);
    double want[kLanes] = {}, stored[kLanes + 1], added[kLanes + 1], again[kLanes + 1];
    for (int i = 0; i <= kLanes; ++i) stored[i] = added[i] = again[i] = kOutside;
    for (int i = 0; i < N; ++i) {
        want[i] = x.at[i];
        added[i] = again[i] = y.at[i];
    }
    bool good = equal(load_first(x.at, N), want);
    store_first<N>(stored, load(x.at));
    add_first<N>(added, x.at);
    add_first(again, x.at, N);
    for (int i = 0; i <= kLanes; ++i) {
        good &= stored[i] == (i < N ? x.at[i] : kOutside);
        good &= added[i] == (i < N ? y.at[i] + x.at[i] : kOutside) && again[i] == added[i];
    }
    return good;
}

bool gathers() {
    const Numbers x(6.0);
    const std::int32_t all[kLanes] = {7, 0, 3, 3, 12, 1, 30, 2};
    bool good = true;
    for (int begin = -1; begin <= kLanes; ++begin)
        for (int end = begin; end <= kLanes + 1; ++end) {
            double want[kLanes] = {};
            for (int i = 0; i < kLanes; ++i)
                if (i >= begin && i < end) want[i] = x.at[all[i]];
            good &= equal(gather_range(x.at, all, begin, end), want);
        }
    for (int bits = 0; bits < 256; ++bits) {
        std::int32_t some[kLanes];
        double want[kLanes] = {}, ones[kLanes] = {};
        for (int i = 0; i < kLanes; ++i) {
            some[i] = ((bits >> i) & 1) != 0 ? all[i] : -1;
            if (some[i] < 0) continue;
            want[i] = x.at[all[i]];
            ones[i] = 1.0;
        }
        good &= equal(gather_lanes(x.at, some), want);
        good &= equal(bit_lanes(static_cast<std::uint8_t>(bits)), ones);
        good &= any(load(ones)) == (bits != 0);
    }
    return good;
}

bool spreads() {
    const Numbers x(8.0);
    bool good = true;
    for (int i = 0; i < kLanes; ++i) {
        double want[kLanes];
        for (double& w : want) w = x.at[i];
        good &= equal(spread_lane(load(x.at), i), want);
    }
    return good;
}

template <int N>
bool by_count() {
    if (!sums_of<N>() || !first_entries<N>()) return false;
    if constexpr (N < kLanes) return by_count<N + 1>();
    return true;
}

}  // namespace

const char* wrong_lanes() {
    if (!transposes()) return "transpose";
    if (!strides<1>() || !strides<2>() || !strides<3>()) return "load_every, store_every";
    if (!shifts()) return "shift_in";
    if (!by_count<1>()) return "sums, load_first, store_first, add_first";
    if (!gathers()) return "gather_range, gather_lanes, bit_lanes, any";
    if (!spreads()) return "spread_lane";
    return nullptr;
}

}  // namespace hawser::HAWSER_ISA
