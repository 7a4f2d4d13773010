// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Contestants that call the public C interface.
#include "programs/bench/library_searches.hpp"

#include "particles/insert.hpp"
#include "programs/bench/child.hpp"
#include "programs/measure/search_timer.hpp"
#include "programs/measure/step_timer.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

namespace bench {
namespace {

// Known to the library, in the order in which it tries them.
constexpr const char *kInstructionSets[] = {"avx512", "avx2", "neon", "sse2", "scalar"};
constexpr const char *kIsaVariable = "HGRID_ISA";

bool usable(const char *isa) {
  Child probe("instruction set", [isa](Channel &channel) {
    setenv(kIsaVariable, isa, 1);
    hg_status status = HG_OK;
    try {
      const double center[3] = {}, radius = 1;
      hgrid::Grid grid;
      grid.insert(1, center, &radius);
      grid.build();
    } catch (const hgrid::Error &error) {
      status = error.status();
    }
    channel.send(status);
  });
  const hg_status status = probe.channel().receive<hg_status>();
  probe.wait();
  return status == HG_OK;
}

hg_grid_def def_of(const LibrarySetting &setting, const particles::ParticleSet &set) {
  hg_grid_def def = measure::def_of(set);
  def.thread_count = setting.threads;
  def.pair_order = setting.by_id ? HG_ORDER_ID : HG_ORDER_GRID;
  def.level_rule = setting.levels_of_paper ? HG_LEVELS_PAPER : HG_LEVELS_AUTO;
  def.level_count = setting.level_count;
  if (setting.accuracy == Accuracy::kDouble) def.accuracy = HG_DOUBLE;
  if (setting.accuracy == Accuracy::kFloat) def.accuracy = HG_FLOAT;
  return def;
}

std::string variant_of(const LibrarySetting &setting) {
  std::string text = setting.by_id ? "id" : "grid";
  text += setting.accuracy == Accuracy::kExact    ? "-exact"
          : setting.accuracy == Accuracy::kDouble ? "-double"
                                                  : "-float";
  if (setting.levels_of_paper) text += "-paper";
  if (setting.level_count > 0) text += "-L" + std::to_string(setting.level_count);
  return text;
}

Details details_of(hgrid::Grid &grid, size_t count) {
  Details details;
  const hgrid::View<hg_level> levels = grid.query_levels();
  details.levels = static_cast<double>(levels.size());
  for (const hg_level &level : levels) details.occupancy = std::max(details.occupancy, level.occupancy);
  const std::optional<hg_level_cost> cost = measure::expected_cost(grid, levels.size());
  if (cost) details.predicted_cost = cost->cost;
  details.candidates = static_cast<double>(grid.get_stats().candidate_count) / static_cast<double>(count);
  return details;
}

Contestant contestant_of(const LibrarySetting &setting) {
  Contestant contestant;
  contestant.name = kLibrary;
  contestant.variant = variant_of(setting);
  contestant.isa = setting.isa;
  contestant.threads = setting.threads;
  contestant.accuracy = setting.accuracy;
  return contestant;
}

}  // namespace

std::vector<std::string> usable_instruction_sets() {
  const char *wanted = std::getenv(kIsaVariable);
  if (wanted != nullptr && *wanted != '\0') return {wanted};
  std::vector<std::string> sets;
  for (const char *isa : kInstructionSets) {
    if (usable(isa)) sets.emplace_back(isa);
  }
  return sets;
}

Contestant library_search(const LibrarySetting &setting) {
  Contestant contestant = contestant_of(setting);
  contestant.prepare = [setting](const particles::ParticleSet &set) {
    auto timer = std::make_shared<measure::SearchTimer>(def_of(setting, set), set);
    Search search;
    search.run = [timer](PairView &pairs) {
      timer->run();
      pairs = timer->pairs();
      return timer->seconds().back();
    };
    search.details = [timer, count = set.count()] { return details_of(timer->grid(), count); };
    return search;
  };
  return contestant;
}

Contestant library_steps(const LibrarySetting &setting, double skin, int steps, double longest_step) {
  Contestant contestant = contestant_of(setting);
  contestant.prepare = [=](const particles::ParticleSet &set) {
    hg_grid_def def = def_of(setting, set);
    def.skin = skin;
    auto grid = std::make_shared<measure::MovingGrid>(def, set);
    auto searches = std::make_shared<double>(0);
    Search search;
    search.run = [=, &set](PairView &pairs) {
      measure::Flight flight(set, longest_step);
      grid->start_at(set);  // every run begins with candidates that have just been stored
      const auto searched_before = grid->grid().get_stats().search_count;
      double seconds = 0;
      for (int k = 0; k < steps; k++) {
        flight.step();
        seconds += measure::seconds_of([&] { grid->step(flight.particles()); });
      }
      pairs = grid->pairs();
      *searches = static_cast<double>(grid->grid().get_stats().search_count - searched_before) / steps;
      return seconds / steps;
    };
    search.details = [=, count = set.count()] {
      Details details = details_of(grid->grid(), count);
      details.searches_per_step = *searches;
      return details;
    };
    return search;
  };
  return contestant;
}

particles::ParticleSet moved(const particles::ParticleSet &set, int steps, double longest_step) {
  measure::Flight flight(set, longest_step);
  for (int k = 0; k < steps; k++) flight.step();
  return flight.particles();
}

std::vector<double> cell_sizes_of_paper(const particles::ParticleSet &set, int level_count) {
  LibrarySetting setting;
  setting.levels_of_paper = true;
  setting.level_count = level_count;
  hgrid::Grid grid(def_of(setting, set));
  particles::insert(set, grid);
  std::vector<double> sizes;
  for (const hg_level &level : grid.query_levels()) sizes.push_back(level.cell_size);
  return sizes;
}

}  // namespace bench
