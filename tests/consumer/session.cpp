// SPDX-License-Identifier: Apache-2.0
//
// What another project sees: a scene file that is run, driven and recorded through the public
// headers of an installed Hawser. Usage: session SCENE RECORDING
#include <hawser/scene.h>
#include <hawser/session.h>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

/// Largest tension of a line.
struct Peak : hawser::Observer {
    hawser::InteractionId line;
    double tension = 0.0;  ///< [N]
    void after_step(const hawser::World& world, std::span<const hawser::Event>) override {
        tension = std::fmax(tension, -world.force(line)[0]);
    }
};

int run(const char* file, const char* recording) {
    const hawser::scene::Scene scene = hawser::scene::load_file(file);
    Peak peak;
    peak.line = scene.cables.at(0).stretch.at(0);

    hawser::Session session({.scene = file, .record = recording});
    session.observe(peak);
    session.set_input("ahts1/thrust_x", 2e5);
    while (session.time() < 2.0 - 1e-9) {
        // A lever that somebody moves: what is recorded is what it did, not this function.
        session.set_input("ahts1/tow_speed", -0.2 * std::sin(3.0 * session.time()));
        if (session.step() != hawser::Status::ok) return 2;
    }
    const hawser::record::Ending ending = session.finish();

    const auto run = hawser::record::Recording::open(recording);
    std::printf("%s: %d bodies, %zu frames, %zu settings of inputs, at most %.4g kN in %s\n",
                session.scene().name.c_str(), session.world().body_count(), run.frame_count(),
                run.inputs.size(), 1e-3 * peak.tension, session.scene().cables[0].name.c_str());
    const bool same = run.end_hash == session.world().state_hash();
    return ending == hawser::record::Ending::finished && same && run.inputs.size() > 100 &&
                   peak.tension > 0.0
               ? 0
               : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 1;
    try {
        return run(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        return 1;
    }
}
