// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Inflows, removals and regions in scene files: what they mean, and what is refused with which words.
#include "tests/dem/bodies.hpp"
#include "tests/dem/scene_text.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

const std::string kScene =
    "[[inflow]]\nmin = [1, 1, 8]\nmax = [9, 9, 9.5]\nrate = 3\nradius = 0.5\ndensity = 2\nvelocity = [0, 0, -1]\n"
    "[[removal]]\npoint = [0, 0, 2]\nnormal = [0, 0, 1]\n[[region]]\nmin = [0, 0, 0]\nmax = [10, 10, 5]\n"
    "[contact]\nstiffness = 1e4\n[time]\nend = 2\n[box]\nmax = [10, 10, 10]\n";

bool a_scene_says_it_all() {
  const scene::Scene scene = scene_text::read(kScene);
  const dem::Setup &setup = scene.setup;
  if (setup.count() != 0 || setup.inflows.size() != 1 || setup.removals.size() != 1) return false;
  const dem::Inflow &in = setup.inflows[0];
  const bool read = in.box.name == "inflow-1" && in.rate == 3 && in.velocity[2] == -1 && in.box.low[2] == 8 &&
                    std::fabs(in.masses[0] - bodies::kPi / 3) < 1e-12 && setup.removals[0].name == "removal-1" &&
                    scene.output.regions.size() == 1 && scene.output.regions[0].high[2] == 5;
  const auto engine = dem::make_engine(setup);
  engine->run(scene.steps);
  return read && engine->passages()[0].count == 5;
}

bool sizes_follow_a_law() {
  std::string text = kScene;
  text.replace(text.find("radius = 0.5"), 12, "radius = 0.1\ncount = 100\nradii = {law = \"two-sizes\", ratio = 3}");
  const dem::Setup setup = scene_text::read(text).setup;
  const std::vector<double> &radii = setup.inflows[0].radii;
  const auto large = std::count_if(radii.begin(), radii.end(), [](double radius) { return radius > 0.29; });
  const std::vector<double> &expected = setup.expected.radii;
  // As much volume of either.
  return radii.size() == 100 && large > 1 && large < 8 && expected.size() == 4 && expected[1] == 0.1 &&
         std::fabs(expected[2] - 0.3) < 1e-12;
}

bool materials_come_along() {
  std::string text = kScene;
  text.replace(text.find("density = 2"), 11, "material = \"steel\"");
  text.erase(text.find("[time]"), std::string("[time]\nend = 2\n").size());
  const std::string path = scene_text::write_file(
      text +
      "[[material]]\nname = \"glass\"\n[[material]]\nname = \"steel\"\ndensity = 8\n[[stage]]\nsteps = 20000\n"
      "inflow = false\nremoval = false\n[[stage.particles]]\nat = [[5, 5, 5]]\nradius = 1\nmaterial = \"steel\"\n"
      "[[stage]]\nduration = 1\n[[stage]]\nsteps = 2\ninflow = false\n[[stage.particles]]\nat = [[3, 3, 3]]\n"
      "radius = 1\nmaterial = \"glass\"\n");
  const scene::StagedScene stages(path);
  std::filesystem::remove(path);
  scene::Scene scene = stages.first();
  for (int stage = 0; stage < 2; stage++) {
    const auto engine = dem::make_engine(scene.setup);
    engine->run(scene.steps - engine->steps_done());
    scene = stages.after(scene, engine->hand_over());
  }
  return scene.setup.material_ids == std::vector<uint8_t>{1, 1, 1, 0};
}

bool faults_are_named() {
  const auto refused = [](const std::string &out, const std::string &in, const std::string &start) {
    std::string text = kScene;
    text.replace(text.find(out), out.size(), in);
    return scene_text::is_refused(text, start);
  };
  return refused("rate = 3\n", "", ":1: [inflow] needs the key 'rate'") &&
         refused("rate = 3", "rate = 0", ":4: inflow.rate: 0 is not above 0") &&
         refused("radius = 0.5", "radius = 5", ":3: inflow.max: the largest particle, of radius 5, does not fit") &&
         refused("9.5]", "10.5]", ":3: inflow.max: the box reaches behind the walls of axis z") &&
         refused("radius = 0.5\n", "", ":1: [inflow] needs the key 'radius'") &&
         refused("normal = [0, 0, 1]", "normal = [0, 0, 0]", ":10: removal.normal: is no direction") &&
         refused("normal = [0, 0, 1]", "max = [1, 1, 1]", ":9: removal.point: stands instead of min and max") &&
         refused("rate = 3", "rate = 3\nname = \"removal-1\"", ":9: removal: an inflow has the same name") &&
         refused("radius = 0.5\ndensity = 2", "density = \"2 kg/m^3\"\nradii = {law = \"mono\"}",
                 ":1: inflow.radius: is needed beside numbers with units") &&
         refused("[10, 10, 5]", "[10, 10, -5]", ":13: region.max: -5 is not above 0");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<a_scene_says_it_all>),
      cmocka_unit_test(passes<sizes_follow_a_law>),
      cmocka_unit_test(passes<materials_come_along>),
      cmocka_unit_test(passes<faults_are_named>),
  };
  return cmocka_run_group_tests_name("exchange scenes", tests, nullptr, nullptr);
}
