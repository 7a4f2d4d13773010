// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The even periodic system whose ranks are measured: radii of a law in random order, places at random in a cube that
// they would fill to 0.62, nothing relaxed. The same everywhere.
#pragma once

#include "packing/packing.hpp"
#include "particles/text/lists.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <utility>

namespace bench {

struct Thrown {
  std::string law = "uniform-volume";
  double ratio = 50;
  size_t count = 250000;
};

inline void add_thrown_options(CLI::App &command, Thrown &thrown) {
  command.add_option("--law", thrown.law, "Law of the sizes")
      ->capture_default_str()
      ->check(CLI::IsMember(particles::names_of(packing::size_laws())));
  command.add_option("--ratio", thrown.ratio, "Its size ratio; the sigma of log-normal")->capture_default_str();
  command.add_option("--count", thrown.count, "Number of particles, of all ranks")->capture_default_str();
}

inline particles::ParticleSet throw_particles(const Thrown &thrown) {
  packing::Request request;
  request.law = packing::law_with(thrown.law, thrown.ratio);
  request.count = thrown.count;
  request.periodic = {true, true, true};
  packing::Beginning beginning = packing::begin_packing(request);
  particles::ParticleSet set = beginning.box.empty_set();
  set.radii = std::move(beginning.radii);
  set.centers.resize(3 * set.count());
  for (double &x : set.centers) x = beginning.box.edge(0) * beginning.random.uniform();
  return set;
}

}  // namespace bench
