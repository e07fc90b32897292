// SPDX-License-Identifier: Apache-2.0
#include "scene/plot.h"

#include <string>
#include <vector>

namespace hawser::scene {

void read_plot(Scene& scene, const Description& description, const Document& document) {
    const auto plot = document.root.find("plot");
    if (plot == document.root.end()) {
        return;
    }
    const SourceLocation location = document.location / "plot";
    const auto read = [&](const char* key, std::vector<std::string>& names, const auto& exists,
                          const char* what, OmittedPart lost, const auto& known) {
        const auto list = plot->find(key);
        for (std::size_t i = 0; list != plot->end() && i < list->size(); ++i) {
            names.push_back((*list)[i].template get<std::string>());
            (void)attempt(description.mistakes, [&] {
                if (!exists(names.back())) {
                    report_missing(description.mistakes, lost, names.back(), location / key / i,
                                   std::string("there is no ") + what + " " +
                                       in_quotes(names.back()) + suggestion(names.back(), known()));
                }
            });
        }
    };
    read(
        "tensions", scene.plot_tensions,
        [&](const std::string& name) { return description.has_cable(name); }, "cable",
        OmittedPart::cable,
        [&] {
            std::vector<std::string> known;
            for (const Cable& cable : description.cables) {
                known.push_back(cable.name);
            }
            return known;
        });
    read(
        "motions", scene.plot_motions,
        [&](const std::string& name) { return description.find_body(name).valid(); }, "body",
        OmittedPart::body,
        [&] {
            std::vector<std::string> known;
            for (const BodyDef& body : description.bodies) {
                known.push_back(body.name);
            }
            return known;
        });
    if (const auto box = plot->find("view_box"); box != plot->end()) {
        for (std::size_t i = 0; i < 6; i += 3) {
            scene.plot_view_box.emplace_back((*box)[i].get<double>(), (*box)[i + 1].get<double>(),
                                             (*box)[i + 2].get<double>());
        }
        (void)attempt(description.mistakes, [&] {
            if (!(scene.plot_view_box[0].array() < scene.plot_view_box[1].array()).all()) {
                throw_error(location / "view_box", "the lower corner must lie below the upper one");
            }
        });
    }
}

}  // namespace hawser::scene
