// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What commands that run scenes say on the way.
#include "programs/hgrid/run_line.hpp"

#include "dem/effects/table.hpp"
#include "particles/text/formatted.hpp"

#include <cstdio>

namespace command {

void RunLine::show(uint64_t step, const dem::Measurement &m) {
  shown_ = std::chrono::steady_clock::now();
  const double left = done_ > 0 ? seconds_ / done_ * static_cast<double>(last_ - step) : 0;
  const std::string text = particles::formatted(
      "step %llu of %llu (%.0f %%), time %.6g, energy %.6g, %zu contacts, %.1f ns per particle and step, %.0f s left",
      static_cast<unsigned long long>(step), static_cast<unsigned long long>(last_),
      100.0 * static_cast<double>(step - first_) / static_cast<double>(std::max<uint64_t>(1, last_ - first_)), m.time,
      m.energy(), m.contacts + m.wall_contacts, ns_per_particle_step(), left);
  if (line_.is_seen()) return line_.show(text);
  std::fprintf(stderr, "%s\n", text.c_str());
  std::fflush(stderr);
}

uint64_t next_record(const scene::OutputPlan &plan, uint64_t step, uint64_t until) {
  for (const uint64_t interval : {plan.pictures, plan.energies, plan.checkpoints}) {
    if (interval > 0) until = std::min(until, (step / interval + 1) * interval);
  }
  return until;
}

bool is_recorded(uint64_t interval, uint64_t step, uint64_t last) {
  return interval > 0 && (step % interval == 0 || step == last);
}

void print_scene(const scene::Scene &scene, const std::string &path) {
  const dem::Setup &setup = scene.setup;
  double smallest = dem::kInfinity, largest = 0;
  visit_particles(setup, [&](const dem::ParticleArrays &particles, size_t i) {
    smallest = std::min(smallest, particles.radii[i]);
    largest = std::max(largest, particles.radii[i]);
  });
  std::printf("%s: %s\n", path.c_str(), scene.title.c_str());
  if (!scene.stage_name.empty())
    std::printf("stage %zu: %s, from step %llu on\n", scene.stage + 1, scene.stage_name.c_str(),
                static_cast<unsigned long long>(setup.beginning.step));
  std::printf("%zu %s, radii %.6g to %.6g; effects: %s\n", setup.count(), setup.dimension == 2 ? "discs" : "spheres",
              smallest, largest, dem::names_of(setup.effects).c_str());
  std::printf("shortest contact %.6g, %llu steps of %.6g (%s), skin %.6g\n", scene.shortest_contact,
              static_cast<unsigned long long>(scene.steps - setup.beginning.step), setup.time_step,
              setup.scheme.name.c_str(), setup.skin);
}

}  // namespace command
