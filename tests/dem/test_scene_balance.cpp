// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The energy balance of every scene that comes with the program, but for those whose packings take minutes.
#include "dem/engine/engine.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/shipped.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

// A part of the run, as long as the test can wait for: some way in, where things happen, and then counted.
struct Part {
  uint64_t before, counted;
};

Part part_of(const scene::Scene &scene) {
  const double particles = static_cast<double>(scene.setup.count());
  const auto steps = [&](double of_particles) { return static_cast<uint64_t>(std::ceil(of_particles / particles)); };
  const uint64_t before = std::min(scene.steps / 5, steps(2e7));
  return {before, std::min(scene.steps - before, steps(1.6e6))};
}

// A collision of n steps errs by up to 0.52 n^-2 of its energy, to either side (accuracy-simulation.md). So does a
// contact that is pressed on and let go; adding up all as if they were of one sign is five times as much at most here.
double bound_of(const scene::Scene &scene) {
  const double steps = scene.shortest_contact / scene.setup.time_step;
  return 5 * 0.52 / (steps * steps);
}

bool is_balanced(const std::string &path) {
  scene::Scene scene = scene::read_scene(path);
  // Who comes and goes takes energy along, so no work is counted then: nobody goes here, and where somebody comes there
  // is nothing to look at.
  if (!scene.setup.inflows.empty()) return true;
  scene.setup.removals.clear();
  const Part part = part_of(scene);
  const auto engine = dem::make_engine(scene.setup, scene.precision);
  engine->run(part.before);
  engine->count_work();
  const dem::Measurement start = engine->measure();
  double worst = 0, scale = 0;
  constexpr uint64_t kLooks = 20;
  for (uint64_t look = 0; look < kLooks; look++) {
    engine->run(std::max<uint64_t>(1, part.counted / kLooks));
    const dem::Measurement m = engine->measure();
    worst = std::max(worst, std::fabs(m.balance() - start.balance()));
    scale = std::max(scale, m.translation + m.rotation + m.work.dissipated() + std::fabs(m.work.input));
  }
  const dem::Work work = engine->measure().work;
  std::printf("%-22s %7llu steps: off by %.1e of what moves (bound %.1e); taken %.2e, put in %.2e\n",
              std::filesystem::path(path).stem().string().c_str(), static_cast<unsigned long long>(part.counted),
              worst / scale, bound_of(scene), work.dissipated() / scale, work.input / scale);
  return worst < bound_of(scene) * scale;
}

void scenes_close_their_balance(void **) {
  int looked = 0;
  for (const scene::Entry &entry : scene::scenes_in(HGRID_SCENES)) {
    if (std::filesystem::path(entry.path).stem().string().compare(0, 6, "paper-") == 0) continue;
    assert_true(is_balanced(entry.path));
    looked++;
  }
  assert_true(looked >= 8);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(scenes_close_their_balance)};
  return cmocka_run_group_tests_name("balance of scenes", tests, nullptr, nullptr);
}
