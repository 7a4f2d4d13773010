// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What time steps follow from the shortest contact (docs/theory/time-step.md).
#include "dem/setup/time_step.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/body_force.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

void lower(StepLimit &limit, double step, const std::string &reason) {
  if (step < limit.longest) limit = {step, reason};
}

double stable_step(const Setup &setup, const ShortestContact &contact) {
  const double crowd = kCrowd * crowd_of_springs(setup);
  const double zeta = contact.damping;
  return 2 / contact.frequency * (std::sqrt(zeta * zeta + setup.scheme.stability / (4 * crowd)) - zeta);
}

StepLimit contact_limit(const Setup &setup, const ShortestContact &contact) {
  StepLimit limit;
  lower(limit, contact.duration / kFewestStepsPerContact, "the shortest contact lasts " + text(contact.duration));
  if (contact.frequency > 0) {
    lower(limit, stable_step(setup, contact),
          "the dashpots and springs of many contacts at once, the shortest of which lasts " + text(contact.duration) +
              ", make it unstable");
  }
  return limit;
}

}  // namespace

StepLimit step_limit(const Setup &setup) {
  StepLimit limit;
  for (const ShortestContact &contact : shortest_contacts(setup)) {
    const StepLimit of_contact = contact_limit(setup, contact);
    lower(limit, of_contact.longest, of_contact.reason);
    lower(limit, contact.crossing / kFewestStepsInRange,
          "surfaces cross the range of adhesion within " + text(contact.crossing));
  }
  if (has(setup.effects, kDrag)) {
    double fastest = 0;  // how fast drag slows a particle
    visit_particles(setup, [&](const ParticleArrays &particles, size_t i) {
      fastest = std::max(fastest, drag_of(setup) * particles.radii[i] / particles.masses[i]);
    });
    lower(limit, 0.1 / fastest, "drag stops the lightest particle within " + text(1 / fastest));
  }
  return limit;
}

double usual_step(const Setup &setup) {
  double usual = step_limit(setup).longest;
  for (const ShortestContact &contact : shortest_contacts(setup))
    usual = std::min({usual, contact.duration / kUsualStepsPerContact, contact.crossing / kUsualStepsInRange});
  return usual;
}

void require_time_step(const Setup &setup) {
  if (!(setup.time_step > 0) || !std::isfinite(setup.time_step)) {
    throw Error("the time step is above 0, not " + text(setup.time_step));
  }
  const StepLimit limit = step_limit(setup);
  if (setup.time_step > limit.longest) {
    throw Error("the time step " + text(setup.time_step) + " is too large: " + limit.reason + ", so " +
                text(limit.longest) + " is the limit and " + text(usual_step(setup)) + " is usual");
  }
}

double fastest_allowed(const Setup &setup) {
  double fastest = kInfinity, sinking = 0;
  for (const ShortestContact &contact : shortest_contacts(setup)) {
    // All times of Hertz contacts go as v^(-1/5).
    if (has(setup.effects, kHertz) && contact.speed > 0) {
      fastest = std::min(fastest, contact.speed * std::pow(contact_limit(setup, contact).longest / setup.time_step, 5));
    }
    if (contact.crossing < kInfinity) sinking = std::max(sinking, contact.sinking);
  }
  // Within contacts adhesion makes particles faster than they ever cross its range, in pockets of several still more.
  if (sinking > 0) fastest = setup.contact.adhesion_range / (kFewestStepsInRange * setup.time_step) + 2 * sinking;
  return fastest;
}

std::string speed_fault(const Setup &setup, double approach, double allowed) {
  return "particles approach with " + text(approach) + ", and the time step " + text(setup.time_step) +
         " is short enough for " + text(allowed) + ": give an impact_speed of " + text(2 * approach) +
         ", or a shorter step";
}

}  // namespace dem
