// SPDX-License-Identifier: Apache-2.0
#include "memory.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>
#include <unordered_map>

namespace hawser::python {
namespace {

struct Pins {
    int count = 0;
    bool orphan = false;
};

std::atomic<int> pinned_blocks{0};  ///< 0: a deallocation need not search the table.

/// Return the table of pinned blocks. It is never destroyed, because arrays may outlive the module.
std::unordered_map<const void*, Pins>& table() {
    static auto* const pins = new std::unordered_map<const void*, Pins>;
    return *pins;
}

std::mutex& guard() {
    static auto* const mutex = new std::mutex;
    return *mutex;
}

}  // namespace

void pin(const void* block) {
    const std::scoped_lock lock(guard());
    if (table()[block].count++ == 0) pinned_blocks.fetch_add(1);
}

void unpin(const void* block) noexcept {
    bool free_it = false;
    {
        const std::scoped_lock lock(guard());
        const auto at = table().find(block);
        if (at == table().end() || --at->second.count > 0) return;
        free_it = at->second.orphan;
        table().erase(at);
        pinned_blocks.fetch_sub(1);
    }
    if (free_it) std::free(const_cast<void*>(block));
}

bool orphaned(const void* block) noexcept {
    const std::scoped_lock lock(guard());
    const auto at = table().find(block);
    return at != table().end() && at->second.orphan;
}

/// Return true if a block is pinned, and mark it as an orphan.
static bool keep(const void* block) noexcept {
    if (pinned_blocks.load() == 0) return false;
    const std::scoped_lock lock(guard());
    const auto at = table().find(block);
    if (at == table().end()) return false;
    at->second.orphan = true;
    return true;
}

}  // namespace hawser::python

// The linker script version.map makes these definitions local to the module.
void* operator new(std::size_t bytes, std::align_val_t align) {
    const auto a = static_cast<std::size_t>(align);
    const std::size_t padded = (bytes + a - 1) / a * a;
    if (void* const block = std::aligned_alloc(a, padded > 0 ? padded : a)) return block;
    throw std::bad_alloc();
}
void operator delete(void* block, std::align_val_t) noexcept {
    if (block != nullptr && !hawser::python::keep(block)) std::free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t align) noexcept {
    operator delete(block, align);
}
