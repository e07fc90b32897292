// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea_loads.h
/// Loads of the sea (hawser/sea.h) on bodies, computed independently from its definition and the
/// public data of a World. Sums over components use functions of the standard library. Hulls are
/// cut and integrated at Gauss points. Only the list of components comes from the library; its wave
/// numbers are checked.

#include <hawser/hawser.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace hawser::verify {

class SeaVerifier {
  public:
    explicit SeaVerifier(const World& world);
    /// Restart after another state was restored. The memories of hulls then start with those of the
    /// library.
    void restart() noexcept { history_.clear(); }
    /// Store the inputs of the sea and the time of the step that follows.
    void before_step(const World& world);
    /// Compare the loads of a step.
    /// @param pose, before  Poses and twists of all bodies at the start of the step.
    /// @return the largest difference of a load of the sea from the computed one, relative to its
    ///        size and the body's; 0 without a sea.
    [[nodiscard]] double after_step(const World& world, const std::vector<Pose>& pose,
                                    const std::vector<Twist>& before);
    /// Return the largest difference in a correct step: rounding in double precision, or the
    /// tolerance of kinematics in single precision (docs/theory/waves.md, "Accuracy of
    /// kinematics").
    [[nodiscard]] double limit() const noexcept;

  private:
    using Mat6 = Eigen::Matrix<double, 6, 6>;
    using Vec6 = Eigen::Matrix<double, 6, 1>;
    struct Load {
        bool wet = false;
        Vec6 force = Vec6::Zero();
        Mat6 mass = Mat6::Zero(), damping = Mat6::Zero(), stiffness = Mat6::Zero();
        /// Jumps of the heave stiffness within `surface_error_` of the surface [N/m]. The library
        /// may be on the other side of such a jump.
        double jump = 0.0;
    };
    struct Water {
        double surface = 0.0, pressure = 0.0;
        Vec3 flow{0, 0, 0}, rate{0, 0, 0};
    };
    [[nodiscard]] double surface(double x, double y) const;
    [[nodiscard]] Water water(const Vec3& x) const;
    [[nodiscard]] Vec3 wind(double z) const;
    [[nodiscard]] const LineWater* water_of_element(const World& world, WireId wire,
                                                    std::size_t element) const;
    void add_lines(const World& world, const std::vector<Pose>& pose,
                   const std::vector<Twist>& before);
    /// Add the half of an element next to a node. @param at  Water at the node.
    void add_half(const World& world, WireId wire, std::size_t element, bool last, const Water& at,
                  const std::vector<Pose>& pose, const std::vector<Twist>& before);
    void add_body(const WaterBody& def, const Pose& pose, const Vec3& velocity);
    void add_rod(const WaterRod& def, const Pose& pose, const Twist& twist);  // sea_rods.cpp
    void add_hull(const WaterHull& def, const Pose& pose, const Twist& twist);
    /// Means of the water over wet cells, and areas over those at the design draught
    /// (sea_flow.cpp).
    struct Flow {
        Vec3 velocity{0, 0, 0}, rate{0, 0, 0}, turn{0, 0, 0}, turn_rate{0, 0, 0};
        Vec3 wet_fraction{1, 1, 1}, dry_fraction{1, 1, 1};
    };
    [[nodiscard]] Flow flow_over(const WaterHull& def, const Pose& pose) const;
    void add_motion(const WaterHull& def, const Pose& pose, const Vec3& velocity, double wet,
                    const Flow& flow, Load& out);
    [[nodiscard]] Vec3 convection(const Vec3& x) const;
    // sea_radiation.cpp
    struct Past {
        HullMemory at_start;            ///< Value of the library at the start of verification.
        std::vector<Mat6> kernel;       ///< K(mh), m = 1 …
        std::vector<Vec6> velocity;     ///< ν̄, newest first.
        Eigen::VectorXd states;         ///< States of a state space.
        Eigen::MatrixXd step_on, b, c;  ///< e^{Ah}, B, C.
        Vec6 last = Vec6::Zero(), predicted = Vec6::Zero();
        bool is_begun = false, slow_begun = false;
        std::array<std::array<double, 3>, 4> lag{};
        double until = 0.0;  ///< End time [s].
    };
    void start_history(const World& world, std::size_t hull);
    void add_coefficients(const WaterHull& def, Past& past, const Pose& pose, const Twist& twist);
    void add_memory(const WaterHull& def, Past& past, const Mat3& axes, const Twist& twist,
                    Load& out);
    [[nodiscard]] Vec6 waves_on(const WaterHull& def, const Past& past) const;
    [[nodiscard]] Mat3 frame_of(const WaterHull& def, Past& past, const Pose& pose) const;
    void add_statics(const WaterHull& def, const Pose& pose, const Mat3& level, Load& out) const;
    void add_strips(const WaterHull& def, const Pose& pose, const Twist& twist,
                    const Vec3& wet_fraction, Load& out) const;
    static void add_drag(const Mat3& axes, const Vec3& areas, double half_density, const Vec3& flow,
                         const Vec3& velocity, Load& out);

    /// A component, and functions of its direction.
    struct Wave {
        WaveComponent of;
        double east = 1.0, north = 0.0;  ///< cos and sin of its direction.
        double all = 1.0;                ///< 1 − e^(−2kd).
    };

    const SeaDef* def_ = nullptr;
    std::vector<Wave> waves_;
    std::unique_ptr<const Sea> sea_;
    double gravity_ = 9.81;
    std::vector<std::pair<InteractionId, const LineWater*>>
        line_water_;  ///< As defined, ascending.
    std::vector<LineWater> volumes_;
    std::vector<BodyId> ends_;  ///< Bodies that hold lines.
    SeaInputs inputs_{};
    double time_ = 0.0, level_ = 0.0;
    double surface_error_ = 0.0;  ///< Permitted error of the elevation [m].
    std::vector<bool> intact_;    ///< By interaction, at the start of the step.
    SeaMoment air_{};
    std::vector<Load> load_;
    std::vector<Past> history_;                 ///< By hull.
    std::vector<std::vector<HullCell>> cells_;  ///< By hull; empty without a mesh.
    double step_ = 0.0;
    std::vector<double> mass_;  ///< By body [kg].
};

}  // namespace hawser::verify
