#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write the scenes of the validation cases and of the benchmarks to scenes/.

Usage: scripts/make_scenes.py        (standard library only; the files are committed)
"""

import scenes_benchmark
import scenes_cables
import scenes_contact
import scenes_contact_wires
import scenes_joints
import scenes_mechanisms
import scenes_scheme
import scenes_towing
import scenes_winches
import scenes_wires

if __name__ == "__main__":
    for module in (scenes_scheme, scenes_mechanisms, scenes_cables, scenes_benchmark,
                   scenes_contact, scenes_contact_wires, scenes_joints, scenes_towing,
                   scenes_winches, scenes_wires):
        module.main()
