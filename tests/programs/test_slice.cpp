// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The cut through a packing: which disks it gives, how large, and what the picture holds of them.
#include "programs/draw/slice.hpp"
#include "programs/draw/slice_picture.hpp"
#include "programs/draw/svg.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <string>

namespace {

const std::vector<draw::Level> kTwoLevels = {{2, 1, 3}, {6, 3, 1}};

particles::ParticleSet boxed(std::vector<double> centers, std::vector<double> radii) {
  particles::ParticleSet set;
  set.centers = std::move(centers);
  set.radii = std::move(radii);
  set.has_box = true;
  for (double &edge : set.box_max) edge = 20;
  return set;
}

// The plane z = 10 cuts the first sphere 4 from its centre (5^2 = 3^2 + 4^2), the second in the middle, not the third,
// and touches the fourth.
particles::ParticleSet four_spheres() { return boxed({8, 9, 6, 3, 4, 10, 15, 15, 12, 15, 4, 11}, {5, 0.5, 1, 1}); }

bool disks_of_a_plane() {
  const draw::Slice slice = draw::cut(four_spheres(), {{2, 1, 3}, {10, 5, 1}}, 2, 0.5);
  if (slice.disks.size() != 2 || slice.position != 10) return false;
  const draw::Disk &large = slice.disks[0], &small = slice.disks[1];
  return large.u == 8 && large.v == 9 && large.radius == 3 && large.sphere_radius == 5 && large.level == 1 &&
         small.u == 3 && small.v == 4 && small.radius == 0.5 && small.level == 0;
}

bool planes_of_all_axes() {
  const particles::ParticleSet set = boxed({10, 2, 3}, {1});
  const draw::Slice x = draw::cut(set, kTwoLevels, 0, 0.5);
  const draw::Slice y = draw::cut(set, kTwoLevels, 1, 0.1);
  return x.disks.size() == 1 && x.disks[0].u == 2 && x.disks[0].v == 3 && y.disks.size() == 1 && y.disks[0].u == 10 &&
         y.disks[0].v == 3;
}

// A sphere in a corner of a periodic box shows in all four corners, and a plane at the bottom cuts what hangs over the
// top.
bool periodic_images() {
  particles::ParticleSet set = boxed({0.5, 19.5, 19.5}, {1});
  if (!draw::cut(set, kTwoLevels, 2, 0).disks.empty()) return false;
  for (int &axis : set.periodic) axis = 1;
  const draw::Slice slice = draw::cut(set, kTwoLevels, 2, 0);
  return slice.disks.size() == 4 && std::fabs(slice.disks[0].radius - std::sqrt(0.75)) < 1e-15;
}

bool two_dimensions() {
  particles::ParticleSet set;
  set.dimension = 2;
  set.centers = {1, 2, 5, 6};
  set.radii = {1, 3};
  const draw::Slice slice = draw::cut(set, kTwoLevels, 2, 0.5);
  return slice.disks.size() == 2 && slice.disks[0].radius == 3 && slice.box.u == 0 && slice.box.v == 1 &&
         slice.box.width == 8 && slice.box.height == 8;
}

size_t count_of(const std::string &text, const std::string &part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) count++;
  return count;
}

// One circle per disk and panel that shows it, one per level in the legend.
bool picture() {
  const draw::Slice slice = draw::cut(four_spheres(), {{2, 1, 3}, {10, 5, 1}}, 2, 0.5);
  const std::string picture = draw::slice_picture(slice);
  const size_t circles = count_of(picture, "<circle");
  return circles >= 2 + 2 && circles <= 2 + 2 + 2 + 1 && count_of(picture, "<svg") == 1 &&
         count_of(picture, "</svg>") == 1 && count_of(picture, "<g ") == count_of(picture, "</g>");
}

// Disks in a square lattice, more than the picture takes.
bool many_disks_are_cropped() {
  particles::ParticleSet set;
  set.dimension = 2;
  for (int i = 0; i < 150 * 150; i++) {
    set.centers.push_back(i % 150);
    set.centers.push_back(static_cast<double>(i / 150));
    set.radii.push_back(0.4);
  }
  const std::string whole = draw::slice_picture(draw::cut(set, {{0.8, 0.4, set.count()}}, 2, 0.5));
  const size_t circles = count_of(whole, "<circle");
  return circles > 10000 && circles < 20500 && count_of(whole, "middle of the box") == 1 &&
         count_of(whole, "80 % of its width") == 1;
}

bool svg_text() {
  draw::Svg svg(10, 10);
  svg.text({1, 2.5}, "a < b & c", 11);
  return svg.document().find("x=\"1\" y=\"2.5\"") != std::string::npos &&
         svg.document().find("a &lt; b &amp; c") != std::string::npos;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<disks_of_a_plane>),
      cmocka_unit_test(passes<planes_of_all_axes>),
      cmocka_unit_test(passes<periodic_images>),
      cmocka_unit_test(passes<two_dimensions>),
      cmocka_unit_test(passes<picture>),
      cmocka_unit_test(passes<svg_text>),
      cmocka_unit_test(passes<many_disks_are_cropped>),
  };
  return cmocka_run_group_tests_name("slice", tests, nullptr, nullptr);
}
