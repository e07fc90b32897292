// SPDX-License-Identifier: Apache-2.0
/// Unions of sets of nodes, one register of 64-bit words at a time. Bits are counted by adding ever
/// wider fields, because SSE2 has no instruction for it.
#include "factor/isa/bits.h"

#include "factor/kernels.h"

namespace hawser::HAWSER_ISA {
namespace {

using U64 = unsigned long long;
// One register: g++ lowers longer vectors through memory.
#if defined(__AVX512F__)
typedef U64 Words __attribute__((vector_size(64), aligned(64), may_alias));
#elif defined(__AVX2__)
typedef U64 Words __attribute__((vector_size(32), aligned(32), may_alias));
#else
typedef U64 Words __attribute__((vector_size(16), aligned(16), may_alias));
#endif
constexpr int kWordsInOne = sizeof(Words) / sizeof(U64);

/// Count the bits of each byte of a vector.
[[gnu::always_inline]] inline void count_bytes(Words& x) {
    x -= (x >> 1) & 0x5555'5555'5555'5555ULL;
    x = (x & 0x3333'3333'3333'3333ULL) + ((x >> 2) & 0x3333'3333'3333'3333ULL);
    x = (x + (x >> 4)) & 0x0f0f'0f0f'0f0f'0f0fULL;
}

/// Sum the counts of count_bytes() over at most 32 words, so that no field overflows.
[[gnu::always_inline]] inline std::int32_t sum_bytes(Words bytes) {
    bytes = (bytes & 0x00ff'00ff'00ff'00ffULL) + ((bytes >> 8) & 0x00ff'00ff'00ff'00ffULL);
    U64 sum = 0;
    for (int lane = 0; lane < kWordsInOne; ++lane) sum += bytes[lane];
    return static_cast<std::int32_t>((sum * 0x0001'0001'0001'0001ULL) >> 48);
}

/// Unite rows of bits.
/// @tparam kWords  Words of a row; 0: `words`.
template <int kWords>
[[gnu::always_inline]] inline void unite_bit_rows(std::uint64_t* rows, long words,
                                                  const std::int32_t* nodes, std::int32_t count,
                                                  const std::uint64_t* with,
                                                  const std::uint64_t* among,
                                                  const factor::NodeWeights& weights,
                                                  std::int32_t* sizes, std::uint64_t* folds) {
    if constexpr (kWords > 0) words = kWords;
    const auto* add = reinterpret_cast<const Words*>(with);
    const auto* mask = reinterpret_cast<const Words*>(among);
    for (std::int32_t k = 0; k < count; ++k) {
        auto* row = reinterpret_cast<Words*>(rows + nodes[k] * words);
        Words bytes = {}, fold = {};
        for (long w = 0; w < words / kWordsInOne; ++w) {
            Words x = (row[w] | add[w]) & mask[w];
            row[w] = x;
            fold ^= x;
            count_bytes(x);
            bytes += x;
        }
        U64 folded = 0;
        for (int lane = 0; lane < kWordsInOne; ++lane) folded ^= fold[lane];
        folds[k] = folded;
        sizes[k] = weights.least * sum_bytes(bytes);
        for (std::int32_t c = 0; c < weights.count; ++c) {
            const auto* heavy = reinterpret_cast<const Words*>(weights.rows + c * words);
            bytes = Words{};
            for (long w = 0; w < words / kWordsInOne; ++w) {
                Words x = row[w] & heavy[w];
                count_bytes(x);
                bytes += x;
            }
            sizes[k] += weights.more[c] * sum_bytes(bytes);
        }
    }
}

}  // namespace

void unite_rows(std::uint64_t* rows, std::int32_t words, const std::int32_t* nodes,
                std::int32_t count, const std::uint64_t* with, const std::uint64_t* among,
                const factor::NodeWeights& weights, std::int32_t* sizes,
                std::uint64_t* folds) noexcept {
    if (words == 8)
        unite_bit_rows<8>(rows, words, nodes, count, with, among, weights, sizes, folds);
    else if (words == 16)
        unite_bit_rows<16>(rows, words, nodes, count, with, among, weights, sizes, folds);
    else
        unite_bit_rows<0>(rows, words, nodes, count, with, among, weights, sizes, folds);
}

}  // namespace hawser::HAWSER_ISA
