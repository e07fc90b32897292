// SPDX-License-Identifier: Apache-2.0
#include "base/isa.h"

#include <hawser/world.h>

#include <cstdlib>
#include <cstring>

namespace hawser::base {
namespace {

Isa best_of_machine() noexcept {
    Isa best = Isa::sse2;
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) best = Isa::avx2;
    if (best == Isa::avx2 && __builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512bw"))
        best = Isa::avx512;
#if defined(HAWSER_NO_AVX512)
    if (best == Isa::avx512) best = Isa::avx2;
#endif
#if defined(HAWSER_NO_AVX2)
    if (best == Isa::avx2) best = Isa::sse2;
#endif
    return best;
}

/// Find the requested instruction set. If none is available under that name, set `found` to `best`
/// and return false.
bool find_isa(const char* wish, Isa best, Isa& found) noexcept {
    found = best;
    if (wish == nullptr || *wish == '\0') return true;
    for (const Isa i : {Isa::sse2, Isa::avx2, Isa::avx512})
        if (i <= best && std::strcmp(wish, to_string(i)) == 0) {
            found = i;
            return true;
        }
    return false;
}

const char* requested_isa() noexcept { return std::getenv("HAWSER_ISA"); }

}  // namespace

IsaChoice choose_isa(const char* wish, Isa best) {
    IsaChoice choice{best, ""};
    if (find_isa(wish, best, choice.isa)) return choice;
    const bool known = std::strcmp(wish, "avx2") == 0 || std::strcmp(wish, "avx512") == 0;
    std::string names = to_string(Isa::sse2);
    for (const Isa i : {Isa::avx2, Isa::avx512})
        if (i <= best) names += std::string(", ") + to_string(i);
    choice.problem = "HAWSER_ISA = \"" + std::string(wish).substr(0, 40) +
                     "\" in the environment " +
                     (known ? "is an instruction set that this processor or build has not"
                            : "names no instruction set") +
                     "; here there are " + names + "; unset it for the best";
    return choice;
}

Isa isa() noexcept {
    static const Isa chosen = [] {
        Isa found = Isa::sse2;
        (void)find_isa(requested_isa(), best_of_machine(), found);
        return found;
    }();
    return chosen;
}

void require_isa() {
    static const std::string problem = choose_isa(requested_isa(), best_of_machine()).problem;
    if (!problem.empty()) throw EnvironmentError(problem);
}

const char* to_string(Isa isa) noexcept {
    switch (isa) {
        case Isa::sse2:
            return "sse2";
        case Isa::avx2:
            return "avx2";
        case Isa::avx512:
            return "avx512";
    }
    return "?";
}

}  // namespace hawser::base

namespace hawser {

const char* instruction_set() noexcept { return base::to_string(base::isa()); }

void check_environment() { base::require_isa(); }

}  // namespace hawser
