// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid picture`: a shaded view of particles, coloured by what one asks for.
#include "particles/error.hpp"
#include "particles/files/walls_vtp.hpp"
#include "particles/text/formatted.hpp"
#include "particles/text/output.hpp"
#include "programs/draw/povray_scene.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"
#include "programs/hgrid/renderer.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace command {
namespace {

struct PictureOptions {
  ParticleOptions particles;
  std::string output;
  std::string color = "size";
  double stiffness = 1;
  int width = 480;
  bool cut = false, no_walls = false;
};

using particles::ParticleSet;

std::vector<double> speeds(const ParticleSet &set, const std::string &file) {
  for (const particles::Column &column : set.columns) {
    if (column.name != "velocity") continue;
    std::vector<double> values;
    for (size_t i = 0; i < set.count(); i++) {
      const double *v = &column.values[3 * i];
      values.push_back(std::hypot(v[0], v[1], v[2]));
    }
    return values;
  }
  throw particles::Error(file, 0, "holds no velocities, so there is no speed to colour by");
}

// Sums over the contacts of each particle: of 1, or of what linear springs push with.
std::vector<double> of_contacts(const PictureOptions &options, const ParticleSet &set, bool count) {
  hgrid::Grid grid = filled_grid({}, set, options.particles.file);
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  const hgrid::PairVectors beside = grid.query_pair_vectors();
  std::vector<double> values(set.count(), 0.0);
  const auto dimension = static_cast<size_t>(set.dimension);
  for (size_t p = 0; p < pairs.size(); p++) {
    const double *d = beside.vectors.data() + p * dimension;
    const double distance = dimension == 3 ? std::hypot(d[0], d[1], d[2]) : std::hypot(d[0], d[1]);
    const auto a = static_cast<size_t>(pairs[p].a), b = static_cast<size_t>(pairs[p].b);
    const double share = count ? 1 : options.stiffness * (set.radii[a] + set.radii[b] - distance);
    values[a] += share;
    values[b] += share;
  }
  return values;
}

draw::Shading shading_of(const PictureOptions &options, const ParticleSet &set) {
  if (options.color == "speed") return {speeds(set, options.particles.file), false, "speed"};
  if (options.color == "contacts") return {of_contacts(options, set, true), false, "contacts"};
  if (options.color == "force") return {of_contacts(options, set, false), false, "force"};
  const double smallest = *std::min_element(set.radii.begin(), set.radii.end());
  return {set.radii, smallest > 0, "radius"};
}

// What lies in one plane is a picture of discs, whether its file says so or not.
ParticleSet load(PictureOptions &options) {
  options.particles.motion = true;
  ParticleSet set = load_particles(options.particles);
  if (set.count() == 0) throw particles::Error(options.particles.file, 0, "no particles to draw");
  if (set.dimension == 2 || options.particles.dimension != 0 || options.particles.file == "-") return set;
  for (size_t i = 0; i < set.count(); i++) {
    if (set.center(i)[2] != set.center(0)[2]) return set;
  }
  if (set.count() < 2) return set;
  options.particles.dimension = 2;
  return load_particles(options.particles);
}

// Those that a run has written beside a state, under the same step.
particles::WallShapes walls_of(const PictureOptions &options) {
  const std::filesystem::path state = options.particles.file;
  const std::string stem = state.stem().string(), start = "state-";
  if (options.no_walls || stem.compare(0, start.size(), start) != 0) return {};
  const std::filesystem::path walls = state.parent_path() / ("walls-" + stem.substr(start.size()) + ".vtp");
  return std::filesystem::exists(walls) ? particles::read_walls(walls.string()) : particles::WallShapes{};
}

void run_picture(PictureOptions options) {
  const ParticleSet set = load(options);
  const draw::Shading shading = shading_of(options, set);
  const draw::RenderedScene scene = draw::povray_scene(set, shading, options.cut, walls_of(options));
  const bool only_scene = std::filesystem::path(options.output).extension() == ".pov" || options.output == "-";
  const std::string file = only_scene ? options.output : options.output + ".pov";
  particles::Output out(file);
  out << scene.text;
  out.close();
  if (!only_scene) {
    render(file, options.output, options.width, static_cast<int>(std::lround(options.width / scene.aspect)));
    std::filesystem::remove(file);
  }
  if (options.output == "-") return;
  const auto [least, most] = std::minmax_element(shading.values.begin(), shading.values.end());
  std::printf("%s: %zu particles, %s %.6g (dark) to %.6g (light)\n", options.output.c_str(), set.count(),
              shading.name.c_str(), *least, *most);
}

}  // namespace

void add_picture(CLI::App &parent) {
  auto options = std::make_shared<PictureOptions>();
  CLI::App *command = parent.add_subcommand(
      "picture", "Render particles, coloured by size, speed, contacts or force, as PNG (needs povray)");
  add_particle_options(*command, options->particles);
  command->add_option("-o,--output", options->output, "Picture to write; one that ends with .pov, or -: the scene only")
      ->required();
  command
      ->add_option("--color", options->color,
                   "size; speed, if the file holds velocities; contacts of each particle; or force: the sum of what "
                   "linear springs of --stiffness push with")
      ->check(CLI::IsMember({"size", "speed", "contacts", "force"}))
      ->capture_default_str();
  command->add_option("--stiffness", options->stiffness, "Of the springs, for force")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--width", options->width, "Of the picture, in pixels")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  command->add_flag("--cut", options->cut, "Leave out the eighth of the view towards the viewer");
  command->add_flag("--no-walls", options->no_walls, "Leave out the walls, which a run writes beside its states");
  command->callback([options] { run_picture(*options); });
}

}  // namespace command
