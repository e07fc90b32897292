// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cranes.h
/// Cranes of usual size: a knuckle boom of 25 t, a lattice boom of 500 t.

#include <hawser/crane.h>

namespace hawser::validate {

inline KnuckleCraneDef knuckle_crane(BodyId on) {
    KnuckleCraneDef d;
    d.name = "crane";
    d.mount = {.on = on, .point = {0, 0, 2}};
    d.slew = {.torque = 4e5, .brake = 6e5, .friction = 2e4, .speed = 0.08};
    d.column = {.mass = 14e3, .centre = {0, 0, 2}, .half_size = {1, 1, 2}};
    d.boom_foot = {0.5, 0, 4};
    d.boom = {.length = 15, .mass = 9e3, .width = 1.2, .height = 1.6};
    d.boom_angle = 1.134;
    d.boom_cylinder = {.foot = {1.8, 0, 0.8},
                       .head = {6, 0, -0.9},
                       .min_length = 5.6,
                       .max_length = 8.9,
                       .push = 3.2e6,
                       .pull = 1.6e6,
                       .speed = 0.1,
                       .stiffness = 2e8,
                       .mass = 600};
    d.jib = {.length = 11, .mass = 5e3, .width = 0.8, .height = 1.0};
    d.jib_angle = -1.484;
    d.jib_cylinder = {.foot = {6, 0, -0.8},
                      .head = {2.5, 0, -0.3},
                      .min_length = 6.9,
                      .max_length = 11,
                      .push = 1.8e6,
                      .pull = 9e5,
                      .speed = 0.12,
                      .stiffness = 1.2e8,
                      .mass = 400};
    d.hoist = {.falls = 2,
               .EA = 6.4e7,
               .sheave_radius = 0.36,
               .drum = {2.5, 0, 1.3},
               .drum_radius = 0.45,
               .drum_inertia = 900,
               .pull = 1.8e5,
               .brake = 3e5,
               .speed = 0.5,
               .breaking_load = 9.5e5};
    d.hook = {.mass = 800, .height = 1.2, .hang = 8, .least_hang = 2};
    d.rating.curve = {{14, 25e3}, {18, 23e3}, {22, 16e3}, {25, 12.5e3}};
    return d;
}

inline LatticeCraneDef lattice_crane(BodyId on) {
    LatticeCraneDef d;
    d.name = "crane";
    d.mount = {.on = on, .point = {0, 0, 2}};
    d.slew = {.torque = 4e6, .brake = 6e6, .friction = 1e5, .speed = 0.03};
    d.column = {.mass = 250e3, .centre = {-5, 0, 3}, .half_size = {7, 4, 3}};
    d.boom_foot = {1.5, 0, 2};
    d.boom = {.length = 60, .mass = 60e3, .width = 3.2, .height = 2.8};
    d.boom_angle = 1.309;
    d.most_angle = 1.48;
    d.gantry = {-8, 0, 16};
    d.bridle_mass = 3e3;
    d.pendant_length = 34;
    d.pendant_EA = 6e8;
    d.luffing = {.falls = 16,
                 .EA = 9.5e7,
                 .drum = {-6, 0, 4},
                 .drum_radius = 0.6,
                 .drum_inertia = 4e3,
                 .pull = 5e5,
                 .brake = 8e5,
                 .speed = 0.1,
                 .breaking_load = 1.45e6};
    d.hoist = {.falls = 12,
               .EA = 1.2e8,
               .sheave_radius = 0.5,
               .drum = {-3, 0, 3},
               .drum_radius = 0.7,
               .drum_inertia = 8e3,
               .pull = 6e5,
               .brake = 9e5,
               .speed = 0.1,
               .breaking_load = 1.9e6};
    d.hook = {.mass = 12e3, .height = 3, .half_size = {1, 1.5, 1.5}, .hang = 40, .least_hang = 4};
    d.rating.curve = {{12, 560e3}, {17, 530e3}, {24, 320e3}, {40, 140e3}};
    return d;
}

}  // namespace hawser::validate
