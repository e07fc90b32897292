// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file section_list.h
/// Sections of a scene: lists of systems (sections.h). X(key, item, entries, doc):
/// - key: key of the list in a scene and in a template;
/// - item: prefix of its functions: item_shape(), read_item();
/// - entries: entries in words, for messages;
/// - doc: one sentence for the reference page.

#define HAWSER_SCENE_SECTIONS(X) \
    X(pids, pid, "controllers", "PID controllers from a force to an input.")
