// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winch_scene.h
/// Recordings of a winch that lowers a weight on a wire. The wire gets nodes at the drum and is
/// cut.

#include "record/small_scene.h"

#include <gtest/gtest.h>
#include <hawser/hawser.h>
#include <hawser/session.h>

#include <filesystem>
#include <string>

namespace hawser::test {

struct WinchScene {
    static constexpr double kWire = 12.0;  ///< Length of the wire at the start [m].
    static constexpr double kCut = 10.0;   ///< Time of the cut [s].
    static constexpr double kAt = 5.0;     ///< Distance of the cut from the drum [m].

    static std::string text() {
        return R"({
  "version": 1, "name": "lowered", "settings": {"step": 0.01},
  "line_types": {"wire": {"mass_per_length": 4.2, "EA": 4.5e6, "diameter": 0.032, "axial_damping": 2}},
  "bodies": [{"name": "load", "kind": "lump", "position": [0, 0, -12], "mass": 800, "linear_damping": 400}],
  "cables": [{"name": "fall", "line_type": "wire", "from": {"at": [0, 0, 0]}, "to": {"body": "load"},
              "elements": 4, "consistent_mass": true, "length": 12}],
  "winches": [{"name": "hoist", "cable": "fall", "core_radius": 0.3, "width": 1.0, "stored": 200,
               "inertia": 500, "torque_haul": 5e4, "torque_pay": 5e4, "brake_static": 6e4,
               "element": 3, "mode": "brake"}],
  "timeline": [{"at": 0.5, "set": {"hoist.mode": 0, "hoist.speed": 1}},
               {"at": 10, "cut": "fall", "s": 5}],
  "plot": {"tensions": ["fall"], "motions": ["load"]}
})";
    }

    /// Record the scene. @param until  Duration [s]. @param back  Continue from the state at 4 s to
    /// 6 s.
    static record::Recording record(double until, bool back = false) {
        const auto file = fresh_folder() / "r.hwr";
        SessionDef def;
        def.scene_text = text();
        def.record = file;
        Session session(def);
        Structure made_of;
        std::vector<std::byte> state;
        const auto run_to = [&](double time) {
            while (session.time() < time - 1e-6) {
                ASSERT_EQ(session.step(), Status::ok) << session.time();
                if (session.time() < 4.0 - 1e-6 || !state.empty()) continue;
                made_of = session.world().state().structure();
                state = session.world().state().save();
            }
        };
        run_to(until);
        if (back) {
            session.restore(made_of, state);
            run_to(6.0);
        }
        (void)session.finish();
        return record::Recording::open(file);
    }
};

}  // namespace hawser::test
