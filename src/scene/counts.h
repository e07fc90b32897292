// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file counts.h
/// Count the bodies and interactions of a document before they are created.
#include "scene/document.h"

namespace hawser::scene {

/// Check the counts. @throws SceneError if the document has more bodies than settings.max_bodies,
/// or more interactions than settings.max_interactions. Elements of cables, instances and copies
/// count. Elements given by a parameter of a template count as one.
void check_counts(const Document& document, std::int64_t max_bodies, std::int64_t max_interactions);

}  // namespace hawser::scene
