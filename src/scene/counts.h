// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file counts.h
/// Counts bodies and interactions that a document asks for, before any of them is made.
#include "scene/document.h"

namespace hawser::scene {

/// @throws SceneError if the document's bodies, or elements of its cables, instances and copies
/// included, exceed settings.max_bodies or settings.max_interactions. Elements given by a parameter
/// of a template count as one.
void check_counts(const Document& document, std::int64_t max_bodies, std::int64_t max_interactions);

}  // namespace hawser::scene
