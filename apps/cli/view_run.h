// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view_run.h
/// `hawser view`: serve a session, an exercise or a recording, and print the addresses of its
/// roles.

#include "scene_options.h"

#include <cstdint>
#include <string>

namespace hawser::cli {

struct ViewOptions {
    SceneOptions scene;  ///< Options of the scene; its file may be a recording or an exercise.
    std::string listen = "127.0.0.1", record, restore;
    std::string report, summary;  ///< Files of an exercise.
    int port = 8080, clients = 16;
    std::int32_t stride = 1;
    bool rt = false, paused = false, start_at_once = false, open = false;
};

/// Serve until a signal. @return the exit code. @throws std::exception
int view(const ViewOptions& options);

}  // namespace hawser::cli
