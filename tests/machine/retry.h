// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file retry.h
/// Run the calls of a world without failures for reference, then with failing memory requests:
///   - all requests of each call in turn, in one world that keeps the result of each attempt;
///   - some requests in a world of their own: every 55th in the quick tier, every 11th in the full
///     tier, each in the long tier.

#include "machine/failing.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>
#include <vector>

namespace hawser::test {

/// A call; returns false if allocation failed.
using Call = std::function<bool(World&)>;

/// Call a function that may throw std::bad_alloc. @return false if it did.
template <class F>
Call throwing(F f) {
    return [f](World& w) {
        try {
            f(w);
        } catch (const std::bad_alloc&) {
            return false;
        }
        return true;
    };
}

inline bool step_once(World& w) {
    const Status status = w.step();
    if (status == Status::out_of_memory) return false;
    EXPECT_EQ(status, Status::ok) << to_string(status);
    return true;
}

/// Results of a run without failures.
struct Rights {
    std::vector<std::uint64_t> hash;  ///< State hash after each call.
    std::vector<long> requests;       ///< Number of memory requests of each call.
};

class Retry {
  public:
    /// Exception that ends a run once its result is known.
    struct Enough {};

    /// Run without failures.
    Retry() = default;
    /// Let request n of call `number` fail, or one request after another in all calls (−1).
    Retry(const Rights& rights, long number, long n) : rights_(&rights), number_(number), n_(n) {}

    /// Make a call until it succeeds. @param saves  Also compare the saved state.
    void call(World& w, const char* name, const Call& f, bool saves = false) {
        if (testing::Test::HasFailure()) throw Enough{};
        const auto k = static_cast<long>(done_.hash.size());
        const bool here = rights_ != nullptr && (number_ < 0 || number_ == k);
        if (here && number_ >= 0)
            fail_once(w, name, f, saves);
        else
            try_all(w, name, f, here, saves);
        done_.hash.push_back(w.state().hash());
        if (rights_ != nullptr) {
            ASSERT_EQ(done_.hash.back(), rights_->hash.at(static_cast<std::size_t>(k)))
                << "after " << name << ", call " << k << ", where request " << n_ << " of call "
                << number_ << " failed";
        }
        constexpr long kMore = 3;
        if (number_ >= 0 && k >= number_ + kMore) throw Enough{};
    }

    [[nodiscard]] long failures() const { return failures_; }
    [[nodiscard]] const Rights& rights() const { return done_; }

  private:
    void fail_once(World& w, const char* name, const Call& f, bool saves) {
        std::vector<std::byte> saved;
        if (saves && n_ % 2 == 0) saved = w.state().save();
        const std::uint64_t before = w.state().hash();
        bool done = false;
        {
            const failing::Memory memory(n_);
            done = f(w);
        }
        // Succeeded: the failed request was for work after a step, which is deferred.
        if (done) return;
        ++failures_;
        ASSERT_EQ(w.state().hash(), before) << name << ", request " << n_ << " of memory";
        // Every second time nothing reads the world before the call is repeated.
        if (saves && n_ % 2 == 0) {
            ASSERT_EQ(w.state().save(), saved) << name << ", request " << n_ << " of memory";
        }
        ASSERT_TRUE(f(w));
    }

    void try_all(World& w, const char* name, const Call& f, bool fails, bool saves) {
        std::vector<std::byte> saved;
        if (fails && saves) saved = w.state().save();
        const std::uint64_t before = w.state().hash();
        // A sanitizer executes the same code in a few of them.
        const long stride = kSanitized ? 7 : 1;
        for (long n = fails ? 0 : -1;; n += stride) {
            bool done = false;
            {
                const failing::Memory memory(n);
                done = f(w);
                if (!fails) done_.requests.push_back(failing::Memory::seen());
            }
            if (done) return;
            ++failures_;
            ASSERT_EQ(w.state().hash(), before) << name << ", request " << n << " of memory";
            if (saves && n % 2 == 0) {
                ASSERT_EQ(w.state().save(), saved) << name << ", request " << n << " of memory";
            }
        }
    }

    const Rights* rights_ = nullptr;
    long number_ = -1, n_ = -1;
    Rights done_;
    long failures_ = 0;
};

/// Expect the same bits after each call for every failure. @param every  Number of requests from
/// one world of its own to the next; 1: all.
inline void expect_same_bits(const char* name, const std::function<void(Retry&)>& calls,
                             long every = 1) {
    SCOPED_TRACE(name);
    Retry right;
    try {
        calls(right);
    } catch (const Retry::Enough&) {
        return;  // the reference run has failed
    }
    long failures = 0, requests = 0, ended = 0;
    const auto run = [&](long number, long n) {
        Retry failing(right.rights(), number, n);
        try {
            calls(failing);
        } catch (const Retry::Enough&) {
            ++ended;  // after a failure; failing.failures() includes it
        }
        failures += failing.failures();
    };
    run(-1, 0);
    const std::vector<long>& seen = right.rights().requests;
    constexpr long kFew = 11;  // not a divisor of the requests of one call
    if (tier() != Tier::long_runs) every *= kFew;
    if (tier() == Tier::quick) every *= 5;
    // A sanitizer executes the same code in a few of them.
    if (kSanitized) every *= 7;
    long number = 0;
    for (std::size_t k = 0; k < seen.size(); ++k)
        for (long n = 0; n < seen[k] && !testing::Test::HasFailure(); ++n) {
            if (number++ % every != 0) continue;
            ++requests;
            run(static_cast<long>(k), n);
        }
    EXPECT_GT(failures, 0) << "or nothing has been tried";
    std::printf("%-24s %4zu calls, %6ld requests of memory, %6ld failures, %ld runs given up\n",
                name, seen.size(), requests, failures, ended);
}

}  // namespace hawser::test
