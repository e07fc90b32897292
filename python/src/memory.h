// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file memory.h
/// Pins for memory blocks of a world, so that numpy arrays on them never dangle.
///
/// The state arrays of a world are std::vectors with over-aligned storage. This module replaces the
/// aligned forms of operator new and operator delete for the code that is linked into it
/// (memory.cpp, version.map). A pinned block is not freed when the world releases it. It becomes an
/// orphan, and the last unpin() frees it.

namespace hawser::python {

/// Pin the block that begins at an address; the block must be allocated.
void pin(const void* block);
/// Undo one pin(), and free the block if it is an orphan without further pins.
void unpin(const void* block) noexcept;
/// Return true if the world has released this pinned block.
[[nodiscard]] bool orphaned(const void* block) noexcept;

}  // namespace hawser::python
