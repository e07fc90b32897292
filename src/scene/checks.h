// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// Compare documents with shapes. If all mistakes are listed, remove the parts with mistakes.

#include "scene/mistakes.h"
#include "scene/shape.h"

#include <string>

namespace hawser::scene {

/// Check a document as check_shape() does. With a list, all mistakes go to it, and the faulty part
/// leaves the document. An entry of a list becomes null; an entry of a map or a key of the settings
/// is removed.
void check_document(Json& root, const Shape& shape, const SourceLocation& location,
                    Mistakes* mistakes);

/// Check a list like check_document(): content[key], whose entries have names that begin with
/// `prefix`.
void check_list(Json& content, const char* key, const Shape& shape, const SourceLocation& location,
                const std::string& prefix, Mistakes* mistakes);

}  // namespace hawser::scene
