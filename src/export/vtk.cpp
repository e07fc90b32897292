// SPDX-License-Identifier: Apache-2.0
/// Write VTK XML: PolyData with raw appended blocks, each preceded by its size. Sources: W.
/// Schroeder, K. Martin, B. Lorensen, *The Visualization Toolkit*, 4th ed., 2006; "VTK File
/// Formats", docs.vtk.org.
#include "draw/projection.h"
#include "draw/wire_lines.h"
#include "export/export.h"
#include "record/files.h"
#include "record/solids.h"

#include <fmt/format.h>

#include <cmath>
#include <future>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hawser::exporting {

using draw::WireLine;
using draw::WirePiece;
using draw::WireReader;
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Return text for XML attributes: special characters become '_'.
std::string xml_safe(const std::string& text) {
    std::string out = text;
    for (char& c : out)
        if (c == '"' || c == '<' || c == '&' || c == '>' || static_cast<unsigned char>(c) < 32)
            c = '_';
    return out;
}

/// Data blocks of one file.
class Blocks {
  public:
    template <class T>
    std::string array(const char* type, const char* name, int components,
                      const std::vector<T>& values) {
        std::string out = fmt::format(
            "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
            "offset=\"{}\"/>\n",
            type, name, components, bytes_.size());
        const std::uint64_t size = values.size() * sizeof(T);
        append(&size, sizeof size);
        append(values.data(), size);
        return out;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    void clear() { bytes_.clear(); }

  private:
    void append(const void* data, std::size_t size) {
        bytes_.append(static_cast<const char*>(data), size);
    }
    std::string bytes_;
};

/// Cells of a frame with their data, in the order of the file.
struct Cells {
    std::vector<double> points;
    std::vector<std::int32_t> verts, verts_end, lines, lines_end, polys, polys_end;
    std::vector<std::int32_t> kind, index, broken;
    std::vector<float> tension, strain, orientation, force;

    void clear() {
        points.clear();
        for (auto* all :
             {&verts, &verts_end, &lines, &lines_end, &polys, &polys_end, &kind, &index, &broken})
            all->clear();
        for (auto* all : {&tension, &strain, &orientation, &force}) all->clear();
    }
    std::int32_t point(const Vec3& p) {
        for (int k = 0; k < 3; ++k) points.push_back(p[k]);
        return static_cast<std::int32_t>(points.size() / 3) - 1;
    }
    void data(int kind_, std::size_t index_, float tension_ = kNone, float strain_ = kNone,
              bool parted_ = false) {
        kind.push_back(kind_);
        index.push_back(static_cast<std::int32_t>(index_));
        tension.push_back(tension_);
        strain.push_back(strain_);
        broken.push_back(parted_ ? 1 : 0);
        orientation.resize(4 * kind.size(), kNone);
        force.resize(3 * kind.size(), kNone);
    }
    void add_vertex(const Vec3& p) {
        verts.push_back(point(p));
        verts_end.push_back(static_cast<std::int32_t>(verts.size()));
    }
};

class VtkWriter {
  public:
    explicit VtkWriter(const record::Recording& recording) : reader_(recording) {
        std::string names;
        for (const record::RecordedBody& body : recording.bodies)
            names += xml_safe(body.name) + "\n";
        body_names_ = text_array("body_names", names);
        const std::vector<bool> visible = draw::visible_bodies(recording);
        for (std::size_t i = 0; i < recording.bodies.size(); ++i)
            if (visible[i] || recording.bodies[i].kind == BodyKind::rigid) {
                bodies_.push_back(i);
                surfaces_.push_back(record::body_surfaces(recording, i));
            }
    }

    /// Return the document of a frame, valid until the next call.
    [[nodiscard]] const std::string& document(const record::Frame& frame,
                                              const ContactForces& contacts) {
        cells_.clear();
        append_vertices(frame, contacts, cells_);
        append_wires(frame, cells_);
        append_surfaces(frame, cells_);
        append_text(frame, cells_);
        return out_;
    }

  private:
    void append_vertices(const record::Frame& frame, const ContactForces& at, Cells& cells) const {
        for (const std::size_t body : bodies_) {
            if (!frame.there[body]) continue;
            const Pose& pose = frame.poses[body];
            cells.add_vertex(pose.position);
            cells.data(0, body);
            const Quat& q = pose.orientation;
            float* const to = &cells.orientation[cells.orientation.size() - 4];
            for (int k = 0; k < 4; ++k)
                to[k] = static_cast<float>(k == 0 ? q.w() : q.coeffs()[k - 1]);
        }
        for (std::size_t i = 0; 3 * i + 2 < at.points.size(); ++i) {
            cells.add_vertex({at.points[3 * i], at.points[3 * i + 1], at.points[3 * i + 2]});
            cells.data(1, i);
            for (std::size_t k = 0; k < 3; ++k)
                cells.force[cells.force.size() - 3 + k] = static_cast<float>(at.forces[3 * i + k]);
        }
    }

    void append_wires(const record::Frame& frame, Cells& cells) {
        reader_.read(frame, lines_);
        for (std::size_t w = 0; w < lines_.size(); ++w)
            for (const WirePiece& s : lines_[w].segments) {
                cells.lines.push_back(cells.point(s.from));
                cells.lines.push_back(cells.point(s.to));
                cells.lines_end.push_back(static_cast<std::int32_t>(cells.lines.size()));
                const double EA = lines_[w].EA;
                const float strain = EA > 0.0 ? static_cast<float>(s.tension / EA) : kNone;
                cells.data(2, w, s.tension, strain, s.parted);
            }
    }

    void append_surfaces(const record::Frame& frame, Cells& cells) const {
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            if (!frame.there[bodies_[b]]) continue;
            const Pose& pose = frame.poses[bodies_[b]];
            const Mat3 turn = pose.orientation.normalized().toRotationMatrix();
            for (const record::Triangles& t : surfaces_[b]) {
                const auto first = static_cast<std::int32_t>(cells.points.size() / 3);
                for (const Vec3& p : t.points) (void)cells.point(pose.position + turn * p);
                for (const auto& corner : t.corners) {
                    for (const std::uint32_t k : corner)
                        cells.polys.push_back(first + static_cast<std::int32_t>(k));
                    cells.polys_end.push_back(static_cast<std::int32_t>(cells.polys.size()));
                    cells.data(3, bodies_[b]);
                }
            }
        }
    }

    /// Return the names of wires; rebuilt if wires were added or removed.
    const std::string& wire_names() {
        std::string names;
        for (const WireLine& line : lines_) names += xml_safe(std::string(line.name)) + "\n";
        if (wire_names_.empty() || names != last_names_) {
            wire_names_ = text_array("wire_names", names);
            last_names_ = std::move(names);
        }
        return wire_names_;
    }
    /// Encode a zero-terminated string in numbers, as VTK requires.
    static std::string text_array(const char* name, const std::string& value) {
        std::string out = fmt::format(
            "<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">", name);
        for (const char c : value)
            out += fmt::format("{} ", static_cast<int>(static_cast<unsigned char>(c)));
        return out + "0</Array>\n";
    }

    void append_text(const record::Frame& frame, const Cells& c) {
        Blocks& blocks = blocks_;
        std::string& out = out_;
        blocks.clear();
        out =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
        out += fmt::format(
            "<DataArray type=\"Float64\" Name=\"time\" NumberOfTuples=\"1\" "
            "format=\"ascii\">{:.17g}</DataArray>\n<DataArray type=\"Int64\" Name=\"step\" "
            "NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
            frame.time, frame.step);
        out += body_names_ + wire_names();
        out += fmt::format(
            "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
            "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<Points>\n",
            c.points.size() / 3, c.verts_end.size(), c.lines_end.size(), c.polys_end.size());
        out += blocks.array("Float64", "Points", 3, c.points) + "</Points>\n";
        const auto connect = [&](const char* of, const auto& points, const auto& ends) {
            out += fmt::format("<{}>\n", of) + blocks.array("Int32", "connectivity", 1, points) +
                   blocks.array("Int32", "offsets", 1, ends) + fmt::format("</{}>\n", of);
        };
        connect("Verts", c.verts, c.verts_end);
        connect("Lines", c.lines, c.lines_end);
        connect("Polys", c.polys, c.polys_end);
        out += "<CellData Scalars=\"tension\">\n" + blocks.array("Int32", "kind", 1, c.kind) +
               blocks.array("Int32", "index", 1, c.index) +
               blocks.array("Float32", "tension", 1, c.tension) +
               blocks.array("Float32", "strain", 1, c.strain) +
               blocks.array("Int32", "parted", 1, c.broken) +
               blocks.array("Float32", "orientation", 4, c.orientation) +
               blocks.array("Float32", "force", 3, c.force);
        out += "</CellData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
        out += blocks.bytes();
        out += "\n</AppendedData>\n</VTKFile>\n";
    }

    WireReader reader_;
    std::string body_names_, wire_names_, last_names_;
    // Data of one frame; the buffers are reused for the next one.
    Cells cells_;
    Blocks blocks_;
    std::string out_;
    std::vector<WireLine> lines_;
    std::vector<std::size_t> bodies_;
    std::vector<std::vector<record::Triangles>> surfaces_;
};

void check_written(const std::filesystem::path& file, const std::string& fault) {
    if (!fault.empty())
        throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), fault));
}

}  // namespace

void write_vtk(const record::Recording& recording, const Frames& frames,
               const std::filesystem::path& file, const ContactSource& contacts,
               const Progress& progress) {
    if (const std::string fault = record::output_fault(file); !fault.empty())
        throw std::runtime_error(
            fmt::format("{}: cannot write the collection: {}", file.string(), fault));
    std::filesystem::path folder = file;
    folder.replace_extension();
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault)
        throw std::runtime_error(
            fmt::format("{}: the folder for the frames: {}", folder.string(), fault.message()));
    VtkWriter writer(recording);
    std::string list =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
        "byte_order=\"LittleEndian\">\n<Collection>\n";
    // While one thread writes a frame, this thread replays the run to the next frame.
    std::future<void> under_way;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        record::Frame frame = recording.frame(frames[i]);
        ContactForces forces = contacts ? contacts(frame) : ContactForces{};
        const std::string name = fmt::format("frame_{:06}.vtp", i);
        list += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"0\" file=\"{}/{}\"/>\n",
                            frame.time, xml_safe(folder.filename().string()), name);
        if (under_way.valid()) under_way.get();
        under_way = std::async(
            std::launch::async,
            [&writer, to = folder / name, frame = std::move(frame), forces = std::move(forces)] {
                check_written(to, record::write_file(to, writer.document(frame, forces),
                                                     record::Flush::later));
            });
        if (progress) progress(i + 1);
    }
    if (under_way.valid()) under_way.get();
    // Write the list last, so that all files in it exist.
    check_written(folder, record::flush_folder(folder));
    check_written(file, record::write_file(file, list + "</Collection>\n</VTKFile>\n"));
}

}  // namespace hawser::exporting
