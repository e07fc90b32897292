// SPDX-License-Identifier: Apache-2.0
/// A warm step allocates nothing: every operator new of this program is counted.
#include "stepper/scenes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t align) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    void* p = align > alignof(std::max_align_t)
                  ? std::aligned_alloc(align, (size + align - 1) / align * align)
                  : std::malloc(size);
    if (p == nullptr) throw std::bad_alloc();
    return p;
}

}  // namespace

// g++ 12 inlines one side of these pairs only and then believes that they do not match.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

void* operator new(std::size_t size) { return counted(size, 0); }
void* operator new[](std::size_t size) { return counted(size, 0); }
void* operator new(std::size_t size, std::align_val_t a) {
    return counted(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
    return counted(size, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace hawser {
namespace {

TEST(WarmStep, AllocatesNothing) {
    for (const auto& file : test::scene_files())
        for (const int threads : {1, 2}) {
            scene::Options options;
            options.threads = threads;
            scene::Scene s = scene::load_file(file, options);
            for (int i = 0; i < 3; ++i) ASSERT_EQ(s.world.step(), Status::ok) << file;
            const std::int64_t growths = s.world.stats().growths;
            const long before = allocations.load();
            for (int i = 0; i < 20; ++i) (void)s.world.step();
            EXPECT_EQ(allocations.load(), before) << file << " on " << threads;
            EXPECT_EQ(s.world.stats().growths, growths);
        }
}

TEST(WarmStep, CounterCounts) {
    const long before = allocations.load();
    auto* p = new std::vector<int>(100);
    EXPECT_GE(allocations.load(), before + 2);
    delete p;
}

}  // namespace
}  // namespace hawser
