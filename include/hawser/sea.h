// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea.h
/// The sea: depth, tide, waves, current and wind, and what water and air do to lines, bodies, hulls
/// and rods.
///
/// ```cpp
/// hawser::SeaDef sea{.depth = 150.0};
/// sea.waves.push_back({.kind = hawser::WaveKind::jonswap, .height = 3.0, .period = 9.0});
/// sea.current.push_back({.depth = 0.0, .speed = 0.8, .direction = 0.0});
/// sea.lines.push_back({.wire = tow, .sections = {{20, {.diameter = 0.076, .cd_normal = 1.8}}}});
/// world.add(sea);
/// world.set_system_signal("sea.waves", 0.5);     // half as high from now on
/// ```
/// z points up; z = 0 is the datum of the level, the bottom lies at z = −depth.
/// ```
///        direction →          η(x, y, t)
///    ~~~~~.-'''-.~~~~~~~~~~~.-'''-.~~~~   level + η
///    - - - - - - - - - - - - - - - - -    level(t), of the tide
///    z = 0                    λ = 2π/k
///         u(z) ~ cosh k(z + d)
///    /////////////////////////////////    z = −depth
/// ```
/// **Waves** are sums of at most 400 components of linear theory (G. B. Airy, "Tides and Waves",
/// 1845). With θ = k·x − ω t + φ and ω² = g k tanh k d
/// ```
///     η = Σ a cos θ      u = Σ a ω C cos θ · k/k      w = Σ a ω S sin θ
///     p = ρ Σ a (ω²/k) C cos θ,      C = cosh k(z' + d)/sinh k d,  S = sinh k(z' + d)/sinh k d
/// ```
/// at z' = d (z + d)/(d + level + η) − d: the column of water between bottom and surface is
/// stretched to that of still water (J. D. Wheeler, "Method for calculating forces produced by
/// irregular waves", 1970), so that p = 0 and crests have finite velocities at the surface.
/// Accelerations are ∂u/∂t and ∂w/∂t of the same sums.
///
/// **Spectra**: JONSWAP (K. Hasselmann and others, 1973) and Pierson-Moskowitz (1964), in bins of
/// equal width in ω; each component lies at random in its bin, so that the sea never repeats, and
/// has the energy of its bin. All of it is made Hs²/16. Directions are spread as cos^2s (θ/2),
/// one direction a component (E. R. Jefferys, "Directional seas should be ergodic", 1987).
///
/// **Wind**: profile and gusts of the Norwegian Petroleum Directorate (ISO 19901-1, A.7.4):
/// U(z) = U₁₀ (1 + C ln(z/10)), C = 0.0573 √(1 + 0.15 U₁₀), gusts of the spectrum at 10 m.
///
/// **Drag** (J. R. Morison and others, "The force exerted by surface waves on piles", 1950): per
/// length of a line of diameter d, displaced area A, tangent t and velocity r of the water past it
/// ```
///     f = ½ρ C_dn d |r_n| r_n + ½ρ C_dt π d |r_t| r_t + ρ A (a + C_a (a − v̇)) + ρ g A z
/// ```
/// each half of an element by itself at its lump, as far as it is wet; the part C_a across and
/// along the line apart. Drag goes in with its tangent, added mass as mass, buoyancy of what
/// pierces the surface with its stiffness (Loads).
///
/// **Hulls**: hull.h; **rods** of rigid bodies: water_rod.h.
///
/// Limits: waves of first order, no breaking, no diffraction or radiation but by coefficients
/// (hydro.h) and on one body by itself, no bottom that is not level; waves have the depth `depth`
/// whatever the level; gusts act everywhere at once. Half elements that end on bodies have neither
/// mass nor water. What is loaded does not sleep.
///
/// A world has one sea, the system "sea". Signals, as "sea.name". Inputs: `waves` (factor of all
/// amplitudes), `current` (factor), `wind` (U₁₀ [m/s]), `wind_direction` [rad], `level` (on top of
/// the tide [m]). Outputs: `elevation` (at SeaDef::gauge [m]), `gust` [m/s], `tide` [m].

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

/// Most components of all waves together, and of gusts.
inline constexpr int kMaxWaveComponents = 400;

/// A definition of the sea that is refused.
class SeaError : public DefError {
  public:
    SeaError(std::string where, const std::string& what)
        : DefError("sea: " + where + ": " + what), field(std::move(where)) {}
    std::string field;  ///< Which, from SeaDef on, such as "waves/0/period".
};

/// Height of still water at a time; linear between two.
struct SeaLevel {
    double time = 0.0;   ///< [s].
    double level = 0.0;  ///< Above the datum z = 0 [m].
};

/// Current at a depth; linear between two, constant above the first and below the last.
struct SeaCurrent {
    double depth = 0.0;      ///< Below the surface of still water, ascending [m].
    double speed = 0.0;      ///< [m/s].
    double direction = 0.0;  ///< To which it flows, from x towards y [rad].
};

enum class WaveKind : std::uint8_t { regular, jonswap, pierson_moskowitz };

/// A regular wave, or the waves of a spectrum.
struct WaveDef {
    WaveKind kind = WaveKind::regular;
    double height = 0.0;     ///< Crest to trough; of a spectrum Hs = 4 √m₀ [m]. Required.
    double period = 0.0;     ///< T; of a spectrum Tp, of its peak [s]. Required.
    double direction = 0.0;  ///< To which they run, from x towards y [rad].
    double phase = 0.0;      ///< φ of a regular wave [rad].
    double gamma = 3.3;      ///< Peak enhancement of JONSWAP, from 1 on [1].
    double spreading = 0.0;  ///< s of cos^2s, to 200; 0: all run in `direction`.
    int components = 200;    ///< Of a spectrum.
    std::uint64_t seed = 1;  ///< Of phases, frequencies in their bins, and directions.
    double lowest = 0.5;     ///< Frequencies taken, over that of the peak [1] …
    double highest = 4.0;    ///< … to this.
};

/// Wind at the height of 10 m.
struct WindDef {
    double speed = 0.0;      ///< Mean of an hour, U₁₀ [m/s].
    double direction = 0.0;  ///< To which it blows, from x towards y [rad].
    bool gusts = false;      ///< With those of the NPD spectrum, 1/600 to 0.5 Hz.
    int components = 100;    ///< Of gusts.
    std::uint64_t seed = 1;  ///< Of gusts.
    double density = 1.225;  ///< Of air [kg/m³].
};

/// A wire in the water; nodes may come and go.
struct WaterLine {
    WireId wire{};  ///< Required.
    /// Water coefficients along the wire, from its first end on. A section covers `elements`
    /// elements of the start, the last one all that follow; an element that a new node makes takes
    /// the coefficients of the element before it.
    struct Section {
        int elements = 0;
        LineWater water{};
    };
    std::vector<Section> sections{};  ///< Required.
    /// Its ends are free: their lumps are nodes of the line. Else a half element at an end belongs
    /// to no lump, and has neither mass nor water.
    bool free_first = false, free_last = false;
};

/// A lump, or a rigid body whose hull does not matter: forces at its centre of mass.
struct WaterBody {
    BodyId body{};                   ///< Required.
    Vec3 drag_area{0.0, 0.0, 0.0};   ///< C_d A along the body's axes, all of it wet [m²].
    Vec3 wind_area{0.0, 0.0, 0.0};   ///< The same in the wind, when all of it is dry [m²].
    double volume = 0.0;             ///< Displaced when it is under water [m³].
    Vec3 added_mass{0.0, 0.0, 0.0};  ///< C_a along the body's axes, of the volume [1].
    double height = 0.0;  ///< From its lowest to its highest point [m]; 0: of a ball of the volume.
};

/// A definition: World::add copies it whole.
struct SeaDef {
    double depth = 0.0;                 ///< Of still water at level 0 [m]. Required.
    double density = 1025.0;            ///< Of water [kg/m³].
    std::vector<SeaLevel> level{};      ///< Tide, by time; empty: 0.
    std::vector<WaveDef> waves{};       ///< They add up.
    std::vector<SeaCurrent> current{};  ///< By depth; empty: none.
    WindDef wind{};
    std::array<double, 2> gauge{};  ///< x, y of the output `elevation` [m].
    /// Accelerations are ∂u/∂t + (u·∇)u of the waves, at lines, bodies and hulls' centres.
    bool convective = false;
    std::vector<WaterLine> lines{};
    std::vector<WaterBody> bodies{};
    std::vector<WaterHull> hulls{};
    std::vector<WaterRod> rods{};
};

/// One component of the waves.
struct WaveComponent {
    double amplitude = 0.0;    ///< a [m].
    double frequency = 0.0;    ///< ω [rad/s].
    double wave_number = 0.0;  ///< k [1/m].
    double direction = 0.0;    ///< [rad].
    double phase = 0.0;        ///< φ [rad].
};

/// One component of gusts.
struct GustComponent {
    double frequency = 0.0;  ///< [Hz].
    double width = 0.0;      ///< Of its bin [Hz].
    double phase = 0.0;      ///< [rad].
};

/// What may be changed while a sea is used; the signals of the system "sea".
struct SeaInputs {
    double waves = 1.0, current = 1.0;        ///< Factors [1].
    double wind = 0.0, wind_direction = 0.0;  ///< U₁₀ [m/s], [rad].
    double level = 0.0;                       ///< On top of the tide [m].
};

/// A sea at a time: phases of its components. Its memory is kept where it is used again.
struct SeaMoment {
    double time = 0.0;   ///< [s].
    double level = 0.0;  ///< Of still water [m].
    double waves = 1.0, current = 1.0;
    double wind = 0.0;                  ///< U₁₀ with the gust [m/s].
    double mean_wind = 0.0;             ///< U₁₀ [m/s].
    double wind_x = 1.0, wind_y = 0.0;  ///< Direction.
    std::vector<double> phase{};        ///< Of each component (φ − ω t)/2π, in [−½, ½].
    std::vector<double> gust{};         ///< Amplitudes of gusts at `gust_of` [m/s].
    double gust_of = -1.0;
};

/// Water at a point. Above the surface: what is at it, and pressure 0.
struct WaterPoint {
    double elevation = 0.0;            ///< z of the surface above or below it [m].
    Vec3 velocity{0.0, 0.0, 0.0};      ///< Of waves and current [m/s].
    Vec3 acceleration{0.0, 0.0, 0.0};  ///< ∂/∂t [m/s²].
    double dynamic_pressure = 0.0;     ///< Of waves [Pa].
    double pressure = 0.0;             ///< With that of its weight, above that of the air [Pa].
};

/// Waves, current and wind by themselves, without a world.
class Sea {
  public:
    /// @throws SeaError on what makes no sense; what is in the water does not matter here.
    explicit Sea(const SeaDef& def, double gravity = 9.81);

    [[nodiscard]] SeaMoment at(double time) const;
    [[nodiscard]] SeaMoment at(double time, const SeaInputs& inputs) const;
    /// The same into a moment that there is; it allocates nothing once that was used.
    void at(double time, const SeaInputs& inputs, SeaMoment& out) const;
    /// Inputs as defined.
    [[nodiscard]] SeaInputs inputs() const noexcept;

    [[nodiscard]] double elevation(const SeaMoment& now, double x, double y) const noexcept;
    [[nodiscard]] WaterPoint water(const SeaMoment& now, const Vec3& point) const noexcept;
    [[nodiscard]] Vec3 current(const SeaMoment& now, double z) const noexcept;
    /// Wind at a height, 0 at the surface of still water and below 1 m as at 1 m.
    [[nodiscard]] Vec3 wind(const SeaMoment& now, double z) const noexcept;
    /// Of the tide, without SeaInputs::level [m].
    [[nodiscard]] double tide(double time) const noexcept;

    [[nodiscard]] std::span<const WaveComponent> components() const noexcept { return waves_; }
    [[nodiscard]] std::span<const GustComponent> gusts() const noexcept { return gusts_; }
    [[nodiscard]] double depth() const noexcept { return depth_; }
    [[nodiscard]] double density() const noexcept { return density_; }
    [[nodiscard]] double gravity() const noexcept { return gravity_; }
    /// (u·∇)u of the waves at a point; above the surface that at it [m/s²].
    [[nodiscard]] Vec3 convection(const SeaMoment& now, const Vec3& point) const noexcept;
    /// z' of a point under a surface at `elevation`; 0 at it and above.
    [[nodiscard]] double stretched(double z, double elevation) const noexcept;
    /// Shortest period of a component [s]; infinite: there are no waves.
    [[nodiscard]] double shortest_period() const noexcept;

  private:
    void make_table();

    double depth_, density_, gravity_;
    std::vector<SeaLevel> level_;
    std::vector<SeaCurrent> current_;
    WindDef wind_;
    std::vector<WaveComponent> waves_;
    std::vector<GustComponent> gusts_;
    int padded_ = 0;             ///< Components, a multiple of eight.
    std::vector<double> table_;  ///< For kernels: src/marine/wave_sums.h.
};

/// k of a wave of ω [rad/s] in water of a depth [m]: ω² = g k tanh k d, to rounding [1/m].
[[nodiscard]] double wave_number(double omega, double depth, double gravity = 9.81) noexcept;
/// Energy density of a spectrum at ω [m² s/rad], before the whole of it is made Hs²/16.
[[nodiscard]] double wave_spectrum(const WaveDef& def, double omega) noexcept;
/// NPD's density of gusts at 10 m for U₁₀ [m/s] at f [Hz]: [m²/s² / Hz].
[[nodiscard]] double gust_spectrum(double speed, double frequency) noexcept;

/// The system "sea", which the world owns. @throws SeaError, DefError where a name is taken,
/// gravity does not point down, or the method of the world takes no loads (`pgs`, `split`).
System* define(World& world, const SeaDef& def);

/// The sea of a world as defined; null: it has none.
[[nodiscard]] const SeaDef* find_sea(const World& world) noexcept;
/// z of still water now, tide and input `level` [m]; NaN: there is no sea.
[[nodiscard]] double still_water(const World& world) noexcept;
/// What the sea did to bodies in the last step, one entry a body, ascending: for readers and
/// verifiers. Good until the next step. Empty: there is none.
[[nodiscard]] std::vector<LoadView> sea_loads(const World& world);

}  // namespace hawser
