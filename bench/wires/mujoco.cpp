// SPDX-License-Identifier: Apache-2.0
// MuJoCo 2.2.2: a spatial tendon over a cylinder, and a chain of capsules with ball joints.
//
// Settings follow its documentation for cases in which slip matters (MuJoCo 2.2 documentation,
// "Modeling", sections "Solver parameters" and "Preventing slip"): Newton's solver, elliptic cones,
// impratio above 1. Contacts are as stiff as a step allows (solref of two steps, solimp up to
// 0.9999); the noslip solver is used on request.
#if HAWSER_HAVE_MUJOCO
#include "rig.h"

#include <mujoco/mujoco.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace hawser::bench::wires {
namespace {

/// True after a warning. MuJoCo's own handler ends the program.
bool mujoco_warned = false;

/// A model from its XML.
class MujocoModel {
  public:
    explicit MujocoModel(const std::string& xml) {
        mju_user_warning = [](const char* /*what*/) { mujoco_warned = true; };
        // 2.2.2 reads XML only from files; a virtual one needs no disk.
        const auto files = std::make_unique<mjVFS>();  // 2 MB
        mj_defaultVFS(files.get());
        mj_makeEmptyFileVFS(files.get(), "post.xml", static_cast<int>(xml.size()));
        std::copy(xml.begin(), xml.end(), static_cast<char*>(files->filedata[0]));
        char error[1000] = "";
        model = mj_loadXML("post.xml", files.get(), error, sizeof error);
        mj_deleteVFS(files.get());
        if (model == nullptr) throw std::runtime_error(fmt::format("MuJoCo: {}", error));
        data = mj_makeData(model);
    }
    ~MujocoModel() {
        mj_deleteData(data);
        mj_deleteModel(model);
    }
    MujocoModel(const MujocoModel&) = delete;
    MujocoModel& operator=(const MujocoModel&) = delete;

    [[nodiscard]] int body(const char* name) const { return mj_name2id(model, mjOBJ_BODY, name); }

    mjModel* model = nullptr;
    mjData* data = nullptr;
};

std::string mujoco_head(int substeps, bool noslip) {
    return fmt::format(
        "<mujoco><compiler angle='radian'/>"
        "<option timestep='{:.17g}' gravity='0 0 0' solver='Newton' cone='elliptic' impratio='10' "
        "iterations='100' tolerance='1e-10' noslip_iterations='{}'/>"
        "<size njmax='3000' nconmax='600'/>",
        kFrame / substeps, noslip ? 20 : 0);
}

class MujocoRig : public Rig {
  public:
    void load(double weight, double pull) override {
        mjtNum* f = m_.data->xfrc_applied;
        f[6 * weight_ + 2] = -weight;
        f[6 * pulled_ + 0] = pull * out_[0];
        f[6 * pulled_ + 2] = pull * out_[1];
    }
    bool substep() override {
        // A warning of bad values resets to the start: the run cannot continue.
        mujoco_warned = false;
        mj_step(m_.model, m_.data);
        return !mujoco_warned;
    }
    double displacement() const override { return m_.data->xpos[3 * weight_ + 2] - start_; }

  protected:
    MujocoRig(const std::string& xml, std::array<double, 2> out) : m_(xml), out_(out) {
        weight_ = m_.body("weight");
        pulled_ = m_.body("pulled");
        mj_forward(m_.model, m_.data);
        start_ = m_.data->xpos[3 * weight_ + 2];
    }
    MujocoModel m_;

  private:
    std::array<double, 2> out_;
    int weight_ = 0, pulled_ = 0;
    double start_ = 0.0;
};

/// Return the model as XML. Both bodies slide along their legs, on the two sides of half a turn.
std::string tendon_xml(int substeps) {
    const double length = 2.0 * kLeg + kPi * kRadius;
    const double stiffness = kEA / length;
    // Critical damping for the oscillation of the lighter body on it.
    const double damping = 2.0 * std::sqrt(stiffness * kPulled);
    return mujoco_head(substeps, false) +
           fmt::format(
               "<worldbody><geom name='post' type='cylinder' size='{0} 1' euler='1.5707963267949 "
               "0 0' contype='0' conaffinity='0'/><site name='over' pos='0 0 {1}'/>"
               "<body name='weight' pos='-{0} 0 -{2}'><joint type='slide' axis='0 0 1'/>"
               "<geom type='sphere' size='.1' mass='{3}' contype='0' conaffinity='0'/>"
               "<site name='a'/></body>"
               "<body name='pulled' pos='{0} 0 -{2}'><joint type='slide' axis='0 0 1'/>"
               "<geom type='sphere' size='.1' mass='{4}' contype='0' conaffinity='0'/>"
               "<site name='b'/></body></worldbody>"
               "<tendon><spatial stiffness='{5}' damping='{6}' springlength='{7:.17g}'>"
               "<site site='a'/><geom geom='post' sidesite='over'/><site site='b'/>"
               "</spatial></tendon></mujoco>",
               kRadius, 2.0 * kRadius, kLeg, kWeight, kPulled, stiffness, damping, length);
}

class MujocoTendon final : public MujocoRig {
  public:
    explicit MujocoTendon(int substeps) : MujocoRig(tendon_xml(substeps), {0.0, -1.0}) {}
    std::string settings() const override {
        return "spatial tendon, stiffness EA/length, critically damped";
    }
};

std::string chain_xml(const ChainShape& s, int substeps, bool noslip) {
    const double step = kFrame / substeps;
    std::string xml = mujoco_head(substeps, noslip);
    xml += fmt::format(
        "<default><geom friction='{} 0 0' condim='3' solref='{:.17g} 1' "
        "solimp='0.99 0.9999 0.001'/></default><worldbody>"
        "<geom type='capsule' size='{} 2' euler='1.5707963267949 0 0' contype='0' "
        "conaffinity='1'/>",
        kRub, 2.0 * step, kRadius - kWireRadius);
    xml += fmt::format(
        "<body name='weight' pos='{:.17g} 0 {:.17g}'><freejoint/><geom type='sphere' size='.1' "
        "mass='{}' contype='0' conaffinity='0'/>",
        s.nodes[0][0], s.nodes[0][1], kWeight);
    double x = 0.0, z = 0.0;
    const std::size_t elements = s.nodes.size() - 1;
    for (std::size_t i = 0; i < elements; ++i) {
        const double nx = s.nodes[i + 1][0] - s.nodes[i][0], nz = s.nodes[i + 1][1] - s.nodes[i][1];
        xml += fmt::format(
            "<body pos='{:.17g} 0 {:.17g}'><joint type='ball' damping='0.01'/>"
            "<geom type='capsule' fromto='0 0 0 {:.17g} 0 {:.17g}' size='{}' mass='{}' "
            "contype='1' conaffinity='0'/>",
            x, z, nx, nz, kWireRadius, kDensity * std::hypot(nx, nz));
        x = nx;
        z = nz;
    }
    xml += fmt::format(
        "<body name='pulled' pos='{:.17g} 0 {:.17g}'><geom type='sphere' size='.1' mass='{}' "
        "contype='0' conaffinity='0'/></body>",
        x, z, kPulled);
    for (std::size_t i = 0; i < elements + 1; ++i) xml += "</body>";
    return xml + "</worldbody></mujoco>";
}

class MujocoChain final : public MujocoRig {
  public:
    MujocoChain(const ChainShape& s, int substeps, bool noslip)
        : MujocoRig(chain_xml(s, substeps, noslip), s.out), noslip_(noslip) {}
    std::string settings() const override {
        return fmt::format(
            "Newton, elliptic cones, impratio 10, solref 2 steps, solimp 0.99 0.9999, post a long "
            "capsule{}",
            noslip_ ? ", noslip 20 iterations" : "");
    }

  private:
    bool noslip_;
};

}  // namespace

std::unique_ptr<Rig> make_mujoco_tendon(double turns, int substeps) {
    // A tendon takes the shorter way around a cylinder.
    if (turns > 0.5) return nullptr;
    return std::make_unique<MujocoTendon>(substeps);
}

std::unique_ptr<Rig> make_mujoco_chain(double turns, int elements, int substeps, bool noslip) {
    return std::make_unique<MujocoChain>(chain_shape(turns, elements), substeps, noslip);
}

}  // namespace hawser::bench::wires

#endif  // HAWSER_HAVE_MUJOCO
