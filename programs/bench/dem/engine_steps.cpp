// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The engine of `hgrid run` as a contestant.
#include "dem/engine/engine.hpp"
#include "programs/bench/dem/stepper.hpp"
#include "programs/bench/library_searches.hpp"

#include <algorithm>
#include <memory>

namespace bench {
namespace {

// Levels, what they hold and what is expected of them, from a grid with the same settings.
Details details_of(const dem::Setup &setup, const StepSetting &setting) {
  particles::ParticleSet set;
  set.dimension = setup.dimension;
  set.centers = setup.centers;
  set.radii = setup.radii;
  LibrarySetting library;
  library.by_id = true;
  library.level_count = setting.level_count;
  const Search search = library_search(library).prepare(set);
  PairView pairs;
  search.run(pairs);
  return search.details();
}

}  // namespace

StepContestant engine_steps(const StepSetting &setting, const std::string &isa) {
  StepContestant contestant;
  contestant.name = "library";
  contestant.isa = isa;
  contestant.threads = setting.threads;
  contestant.skin = setting.skin;
  contestant.tuned = setting.tuned;
  if (setting.level_count > 0) contestant.variant = "L" + std::to_string(setting.level_count);
  contestant.prepare = [setting](const dem::Setup &given) {
    dem::Setup setup = given;
    setup.threads = setting.threads;
    setup.skin = setting.skin * *std::min_element(setup.radii.begin(), setup.radii.end());
    setup.level_count = setting.level_count;
    const std::shared_ptr<dem::Engine> engine = dem::make_engine(setup);
    Stepper stepper;
    stepper.run = [engine](uint64_t steps) { engine->run(steps); };
    stepper.state = [engine] {
      dem::Snapshot now = engine->snapshot();
      return MotionState{std::move(now.centers), std::move(now.velocities)};
    };
    stepper.details = [engine, setup, setting] {
      Details details = details_of(setup, setting);
      const hg_grid_stats stats = engine->grid_stats();
      details.levels = static_cast<double>(stats.level_count);
      details.searches_per_step = static_cast<double>(stats.search_count) / static_cast<double>(engine->steps_done());
      return details;
    };
    return stepper;
  };
  return contestant;
}

}  // namespace bench
