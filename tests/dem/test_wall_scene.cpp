// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Walls in scene files: what they mean, what is refused, and triangle meshes in both forms of STL.
#include "dem/scene/scene.hpp"
#include "dem/scene/stl.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

const std::string kBasic =
    "[[particles]]\nat = [[0, 0, 0]]\nradius = 1\n[contact]\nstiffness = 1e4\n[time]\nsteps = 10\n";

std::string path_of(const std::string &name) {
  return (std::filesystem::temp_directory_path() / ("hgrid-test-walls-" + std::to_string(getpid()) + name)).string();
}

std::string write_file(const std::string &name, const std::string &text) {
  std::ofstream(path_of(name), std::ios::binary) << text;
  return path_of(name);
}

dem::Setup read(const std::string &text) {
  const std::string path = write_file(".toml", text);
  dem::Setup setup = scene::read_scene(path).setup;
  std::filesystem::remove(path);
  return setup;
}

bool is_refused(const std::string &text, const std::string &start) {
  const std::string path = write_file(".toml", text);
  std::string what = test::error_of([&] { scene::read_scene(path); });
  std::filesystem::remove(path);
  if (what.compare(0, path.size(), path) == 0) what.erase(0, path.size());
  const bool fits = what.compare(0, start.size(), start) == 0;
  if (!fits) std::printf("refused with: %s\n", what.c_str());
  return fits;
}

bool planes_and_cylinders_are_read() {
  const dem::Setup setup =
      read(kBasic +
           "[[wall]]\npoint = [0.01, 0, 0]\nnormal = [0, 3, 4]\nforce = 5\nspeed = 2\n"
           "[[wall]]\nname = \"drum\"\npoint = [1, 2, 3]\naxis = [0, 0, -2]\nradius = 7\nturning = 2\n"
           "swing = [0, 0, 1]\nfrequency = 3\n");
  const dem::WallBody &piston = setup.walls[0], &drum = setup.walls[1];
  return setup.effects == dem::kSurfaces && piston.name == "wall-1" && piston.shape == dem::WallShape::kPlane &&
         piston.point[0] == 0.01 && std::fabs(piston.normal[1] - 0.6) < 1e-15 && piston.force == 5 &&
         piston.fastest == 2 && drum.name == "drum" && drum.shape == dem::WallShape::kCylinder && drum.radius == 7 &&
         drum.normal[2] == -1 && drum.pivot[1] == 2 && drum.turning == 2 && drum.swing[2] == 1 && drum.frequency == 3;
}

void walls_say_what_they_mean(void **) { assert_true(planes_and_cylinders_are_read()); }

void faults_of_walls_are_named(void **) {
  const std::string flat = "[[wall]]\npoint = [0, 0, 0]\n", plane = flat + "normal = [0, 0, 1]\n";
  assert_true(is_refused(kBasic + flat, ":8: [wall] needs the key 'normal'"));
  assert_true(is_refused(kBasic + flat + "normal = [0, 0, 0]\n", ":10: wall.normal: is no direction"));
  assert_true(is_refused(kBasic + plane + "force = 1\n", ":11: wall.force: and speed go together"));
  assert_true(is_refused(kBasic + plane + "axis = [1, 0, 0]\n", ":11: wall.axis: a plane turns about its normal"));
  assert_true(is_refused(kBasic + flat + "radius = -1\n", ":10: wall.radius: -1 is not above 0"));
  assert_true(is_refused(kBasic + flat + "radius = 1\n", ":8: [wall] needs the key 'axis'"));
  assert_true(
      is_refused(kBasic + plane + "name = \"a\"\n" + plane + "name = \"a\"\n", ":15: wall.name: 'a' is the name"));
  assert_true(is_refused(kBasic + plane + "swing = [1, 0, 0]\n", ":11: wall.swing: and frequency go together"));
  assert_true(is_refused(kBasic + "[[wall]]\nfile = \"nowhere.stl\"\n", ":9: wall.file: "));
  assert_true(is_refused(kBasic + plane + "[box]\nmax = [9, 9, 9]\n[periodic]\naxes = \"z\"\n",
                         ":10: wall.normal: the wall does not go along the periodic axis z"));
}

const char *kText =
    "solid two\n"
    " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1.5 0\n  endloop\n endfacet\n"
    " facet normal 0 0 1\n  outer loop\n   vertex 1 0 0\n   vertex 1 1 -2.5e-1\n   vertex 0 1.5 0\n  endloop\n "
    "endfacet\n"
    "endsolid two\n";
const std::vector<double> kCorners = {0, 0, 0, 1, 0, 0, 0, 1.5, 0, 1, 0, 0, 1, 1, -0.25, 0, 1.5, 0};

std::string in_binary(const std::vector<double> &corners) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // some programs write that, too
  const auto append = [&](const void *number) { bytes.append(static_cast<const char *>(number), 4); };
  const auto count = static_cast<uint32_t>(corners.size() / 9);
  append(&count);
  for (size_t k = 0; k < corners.size(); k++) {
    const float none = 0, value = static_cast<float>(corners[k]);
    for (int axis = 0; axis < 3 && k % 9 == 0; axis++) append(&none);
    append(&value);
    if (k % 9 == 8) bytes.append(2, '\0');
  }
  return bytes;
}

std::string stl_error(const std::string &bytes) {
  const std::string path = write_file(".stl", bytes);
  const std::string what = test::error_of([&] { scene::read_stl(path); });
  std::filesystem::remove(path);
  return what.compare(0, path.size(), path) == 0 ? what.substr(path.size()) : what;
}

void both_forms_of_stl_are_read(void **) {
  const std::string text = write_file("-a.stl", kText), binary = write_file("-b.stl", in_binary(kCorners));
  const bool same = scene::read_stl(text) == kCorners && scene::read_stl(binary) == kCorners;
  const dem::Setup setup = read(kBasic + "[[wall]]\nfile = \"" + text + "\"\nscale = 2\npoint = [0, 0, 1]\n");
  std::filesystem::remove(text);
  std::filesystem::remove(binary);
  assert_true(same);
  assert_true(setup.walls[0].corners[7] == 3 && setup.walls[0].corners[14] == 0.5);
}

void faulty_stl_is_refused_with_its_place(void **) {
  const std::string text = kText;
  assert_string_equal(stl_error("hello\n").c_str(), ": holds no triangle: is it an STL file?");
  assert_string_equal(stl_error("solid a\nvertex 0 0 0\nvertex 1 0 0\n").c_str(),
                      ": has 2 vertices, which are no whole triangles");
  assert_string_equal(stl_error("solid a\nvertex 0 0\n").c_str(), ":2: a vertex has three numbers, not 2");
  assert_string_equal(stl_error("solid a\nvertex 0 0 zero\n").c_str(), ":2: 'zero' is not a number");
  std::vector<double> corners = kCorners;
  corners[10] = NAN;
  assert_string_equal(stl_error(in_binary(corners)).c_str(), ": a corner of triangle 2 is not finite");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(walls_say_what_they_mean),
      cmocka_unit_test(faults_of_walls_are_named),
      cmocka_unit_test(both_forms_of_stl_are_read),
      cmocka_unit_test(faulty_stl_is_refused_with_its_place),
  };
  return cmocka_run_group_tests_name("wall scenes", tests, nullptr, nullptr);
}
