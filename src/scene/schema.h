// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file schema.h
/// The documents that are generated from the format: the JSON Schema for editors and other
/// programs, and the reference page for people. The committed files are these texts
/// (tests/scene/generated_test.cpp compares them and writes them on request).

#include <string>

namespace hawser::scene {

/// Return schema/scene-1.json: JSON Schema, draft 07. The root describes a scene; the definitions
/// "part" and "state_file" describe included files and state files.
[[nodiscard]] std::string schema_text();

struct Shape;
/// Return the schema of another format with a description of this type.
[[nodiscard]] std::string schema_of(const Shape& root, const std::string& title,
                                    const std::string& source);

/// Return docs/scenes_reference.md.
[[nodiscard]] std::string reference_text();

}  // namespace hawser::scene
