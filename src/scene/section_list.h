// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file section_list.h
/// Lists of a scene and of a template. X(key, item, entries, doc):
/// - key: key of the list;
/// - item: prefix of its functions: item_shape() and, for sections, read_item();
/// - entries: entries in words, for messages;
/// - doc: one sentence for the reference page.
///
/// The format, the JSON Schema, the reference page and the values of templates follow from these
/// rows.

/// Lists that expand.cpp reads in an order of its own.
#define HAWSER_SCENE_LISTS(X)                                                 \
    X(bodies, body, "bodies", "Bodies.")                                      \
    X(interactions, interaction, "interactions", "Interactions.")             \
    X(cables, cable, "cables", "Cables.")                                     \
    X(winches, winch, "winches", "Winches.")                                  \
    X(guides, guide, "guides", "Guides over which cables run.")               \
    X(posts, post, "posts", "Edges and pins that cables may come to lie on.") \
    X(stoppers, stopper, "stoppers", "Shark jaws and chain stoppers.")        \
    X(pins, pin, "pins", "Pins that go up and down.")                         \
    X(hooks, hook, "hooks", "Hooks that take loads.")                         \
    X(chasers, chaser, "chasers", "Rings that run along cables.")             \
    X(cranes, crane, "cranes", "Cranes.")                                     \
    X(vessels, vessel, "vessels", "Vessels.")                                 \
    X(anchors, anchor, "anchors", "Anchors in the soil.")                     \
    X(stability, stability, "stability gauges", "Stability gauges.")          \
    X(routes, route, "routes", "Lines over posts and sheaves.")               \
    X(instances, instance, "instances", "Uses of templates.")                 \
    X(inputs, input, "inputs", "Inputs.")                                     \
    X(outputs, output, "outputs", "Outputs: columns of --csv.")

/// Sections: lists of systems (sections.h).
#define HAWSER_SCENE_SECTIONS(X) \
    X(pids, pid, "controllers", "PID controllers from a force to an input.")
