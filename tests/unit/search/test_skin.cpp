// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which skin is usable: what was asked for, cut to what a periodic box allows, or none where it would not pay.
#include "src/search/skin.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"

#include <gmpxx.h>

#include <cmath>

namespace {

using namespace hgtest;

// Particles all over a box.
struct Setting {
  hg::Domain domain = open_space(3);
  hg::Interaction interaction;
  hg::Bounds bounds;
  size_t particles = 1000;
  int32_t accuracy = HG_EXACT;

  explicit Setting(double edge = 1) {
    for (int axis = 0; axis < 3; axis++) bounds.max[axis] = bounds.width[axis] = edge;
    bounds.max_radius = 0.02 * edge;
  }
  double usable(double wanted) const {
    return hg::usable_skin(wanted, interaction, domain, bounds, accuracy, particles);
  }
};

void require_skin(const char *what, double found, double expected) {
  require(found == expected, "%s: a skin of %g instead of %g", what, found, expected);
}

void check_what_pays(uint64_t) {
  Setting s;
  require_skin("as asked for", s.usable(0.1), 0.1);
  require_skin("none", s.usable(0), 0);
  require_skin("of a few quanta", s.usable(0x1p-26), 0);
  require_skin("of 128 quanta", s.usable(0x1p-22), 0x1p-22);
  // Wider than all: each particle has all others, half of which count for it.
  const size_t most = 2 * hg::kMostCandidatesPerParticle;
  s.particles = most;
  require_skin("as wide as all", s.usable(7), 1);
  s.particles = most + 1;
  require_skin("too many", s.usable(7), 0);
  s.particles = 8 * most;
  require_skin("half as wide", s.usable(0.5), 0.5);
  // Every particle in one place: nothing to move within.
  s.bounds = {};
  s.bounds.max_radius = 1;
  require_skin("no extent", s.usable(1), 0);
}

// Where the plain expression of HG_DOUBLE under- or overflows, nothing may be taken for clear.
void check_scales(uint64_t) {
  for (const double edge : {1e-200, 1e-130, 1.0, 1e130, 1e200}) {
    Setting s(edge);
    require_skin("exact", s.usable(0.1 * edge), 0.1 * edge);
    s.accuracy = HG_DOUBLE;
    const bool clear = edge > 1e-150 && edge < 1e150;
    require_skin("plain expression", s.usable(0.1 * edge), clear ? 0.1 * edge : 0);
  }
  Setting huge(1e308);
  huge.bounds.max_radius = 1e308;
  require_skin("a reach that overflows", huge.usable(1e307), 0);
}

// The wider reach is still at most half the box.
void check_periodic(uint64_t seed) {
  Rng rng(seed);
  Setting s;
  s.particles = 100;
  s.interaction = {rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE, rng.chance(0.5) ? 0 : 0.02};
  s.bounds.max_radius = rng.uniform(0.01, 0.25);
  double least = HUGE_VAL;
  for (int axis = 0; axis < 3; axis++) {
    const double length = std::pow(2, rng.uniform(0, 2));
    set_box(s.domain, axis, 0, length, rng.chance(0.7));
    s.bounds.max[axis] = s.bounds.width[axis] = length;
    if (s.domain.periodic[axis]) least = std::fmin(least, length);
  }
  const double wanted = rng.uniform(), skin = s.usable(wanted);
  const double room = 0.5 * least - s.interaction.diameter(s.bounds.max_radius);
  if (wanted < 0.999 * room) require_skin("room enough", skin, wanted);
  if (wanted <= room || room < 1e-6) return;
  require(skin < room && skin > 0.999 * room, "a skin of %g where the box leaves %g", skin, room);
  const hg::Interaction wide = s.interaction.widened(skin);
  const mpq_class radius(s.bounds.max_radius), margin(wide.margin);
  const mpq_class reach = (wide.kind == HG_CONTACT ? 2 * radius : radius) + margin;
  require(2 * reach <= mpq_class(least), "twice the reach %g is more than the box %g", reach.get_d(), least);
}

void what_pays(void **) { assert_true(holds(0, check_what_pays)); }
void scales(void **) { assert_true(holds(0, check_scales)); }
void periodic_boxes(void **) { assert_true(sweep(500, check_periodic)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(what_pays), cmocka_unit_test(scales), cmocka_unit_test(periodic_boxes)};
  return cmocka_run_group_tests_name("skin", tests, nullptr, nullptr);
}
