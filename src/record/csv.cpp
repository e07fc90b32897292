// SPDX-License-Identifier: Apache-2.0
#include "record/csv.h"

#include "record/files.h"
#include "record/series.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>

namespace hawser::record {

namespace {

// Quote a name for CSV if it contains a comma or quote, and double its quotes (RFC 4180).
std::string csv_quoted(const std::string& name) {
    if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
    std::string out = "\"";
    for (const char c : name) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

}  // namespace

CsvWriter::CsvWriter(const std::filesystem::path& file, const SceneInfo& scene, const World& world)
    : file_(file) {
    if (const std::string fault = output_fault(file); !fault.empty())
        throw std::runtime_error(fmt::format("{}: cannot write: {}", file.string(), fault));
    out_.reset(std::fopen(file.c_str(), "wb"));
    if (!out_)
        throw std::runtime_error(
            fmt::format("{}: cannot write: {}", file.string(), std::strerror(errno)));
    line_ = "time [s]";
    for (const CableInfo& cable : scene.cables) {
        if (cable.elements.empty()) continue;
        const InteractionId first = cable.elements.front(), last = cable.elements.back();
        ends_.push_back({world.alive(first) ? world.wires().of(first) : WireId{}, first, last});
        line_ += "," + csv_quoted(cable.name + " tension at first end [N]");
        line_ += "," + csv_quoted(cable.name + " tension at last end [N]");
    }
    bodies_ = watched_bodies(scene, world);
    for (const BodyId body : bodies_)
        for (const char* what :
             {"x [m]", "y [m]", "z [m]", "roll [deg]", "pitch [deg]", "yaw [deg]"})
            line_ += "," + csv_quoted(body_label(world, body) + " " + what);
    for (const OutputId id : world.output_ids()) {
        const OutputDef& output = world.output_def(id);
        outputs_.push_back(id);
        line_ += "," + csv_quoted(output.name + " [" + output.unit + "]");
    }
    write();
}

void CsvWriter::add_row(const World& world) {
    const auto out = std::back_inserter(line_);
    fmt::format_to(out, "{:.9g}", world.time());
    constexpr double kRemovedValue = std::numeric_limits<double>::quiet_NaN();
    const auto tension = [&](InteractionId id) {
        return world.alive(id) ? element_tension(world, id) : kRemovedValue;
    };
    for (const auto& [wire, first, last] : ends_) {
        const auto now =
            world.alive(wire) ? world.wires().elements(wire) : std::span<const InteractionId>();
        fmt::format_to(out, ",{:.9g},{:.9g}", tension(now.empty() ? first : now.front()),
                       tension(now.empty() ? last : now.back()));
    }
    for (const BodyId body : bodies_) {
        if (!world.alive(body)) {
            for (int k = 0; k < 6; ++k) fmt::format_to(out, ",{:.9g}", kRemovedValue);
            continue;
        }
        const Pose pose = world.pose(body);
        const Vec3 angles = kDegrees * euler_angles(pose.orientation);
        for (const Vec3& v : {pose.position, angles})
            fmt::format_to(out, ",{:.9g},{:.9g},{:.9g}", v.x(), v.y(), v.z());
    }
    for (const OutputId id : outputs_)
        fmt::format_to(out, ",{:.9g}", world.alive(id) ? world.output(id) : kRemovedValue);
    write();
}

void CsvWriter::write() {
    line_ += '\n';
    if (std::fwrite(line_.data(), 1, line_.size(), out_.get()) != line_.size())
        throw std::runtime_error(
            fmt::format("{}: cannot write: {}", file_.string(), std::strerror(errno)));
    line_.clear();
}

void CsvWriter::finish() {
    if (std::fflush(out_.get()) != 0)
        throw std::runtime_error(
            fmt::format("{}: cannot write: {}", file_.string(), std::strerror(errno)));
}

}  // namespace hawser::record
