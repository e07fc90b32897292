// SPDX-License-Identifier: Apache-2.0
#include "marine/checks.h"

#include <hawser/world.h>

#include "marine/radiation.h"
#include "marine/spectra.h"

#include <limits>

namespace hawser::marine {
namespace {

void check_memory(const World& world, const WaterHull& h, const std::string& at) {
    const WaveCoefficients& c = *h.coefficients;
    if (h.radiation == RadiationKind::none) return;
    if (c.added_mass.empty())
        throw SeaError(at + "/coefficients",
                       "they have no added mass and damping, which radiation needs; give them, or "
                       "radiation \"none\"");
    if (h.radiation == RadiationKind::constant) {
        check_range(at + "/constant_period", h.constant_period, 0.0, 1e4, true, "s");
        const Matrix6 a = linear_at(c.frequency, c.added_mass, kTwoPi / h.constant_period);
        const Matrix6 good = without_negative(a);
        if ((good - 0.5 * (a + a.transpose())).norm() > 1e-3 * good.norm())
            throw SeaError(at + "/constant_period",
                           "the added mass of " + number(h.constant_period) +
                               " s is not positive semi-definite; give another period");
        return;
    }
    if (c.frequency.size() < 4)
        throw SeaError(at + "/coefficients", std::to_string(c.frequency.size()) +
                                                 " frequencies are too few for a memory; give 4 "
                                                 "or more");
    const double step = world.settings().step;
    check_range(at + "/memory", h.memory, 4.0 * step, 1e5 * step, false, "s");
    if (h.radiation == RadiationKind::state_space)
        check_range(at + "/order", h.order, 1.0, 200.0, false, "");
}

void check_waves(const WaterHull& h, const std::string& at) {
    const WaveCoefficients& c = *h.coefficients;
    if (h.excitation == ExcitationKind::full) {
        if (c.excitation.empty())
            throw SeaError(at + "/excitation", "the coefficients have no force of waves");
        if (h.wave_pressure && !h.linear.on)
            throw SeaError(at + "/excitation",
                           "\"full\" includes the wave pressure, which the mesh adds as well; give "
                           "wave_pressure false, or excitation \"scattering\"");
    }
    if (h.excitation == ExcitationKind::scattering) {
        if (c.scattering.empty())
            throw SeaError(at + "/excitation", "the coefficients have no force of scattering");
        if (!h.wave_pressure || h.linear.on)
            throw SeaError(at + "/excitation",
                           "\"scattering\" needs the wave pressure on the mesh in addition; give "
                           "wave_pressure true, or excitation \"full\"");
    }
    if (h.drift && c.drift.empty())
        throw SeaError(at + "/drift", "the coefficients have no table of drift");
    check_range(at + "/slow_time", h.slow_time, 0.0, 1e5, false, "s");
}

}  // namespace

void check_coefficients(const World& world, const WaterHull& h, const std::string& at) {
    for (std::size_t i = 0; i < h.strips.size(); ++i) {
        const HullStrip& strip = h.strips[i];
        const std::string place = at + "/strips/" + std::to_string(i);
        for (const double x : strip.at) check_range(place + "/at", x, -1e6, 1e6, false, "m");
        check_range(place + "/axis", strip.axis.norm(), 1.0 - 1e-6, 1.0 + 1e-6, false, "");
        check_range(place + "/drag_area", strip.drag_area, 0.0, 1e9, false, "m^2");
    }
    const bool needs = h.excitation != ExcitationKind::none || h.drift || h.coriolis;
    if (!h.coefficients) {
        if (needs)
            throw SeaError(at + "/coefficients",
                           "excitation, drift and coriolis need them; give a file");
        if (h.linear.on)
            throw SeaError(at + "/coefficients", "linear statics need them, with a stiffness");
        return;
    }
    const WaveCoefficients& c = *h.coefficients;
    if (const std::string fault = coefficients_fault(c); !fault.empty())
        throw SeaError(at + "/coefficients", fault);
    check_memory(world, h, at);
    check_waves(h, at);
    if (!h.linear.on) return;
    if (!c.has_stiffness)
        throw SeaError(at + "/linear", "the coefficients have no stiffness, which it needs");
    check_range(at + "/linear/height", h.linear.height, -1e4, 1e4, false, "m");
    if (!std::isnan(h.linear.weight))
        check_range(at + "/linear/weight", h.linear.weight, 0.0, 1e15, false, "N");
}

}  // namespace hawser::marine
