// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hawser.h
/// Everything of hawser::hawser in one include; scene.h and session.h have libraries of their own.

#include <hawser/catenary.h>
#include <hawser/changes.h>
#include <hawser/chaser.h>
#include <hawser/crane.h>
#include <hawser/def.h>
#include <hawser/drum_feed.h>
#include <hawser/edges.h>
#include <hawser/edits.h>
#include <hawser/factor.h>
#include <hawser/guide.h>
#include <hawser/hook.h>
#include <hawser/hull.h>
#include <hawser/hydro.h>
#include <hawser/id.h>
#include <hawser/inspect.h>
#include <hawser/interactions.h>
#include <hawser/joints.h>
#include <hawser/limits.h>
#include <hawser/lines.h>
#include <hawser/math.h>
#include <hawser/outputs.h>
#include <hawser/partition.h>
#include <hawser/pin.h>
#include <hawser/post.h>
#include <hawser/resolution.h>
#include <hawser/route.h>
#include <hawser/row_constants.h>
#include <hawser/schedule.h>
#include <hawser/sea.h>
#include <hawser/settings.h>
#include <hawser/shapes.h>
#include <hawser/state.h>
#include <hawser/stats.h>
#include <hawser/stopper.h>
#include <hawser/structure.h>
#include <hawser/system.h>
#include <hawser/systems/pid.h>
#include <hawser/trace.h>
#include <hawser/water_hull.h>
#include <hawser/water_rod.h>
#include <hawser/winch.h>
#include <hawser/wire.h>
#include <hawser/world.h>
