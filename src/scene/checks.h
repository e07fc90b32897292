// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// Compares documents with shapes, and takes out what holds a mistake where all are listed.

#include "scene/mistakes.h"
#include "scene/shape.h"

#include <string>

namespace hawser::scene {

/// As check_shape(). Where there is a list, all mistakes go to it, and what holds one leaves the
/// document: an entry of a list becomes null, of a map goes, as does a key of the settings.
void check_document(Json& root, const Shape& shape, const Place& place, Mistakes* mistakes);

/// check_document() of one list, content[key], whose entries have names that begin with `prefix`.
void check_list(Json& content, const char* key, const Shape& shape, const Place& place,
                const std::string& prefix, Mistakes* mistakes);

}  // namespace hawser::scene
