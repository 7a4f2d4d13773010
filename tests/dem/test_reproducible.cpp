// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The same bits: for any number of threads, any skin, whoever looks, and through a checkpoint.
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

namespace {

constexpr uint64_t kSeed = 11;

// Everything that pairs and walls can do, in a box with walls at the ends of z only.
dem::Setup busy_setup(int dimension) {
  bodies::Gas gas;
  gas.dimension = dimension;
  gas.edge = dimension == 3 ? 7 : 20;
  gas.spacing = 2.02;
  gas.temperature = 4;
  gas.effects = dem::kDissipation | dem::kFriction | dem::kRolling | dem::kGravity;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact.restitution = 0.8;
  setup.contact.friction = 0.4;
  setup.contact.tangential_stiffness = 2.0 / 7;
  setup.contact.rolling_friction = 0.1;
  setup.contact.rolling_stiffness = 2.0 / 7;
  setup.gravity[dimension - 1] = -3;
  bodies::set_periodic(setup, 0, setup.box_min[0], setup.box_max[0]);
  bodies::set_walls(setup, dimension - 1, setup.box_min[dimension - 1], setup.box_max[dimension - 1]);
  bodies::set_steps_per_contact(setup, 50);
  return setup;
}

dem::Snapshot state_after(
    const dem::Setup &setup, uint64_t steps,
    const std::function<void(dem::Engine &)> &meanwhile = [](dem::Engine &) {}) {
  const auto engine = dem::make_engine(setup);
  engine->run(steps / 2);
  meanwhile(*engine);
  engine->run(steps - steps / 2);
  return engine->snapshot();
}

bool same_bits(const std::vector<double> &a, const std::vector<double> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool same_bits(const dem::Snapshot &a, const dem::Snapshot &b) {
  return same_bits(a.centers, b.centers) && same_bits(a.velocities, b.velocities) && same_bits(a.spins, b.spins);
}

bool same_with_threads(int dimension) {
  dem::Setup setup = busy_setup(dimension);
  const dem::Snapshot alone = state_after(setup, 300);
  bool same = true;
  for (const int threads : {2, 3}) {
    setup.threads = threads;
    same = same && same_bits(alone, state_after(setup, 300));
  }
  return same;
}

void threads_do_not_change_a_bit(void **) {
  assert_true(same_with_threads(2));
  assert_true(same_with_threads(3));
}

// Among spheres of three sizes, two of them faster than all others.
dem::Setup mixed_setup() {
  dem::Setup setup = busy_setup(3);
  for (size_t i = 0; i < setup.count(); i++) setup.radii[i] *= i % 3 == 0 ? 1 : i % 3 == 1 ? 0.5 : 0.2;
  for (size_t k = 0; k < 3; k++) setup.velocities[3 * 20 + k] = setup.velocities[3 * 100 + k] = 30;
  return setup;
}

dem::Setup growing_setup() {
  dem::Setup setup = busy_setup(3);
  setup.effects |= dem::kGrowth;
  setup.growth_rate = 0.05;
  setup.growth_end = 0.5;
  return setup;
}

dem::Setup sheared_setup() {
  bodies::Gas gas;
  gas.edge = 6;
  gas.spacing = 2.02;
  return bodies::make_sheared_gas(gas, 1.5, kSeed);
}

bool same_with_skins(dem::Setup setup) {
  const dem::Snapshot without = state_after(setup, 300);
  bool same = true;
  for (const double skin : {0.01, 0.2, 1.0}) {
    setup.skin = skin;
    same = same && same_bits(without, state_after(setup, 300));
  }
  return same;
}

void the_skin_does_not_change_a_bit(void **) {
  assert_true(same_with_skins(busy_setup(3)));
  assert_true(same_with_skins(busy_setup(2)));
  assert_true(same_with_skins(mixed_setup()));
  assert_true(same_with_skins(growing_setup()));
  assert_true(same_with_skins(sheared_setup()));
}

// Narrower vectors than the machine has, and none.
bool same_with_vectors(dem::Setup setup) {
  setup.skin = 0.2;
  const dem::Snapshot widest = state_after(setup, 300);
  bool same = true;
  for (const char *set : {"avx2", "sse2"}) {
    setenv("HGRID_ISA", set, 1);
    same = same && same_bits(widest, state_after(setup, 300));
  }
  unsetenv("HGRID_ISA");
  return same;
}

void vectors_do_not_change_a_bit(void **) {
  for (const int dimension : {2, 3}) assert_true(same_with_vectors(busy_setup(dimension)));
  assert_true(same_with_vectors(mixed_setup()));
}

// Candidates last for many steps, and a fast particle is met by those it reaches.
void a_skin_saves_searches(void **) {
  dem::Setup setup = busy_setup(3);
  setup.skin = 0.2;
  const auto engine = dem::make_engine(setup);
  engine->run(300);
  const auto searches = engine->grid_stats().search_count;
  std::printf("%lld searches in 300 steps\n", static_cast<long long>(searches));
  assert_true(searches > 1 && searches < 100);
}

bool same_with_levels() {
  dem::Setup setup = busy_setup(3);
  for (size_t i = 0; i < setup.count(); i++) setup.radii[i] *= i % 3 == 0 ? 1 : i % 3 == 1 ? 0.5 : 0.2;
  const dem::Snapshot chosen = state_after(setup, 300);
  bool same = true;
  for (const int count : {1, 2, 3}) {
    setup.level_count = count;
    const auto has_as_many = [&](dem::Engine &engine) { same = same && engine.grid_stats().level_count == count; };
    same = same && same_bits(chosen, state_after(setup, 300, has_as_many));
  }
  return same;
}

void the_number_of_levels_does_not_change_a_bit(void **) { assert_true(same_with_levels()); }

void levels_below_none_are_refused(void **) {
  dem::Setup setup = busy_setup(2);
  setup.level_count = -1;
  assert_true(test::error_of([&] { dem::make_engine(setup); }) == "the number of levels is -1, below 0");
}

bool same_when_looked_at() {
  const dem::Setup setup = busy_setup(3);
  const dem::Snapshot undisturbed = state_after(setup, 300);
  return same_bits(undisturbed, state_after(setup, 300, [](dem::Engine &engine) {
                     engine.measure();
                     engine.snapshot();
                     engine.measure();
                   }));
}

void looking_does_not_change_a_bit(void **) { assert_true(same_when_looked_at()); }

std::string checkpoint_path() {
  return (std::filesystem::temp_directory_path() / ("hgrid-test-checkpoint-" + std::to_string(kSeed))).string();
}

// `look`: the forces are known when the checkpoint is made.
bool same_through_checkpoint(const dem::Setup &setup, bool look) {
  const auto first = dem::make_engine(setup);
  first->run(151);
  if (look) first->measure();
  dem::Checkpoint saved;
  first->save(saved);
  saved.write(checkpoint_path());
  first->run(149);
  const auto second = dem::make_engine(setup);
  second->run(10);  // what it did before must not matter
  second->restore(dem::Checkpoint::read(checkpoint_path()));
  if (second->steps_done() != 151) return false;
  second->run(149);
  const bool same = same_bits(first->snapshot(), second->snapshot());
  std::filesystem::remove(checkpoint_path());
  return same;
}

void restart_goes_on_to_the_same_bits(void **) {
  dem::Setup setup = busy_setup(3);
  assert_true(same_through_checkpoint(setup, false));
  assert_true(same_through_checkpoint(setup, true));
  setup.skin = 0.2;
  setup.threads = 2;
  assert_true(same_through_checkpoint(setup, false));
  dem::Setup growing = busy_setup(2);
  growing.effects |= dem::kGrowth;
  growing.growth_rate = 0.01;
  assert_true(same_through_checkpoint(growing, true));
}

std::string restore_error(const dem::Setup &saved, const dem::Setup &restored) {
  dem::Checkpoint checkpoint;
  dem::make_engine(saved)->save(checkpoint);
  return test::error_of([&] { dem::make_engine(restored)->restore(checkpoint); });
}

void checkpoints_of_other_scenes_are_refused(void **) {
  const dem::Setup setup = busy_setup(3);
  dem::Setup other = setup;
  other.time_step *= 0.5;
  assert_true(restore_error(setup, other).find("time step") != std::string::npos);
  other = setup;
  other.effects &= ~static_cast<unsigned>(dem::kRolling);
  assert_true(restore_error(setup, other).find("rolling") != std::string::npos);
  assert_true(restore_error(setup, busy_setup(2)).find("2 in") != std::string::npos);
  assert_true(restore_error(setup, setup).empty());
}

std::string damage_error(size_t at) {
  dem::Checkpoint checkpoint;
  dem::make_engine(busy_setup(2))->save(checkpoint);
  checkpoint.write(checkpoint_path());
  {
    std::fstream file(checkpoint_path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(at));
    file.put('!');
  }
  const std::string what = test::error_of([] { dem::Checkpoint::read(checkpoint_path()); });
  std::filesystem::remove(checkpoint_path());
  return what;
}

void damaged_checkpoints_are_refused(void **) {
  assert_true(damage_error(2).find("no checkpoint") != std::string::npos);
  assert_true(damage_error(500).find("damaged") != std::string::npos);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(threads_do_not_change_a_bit),
      cmocka_unit_test(the_skin_does_not_change_a_bit),
      cmocka_unit_test(vectors_do_not_change_a_bit),
      cmocka_unit_test(a_skin_saves_searches),
      cmocka_unit_test(the_number_of_levels_does_not_change_a_bit),
      cmocka_unit_test(levels_below_none_are_refused),
      cmocka_unit_test(looking_does_not_change_a_bit),
      cmocka_unit_test(restart_goes_on_to_the_same_bits),
      cmocka_unit_test(checkpoints_of_other_scenes_are_refused),
      cmocka_unit_test(damaged_checkpoints_are_refused),
  };
  return cmocka_run_group_tests_name("reproducible", tests, nullptr, nullptr);
}
