// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid pairs: the contacts of a particle file, written as CSV or counted.
#include "particles/text/output.hpp"
#include "particles/text/progress.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"
#include "programs/measure/timing.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>

namespace command {
namespace {

struct PairsOptions {
  ParticleOptions particles;
  GridOptions grid;
  std::string output = "-";
  bool count_only = false;
};

// Counts the pairs and writes them if there is an output.
uint64_t take_pairs(hgrid::Grid &grid, particles::Output *out) {
  particles::Progress progress("searching", "contacts", 0);
  uint64_t count = 0;
  grid.visit_pairs([&](hgrid::View<hg_pair> pairs) {
    count += pairs.size();
    if (out != nullptr)
      for (const hg_pair &pair : pairs) *out << pair.a << ',' << pair.b << '\n';
    progress.update(count);
  });
  return count;
}

void print_count(hgrid::Grid &grid, size_t particles) {
  const auto start = std::chrono::steady_clock::now();
  grid.build();
  const double build = measure::seconds_since(start);
  const uint64_t count = take_pairs(grid, nullptr);
  const double total = measure::seconds_since(start);

  const double number = static_cast<double>(particles);
  const double mean = particles > 0 ? 2.0 * static_cast<double>(count) / number : 0.0;
  char text[512];
  std::snprintf(text, sizeof text,
                "particles              %zu\n"
                "contacts               %llu\n"
                "contacts per particle  %.6g  (each contact counts for both)\n"
                "time to build          %.6f s\n"
                "time to search         %.6f s\n"
                "time per particle      %.1f ns\n",
                particles, static_cast<unsigned long long>(count), mean, build, total - build,
                particles > 0 ? 1e9 * total / number : 0.0);
  particles::Output out("-");
  out << text;
  out.close();
}

void run(const PairsOptions &options) {
  const particles::ParticleSet particles = load_particles(options.particles);
  hgrid::Grid grid = filled_grid(options.grid, particles, options.particles.file);
  if (options.count_only) {
    print_count(grid, particles.count());
    return;
  }
  // Built first: what the library refuses then must not cost the file that is overwritten.
  grid.build();
  particles::Output out(options.output);
  out << "a,b\n";
  take_pairs(grid, &out);
  out.close();
}

}  // namespace

void add_pairs(CLI::App &parent) {
  auto options = std::make_shared<PairsOptions>();
  CLI::App &command = *parent.add_subcommand("pairs", "Find the contacts of a particle file");
  add_particle_options(command, options->particles);
  add_grid_options(command, options->grid);
  auto *output = command
                     .add_option("-o,--output", options->output,
                                 "Where the contacts go: CSV with the columns a,b, a < b (a <= b with --images all);\n"
                                 "- for standard output")
                     ->capture_default_str();
  command.add_flag("--count", options->count_only, "Only count them, and tell the time it took")->excludes(output);
  command
      .add_option("--base", options->grid.index_base, "The number of the first particle of the file in a and b: 0 or 1")
      ->capture_default_str()
      ->check(CLI::IsMember({0, 1}));
  command.footer(
      "a and b are the places of the particles in the file, the first being 0 (or 1 with --base 1).\n"
      "Spheres that exactly touch are no contact, unless --touching says so. Each contact stands on one line; with\n"
      "--images all there is a line for each periodic image in reach, so that a,b may stand on several, and a,a where "
      "a\n"
      "particle meets its own image.\n"
      "Examples:\n"
      "  hgrid pairs packing.csv --output contacts.csv\n"
      "  hgrid pairs dump.lammpstrj --frame 1 --count\n"
      "  hgrid pairs packing.xyz --margin 0.1 --order id --base 1\n"
      "  hgrid pairs open.csv --box 0,0,0,1,1,1 --periodic xy\n"
      "  hgrid pairs sheared.csv --box 0,0,0,1,1,1 --periodic xyz --tilt 0.25,0,0\n"
      "  hgrid pairs crystal.xyz --touching --images all");
  command.callback([options] { run(*options); });
}

}  // namespace command
