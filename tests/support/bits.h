// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bits.h
/// Runs that must give equal bits: on any number of threads, and continued in another world from a
/// saved state.

#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace hawser::test {

/// Points at which the bits of a run are compared.
struct SameBits {
    int steps = 0;
    std::initializer_list<int> restored;  ///< Steps after which another world continues.
    std::initializer_list<int> threads{2, 4};
};

/// Expect equal bits. @param make  Makes the scene for a number of threads; its member `w` is the
/// World. @param before  Changes a deck before step i, from 0 on. @param at_end  Called with a deck
/// that ran without a restore. @return state hashes after each step.
template <class Make, class Before, class AtEnd>
std::vector<std::uint64_t> run_hashes(const Make& make, int steps, const Before& before,
                                      int threads, int restored, const AtEnd& at_end) {
    std::vector<std::uint64_t> out;
    const auto run = [&](auto& deck, int from, int to) {
        for (int i = from; i < to; ++i) {
            before(deck, i);
            ASSERT_EQ(deck.w.step(), Status::ok)
                << i << ": " << to_string(deck.w.bad_load(), deck.w);
            out.push_back(deck.w.state().hash());
        }
    };
    auto deck = make(threads);
    if (restored == 0) {
        run(deck, 0, steps);
        at_end(deck);
        return out;
    }
    run(deck, 0, restored);
    const std::vector<std::byte> bytes = deck.w.state().save();
    const Structure made_of = deck.w.state().structure();
    auto other = make(1);
    other.w.state().restore(made_of, bytes);
    run(other, restored, steps);
    return out;
}

template <class Make, class Before, class AtEnd>
void expect_same_bits(const SameBits& look, const Make& make, const Before& before,
                      const AtEnd& at_end) {
    const auto hashes = [&](int threads, int restored) {
        return run_hashes(make, look.steps, before, threads, restored, at_end);
    };
    const std::vector<std::uint64_t> one = hashes(1, 0);
    EXPECT_EQ(one.size(), static_cast<std::size_t>(look.steps));
    for (const int threads : look.threads) EXPECT_EQ(hashes(threads, 0), one) << threads;
    for (const int at : look.restored) EXPECT_EQ(hashes(1, at), one) << at;
}

/// Return the message of a World that rejects a definition; "" if it accepts it.
template <class Def>
std::string error_message(World& w, const Def& def) {
    try {
        (void)w.add(def);
    } catch (const DefError& error) {
        return error.what();
    }
    return "";
}

}  // namespace hawser::test
