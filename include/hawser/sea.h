// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea.h
/// Sea: depth, tide, waves, current and wind. Loads of water and air on lines, bodies, hulls and
/// rods.
///
/// ```cpp
/// hawser::SeaDef sea{.depth = 150.0};
/// sea.waves.push_back({.kind = hawser::WaveKind::jonswap, .height = 3.0, .period = 9.0});
/// sea.current.push_back({.depth = 0.0, .speed = 0.8, .direction = 0.0});
/// sea.lines.push_back({.wire = tow, .sections = {{20, {.diameter = 0.076, .cd_normal = 1.8}}}});
/// world.add(sea);
/// world.set_system_signal("sea.waves", 0.5);     // half the amplitudes from now on
/// ```
/// Axis z points up; z = 0 is the datum of the level. The bottom lies at z = −depth.
/// ```
///        direction →          η(x, y, t)
///    ~~~~~.-'''-.~~~~~~~~~~~.-'''-.~~~~   level + η
///    - - - - - - - - - - - - - - - - -    level(t), of the tide
///    z = 0                    λ = 2π/k
///         u(z) ~ cosh k(z + d)
///    /////////////////////////////////    z = −depth
/// ```
/// *Waves* are sums of at most 400 components of linear theory (G. B. Airy, "Tides and Waves",
/// 1845). With θ = k·x − ω t + φ and ω² = g k tanh k d
/// ```
///     η = Σ a cos θ      u = Σ a ω C cos θ · k/k      w = Σ a ω S sin θ
///     p = ρ Σ a (ω²/k) C cos θ,      C = cosh k(z' + d)/sinh k d,  S = sinh k(z' + d)/sinh k d
/// ```
/// at z' = d (z + d)/(d + level + η) − d. This stretches the water column between bottom and
/// surface to that of still water. As a result p = 0 at the surface, and velocities in crests are
/// finite. Source: J. D. Wheeler, "Method for calculating forces produced by irregular waves",
/// 1970. Accelerations are ∂u/∂t and ∂w/∂t of these sums.
///
/// *Spectra*: JONSWAP (K. Hasselmann and others, 1973) and Pierson-Moskowitz (1964), in bins of
/// equal width in ω. Each component has a random frequency in its bin, so that the sea does not
/// repeat, and the energy of its bin. The sum is scaled to Hs²/16. Directions are spread as cos^2s
/// (θ/2), with one direction for each component (E. R. Jefferys, "Directional seas should be
/// ergodic", 1987).
///
/// *Wind*: profile and gusts of the Norwegian Petroleum Directorate (ISO 19901-1, A.7.4). The
/// profile is U(z) = U₁₀ (1 + C ln(z/10)), C = 0.0573 √(1 + 0.15 U₁₀). Gusts have the spectrum at
/// 10 m.
///
/// *Lines.* A line has the diameter d, the displaced area A per length and the tangent t. The water
/// has the velocity r relative to the line, with the parts r_n across and r_t along it, and the
/// acceleration a. The load per length is drag, wave force with added mass, and buoyancy (z points
/// up):
/// ```
///     f = ½ρ C_dn d |r_n| r_n + ½ρ C_dt π d |r_t| r_t + ρ A (a + C_a (a − v̇)) + ρ g A z
/// ```
/// Source: J. R. Morison and others, "The force exerted by surface waves on piles", 1950. The load
/// of the wet part of each half element acts on its node. C_a has separate values across and along
/// the line. The step treats drag by its tangent, added mass as mass, and buoyancy at the surface
/// by its stiffness (Loads).
///
/// *Hulls*: hull.h. *Rods* of rigid bodies: water_rod.h.
///
/// Limits: first-order waves without breaking. Diffraction and radiation need coefficients
/// (hydro.h), and act on single bodies. The bottom is level; waves have the depth `depth` at any
/// level. Gusts act everywhere simultaneously. Half elements at bodies have neither mass nor water
/// loads. Loaded bodies do not sleep.
///
/// A world has one sea, the system "sea". Inputs, as "sea.name":
/// - `waves`, `current`: factors of all amplitudes and of the current speed [1];
/// - `wind`, `wind_direction`: mean speed U₁₀ [m/s] and direction of flow [rad];
/// - `level`: height added to the tide [m].
///
/// Outputs: `elevation`, z of the surface at SeaDef::gauge [m]; `gust`, present wind speed U₁₀
/// minus its mean [m/s]; `tide`, level without the input `level` [m].

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/math.h>
#include <hawser/system.h>
#include <hawser/water_hull.h>
#include <hawser/water_rod.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser {

/// Largest number of components of all waves together, and of gusts.
inline constexpr int kMaxWaveComponents = 400;

/// Exception for an invalid definition of the sea.
class SeaError : public DefError {
  public:
    SeaError(std::string where, const std::string& what)
        : DefError("sea: " + where + ": " + what), field(std::move(where)) {}
    std::string field;  ///< Path of the field in SeaDef, such as "waves/0/period".
};

/// Height of still water at a time: an entry of the tide, which is linear between entries.
struct SeaLevel {
    double time = 0.0;   ///< Time [s].
    double level = 0.0;  ///< Height above the datum z = 0 [m].
};

/// Current at a depth: an entry of the profile, which is linear between entries, and constant above
/// the first and below the last.
struct SeaCurrent {
    double depth = 0.0;      ///< Depth below the still water surface, ascending [m].
    double speed = 0.0;      ///< Speed [m/s].
    double direction = 0.0;  ///< Direction of flow, from x towards y [rad].
};

/// Kind of waves.
enum class WaveKind : std::uint8_t { regular, jonswap, pierson_moskowitz };

/// Regular wave, or waves of a spectrum.
struct WaveDef {
    WaveKind kind = WaveKind::regular;  ///< Kind of waves.
    double height = 0.0;  ///< Height from crest to trough; of a spectrum Hs = 4 √m₀ [m]. Required.
    double period = 0.0;  ///< Period T; of a spectrum the peak period Tp [s]. Required.
    double direction = 0.0;  ///< Direction of propagation, from x towards y [rad].
    double phase = 0.0;      ///< Phase φ of a regular wave [rad].
    double gamma = 3.3;      ///< Peak enhancement factor of JONSWAP [1], ≥ 1.
    double spreading = 0.0;  ///< Exponent s of cos^2s, to 200; 0: all components run in
                             ///< `direction`.
    int components = 200;    ///< Number of components of a spectrum.
    std::uint64_t seed = 1;  ///< Seed of phases, frequencies in their bins, and directions.
    double lowest = 0.5;     ///< Lowest frequency over the peak frequency [1].
    double highest = 4.0;    ///< Highest frequency over the peak frequency [1].
};

/// Wind at a height of 10 m.
struct WindDef {
    double speed = 0.0;      ///< Hourly mean speed U₁₀ [m/s].
    double direction = 0.0;  ///< Direction of the air flow, from x towards y [rad].
    bool gusts = false;      ///< True: with gusts of the NPD spectrum, 1/600 to 0.5 Hz.
    int components = 100;    ///< Number of components of the gusts.
    std::uint64_t seed = 1;  ///< Seed of the gusts.
    double density = 1.225;  ///< Density of air [kg/m³].
};

/// Wire with loads of water. Nodes may be inserted and removed during the run.
struct WaterLine {
    WireId wire{};  ///< Wire. Required.
    /// Section of a wire with equal water coefficients. It covers `elements` of the initial
    /// elements; the last section covers all remaining ones. An inserted element gets the
    /// coefficients of the element before it.
    struct Section {
        int elements = 0;   ///< Number of initial elements.
        LineWater water{};  ///< Water coefficients.
    };
    std::vector<Section> sections{};  ///< Sections from the first end. Required.
    /// True: that end is free, and its node belongs to the line. False: the half element at the end
    /// belongs to no node, and has neither mass nor water loads.
    bool free_first = false, free_last = false;
};

/// Small body with loads of water at its centre of mass: a lumped mass, or a rigid body without a
/// hull.
struct WaterBody {
    BodyId body{};                   ///< Body. Required.
    Vec3 drag_area{0.0, 0.0, 0.0};   ///< C_d A along the body's axes, fully wet [m²].
    Vec3 wind_area{0.0, 0.0, 0.0};   ///< C_d A in the wind along the body's axes, fully dry [m²].
    double volume = 0.0;             ///< Displaced volume when submerged [m³].
    Vec3 added_mass{0.0, 0.0, 0.0};  ///< Coefficients C_a along the body's axes, relative to the
                                     ///< volume [1].
    double height = 0.0;  ///< Height from lowest to highest point [m]; 0: that of a sphere of the
                          ///< volume.
};

/// Definition of a sea. World::add() copies it.
struct SeaDef {
    double depth = 0.0;                 ///< Depth of still water at level 0 [m]. Required.
    double density = 1025.0;            ///< Density of water [kg/m³].
    std::vector<SeaLevel> level{};      ///< Tide by ascending time; empty: 0.
    std::vector<WaveDef> waves{};       ///< Waves, superposed.
    std::vector<SeaCurrent> current{};  ///< Current by ascending depth; empty: none.
    WindDef wind{};                     ///< Wind.
    std::array<double, 2> gauge{};      ///< Position x, y of the output `elevation` [m].
    /// Acceleration of the water at lines, bodies and centres of hulls. True: with the convective
    /// term, ∂u/∂t + (u·∇)u of the waves. False: ∂u/∂t.
    bool convective = false;
    std::vector<WaterLine> lines{};   ///< Wires in the water.
    std::vector<WaterBody> bodies{};  ///< Small bodies in the water.
    std::vector<WaterHull> hulls{};   ///< Hulls (water_hull.h).
    std::vector<WaterRod> rods{};     ///< Rods of rigid bodies (water_rod.h).
};

/// Component of the waves.
struct WaveComponent {
    double amplitude = 0.0;    ///< Amplitude a [m].
    double frequency = 0.0;    ///< Angular frequency ω [rad/s].
    double wave_number = 0.0;  ///< Wave number k [1/m].
    double direction = 0.0;    ///< Direction of propagation [rad].
    double phase = 0.0;        ///< Phase φ [rad].
};

/// Component of the gusts.
struct GustComponent {
    double frequency = 0.0;  ///< Frequency [Hz].
    double width = 0.0;      ///< Width of its bin [Hz].
    double phase = 0.0;      ///< Phase [rad].
};

/// Inputs of the system "sea".
struct SeaInputs {
    double waves = 1.0, current = 1.0;        ///< Factors of amplitudes and current [1].
    double wind = 0.0, wind_direction = 0.0;  ///< Speed U₁₀ [m/s] and direction [rad].
    double level = 0.0;                       ///< Height added to the tide [m].
};

/// State of a sea at a time, computed by Sea::at(). An object may be reused to avoid allocation.
struct SeaMoment {
    double time = 0.0;                  ///< Time [s].
    double level = 0.0;                 ///< Level of still water [m].
    double waves = 1.0, current = 1.0;  ///< Factors of amplitudes and current [1].
    double wind = 0.0;                  ///< Speed U₁₀ with gust [m/s].
    double mean_wind = 0.0;             ///< Mean speed U₁₀ [m/s].
    double wind_x = 1.0, wind_y = 0.0;  ///< Unit vector of the wind's direction.
    std::vector<double> phase{};        ///< Phase of each component, (φ − ω t)/2π in [−½, ½].
    std::vector<double> gust{};  ///< Amplitudes of the gusts for the wind speed `gust_of` [m/s].
    double gust_of = -1.0;       ///< Mean wind speed of `gust` [m/s]; < 0: not set.
};

/// State of the water at a point. For a point above the surface: values at the surface below it,
/// and pressure 0.
struct WaterPoint {
    double elevation = 0.0;            ///< z of the surface at the x and y of the point [m].
    Vec3 velocity{0.0, 0.0, 0.0};      ///< Velocity of waves and current [m/s].
    Vec3 acceleration{0.0, 0.0, 0.0};  ///< Acceleration ∂u/∂t of the waves [m/s²].
    double dynamic_pressure = 0.0;     ///< Pressure of the waves [Pa].
    double pressure =
        0.0;  ///< Total pressure above that of the air: weight of water and waves [Pa].
};

/// Waves, current and wind as functions of time and position, without a world.
class Sea {
  public:
    /// Create a sea; lines, bodies, hulls and rods are ignored.
    /// @throws SeaError if the definition is invalid.
    explicit Sea(const SeaDef& def, double gravity = 9.81);

    /// Return the state at a time [s] with the inputs of the definition.
    [[nodiscard]] SeaMoment at(double time) const;
    /// Return the state at a time [s] with given inputs.
    [[nodiscard]] SeaMoment at(double time, const SeaInputs& inputs) const;
    /// Compute the state at a time in `out`, without allocation once `out` has been used.
    void at(double time, const SeaInputs& inputs, SeaMoment& out) const;
    /// Return the inputs of the definition.
    [[nodiscard]] SeaInputs inputs() const noexcept;

    /// Return z of the surface at (x, y) [m].
    [[nodiscard]] double elevation(const SeaMoment& now, double x, double y) const noexcept;
    /// Return velocity, acceleration and pressure of the water at a point.
    [[nodiscard]] WaterPoint water(const SeaMoment& now, const Vec3& point) const noexcept;
    /// Return the velocity of the current at a height z [m/s].
    [[nodiscard]] Vec3 current(const SeaMoment& now, double z) const noexcept;
    /// Return the velocity of the wind at a height z [m/s]. It is 0 at still water and below;
    /// heights up to 1 m above still water count as 1 m.
    [[nodiscard]] Vec3 wind(const SeaMoment& now, double z) const noexcept;
    /// Return the level of the tide, without SeaInputs::level [m].
    [[nodiscard]] double tide(double time) const noexcept;

    /// Return the components of all waves.
    [[nodiscard]] std::span<const WaveComponent> components() const noexcept { return waves_; }
    /// Return the components of the gusts.
    [[nodiscard]] std::span<const GustComponent> gusts() const noexcept { return gusts_; }
    /// Return the depth of still water at level 0 [m].
    [[nodiscard]] double depth() const noexcept { return depth_; }
    /// Return the density of the water [kg/m³].
    [[nodiscard]] double density() const noexcept { return density_; }
    /// Return the gravity [m/s²].
    [[nodiscard]] double gravity() const noexcept { return gravity_; }
    /// Return (u·∇)u of the waves at a point, or at the surface below it [m/s²].
    [[nodiscard]] Vec3 convection(const SeaMoment& now, const Vec3& point) const noexcept;
    /// Return the stretched height z' (top of this file) of a point at height z below a surface at
    /// `elevation` [m]. At the surface and above it is 0.
    [[nodiscard]] double stretched(double z, double elevation) const noexcept;
    /// Return the shortest period of a component [s]; infinite without waves.
    [[nodiscard]] double shortest_period() const noexcept;

  private:
    void make_table();

    double depth_, density_, gravity_;
    std::vector<SeaLevel> level_;
    std::vector<SeaCurrent> current_;
    WindDef wind_;
    std::vector<WaveComponent> waves_;
    std::vector<GustComponent> gusts_;
    int padded_ = 0;             ///< Number of components, padded to a multiple of eight.
    std::vector<double> table_;  ///< Table for the kernels, src/marine/wave_sums.h.
};

/// Compute the wave number k from the dispersion relation ω² = g k tanh k d, to rounding [1/m].
/// @param omega  Angular frequency ω [rad/s].
/// @param depth  Depth d [m].
[[nodiscard]] double wave_number(double omega, double depth, double gravity = 9.81) noexcept;
/// Return the energy density of a spectrum, before scaling to Hs²/16 [m² s/rad].
/// @param omega  Angular frequency ω [rad/s].
[[nodiscard]] double wave_spectrum(const WaveDef& def, double omega) noexcept;
/// Return the NPD energy density of gusts at a height of 10 m [m²/s²/Hz].
/// @param speed  Mean speed U₁₀ [m/s].
/// @param frequency  Frequency [Hz].
[[nodiscard]] double gust_spectrum(double speed, double frequency) noexcept;

/// Add the system "sea"; World::add() calls it.
/// @return the system, owned by the world.
/// @throws SeaError if the definition is invalid
/// @throws DefError if the name is already used, gravity does not point down, or the world's method
/// accepts no loads (`pgs`, `split`)
System* define(World& world, const SeaDef& def);

/// Return the definition of a world's sea; null: none.
[[nodiscard]] const SeaDef* find_sea(const World& world) noexcept;
/// Return the present z of still water, from tide and input `level` [m]; NaN: no sea.
[[nodiscard]] double still_water(const World& world) noexcept;
/// Return the loads of the sea on bodies in the last step, for inspection and verification. One
/// entry for each body, ascending; empty without a sea. Valid until the next step.
[[nodiscard]] std::vector<LoadView> sea_loads(const World& world);

}  // namespace hawser
