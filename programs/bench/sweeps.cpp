// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The lists of contestants and systems.
#include "programs/bench/sweeps.hpp"

#include "programs/bench/child.hpp"
#include "programs/bench/library_searches.hpp"
#include "programs/bench/machine.hpp"
#include "programs/bench/peer_searches.hpp"
#include "programs/bench/plain_searches.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <utility>

namespace bench {
namespace {

using Isas = std::vector<std::string>;

constexpr int kMostLevels = 12;
// Two searches in a run with the largest skin, whose candidates hold for a hundred steps.
constexpr int kStepsPerRun = 250;
// Of the smallest radius. In simulations of hard particles a step is a small part of a collision, so this is fast.
constexpr double kStepLength = 2e-3;

LibrarySetting setting(const Isas &isas, int threads) {
  LibrarySetting result;
  result.isa = isas.front();
  result.threads = threads;
  return result;
}

void append(std::vector<Contestant> &list, std::vector<Contestant> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<Contestant> everything(const System &system, const Isas &isas) {
  std::vector<Contestant> list;
  for (const std::string &isa : isas) {
    for (const int threads : {1, 2}) {
      for (const bool by_id : {false, true}) {
        for (const Accuracy accuracy : {Accuracy::kExact, Accuracy::kDouble, Accuracy::kFloat}) {
          LibrarySetting one;
          one.isa = isa;
          one.threads = threads;
          one.by_id = by_id;
          one.accuracy = accuracy;
          list.push_back(library_search(one));
        }
      }
    }
  }
  LibrarySetting paper = setting(isas, 1), one_level = setting(isas, 1);
  paper.levels_of_paper = true;
  one_level.level_count = 1;
  list.push_back(library_search(paper));
  list.push_back(library_search(one_level));
  list.push_back(linked_cell_search());
  list.push_back(hierarchical_grid_search(0));
  append(list, peer_searches(system.particles.dimension));
  return list;
}

std::vector<Contestant> main_contestants(const System &, const Isas &isas) {
  return {library_search(setting(isas, 1)), library_search(setting(isas, 2)), hierarchical_grid_search(0)};
}

std::vector<Contestant> with_classical(const System &system, const Isas &isas) {
  std::vector<Contestant> list = main_contestants(system, isas);
  list.push_back(linked_cell_search());
  return list;
}

// The numbers of levels that the sizes can be split into.
std::vector<int> reachable_levels(const System &system) {
  Child counter("levels", [&system](Channel &channel) {
    std::vector<int> reachable;
    for (int count = 1; count <= kMostLevels; count++) {
      const size_t reached = cell_sizes_of_paper(system.particles, count).size();
      if (reached == static_cast<size_t>(count)) reachable.push_back(count);
    }
    channel.send_array(reachable);
  });
  std::vector<int> reachable = counter.channel().receive_array<int>();
  counter.wait();
  return reachable;
}

std::vector<Contestant> each_level_count(const System &system, const Isas &isas) {
  std::vector<Contestant> list;
  for (const int count : reachable_levels(system)) {
    LibrarySetting one = setting(isas, 1);
    one.level_count = count;
    list.push_back(library_search(one));
    list.push_back(hierarchical_grid_search(count));
  }
  return list;
}

std::vector<Contestant> each_thread_count(const System &, const Isas &isas) {
  std::vector<Contestant> list;
  for (int threads = 1; threads <= processor_count(); threads = threads < 4 ? threads + 1 : 2 * threads) {
    list.push_back(library_search(setting(isas, threads)));
  }
  return list;
}

std::vector<Contestant> each_skin(const System &system, const Isas &isas) {
  const double unit = *std::min_element(system.particles.radii.begin(), system.particles.radii.end());
  std::vector<Contestant> list;
  for (const double skin : {0.0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4}) {
    list.push_back(library_steps(setting(isas, 1), skin * unit, kStepsPerRun, kStepLength * unit));
    list.back().skin = skin;
    list.back().variant += "-skin-" + std::to_string(skin).substr(0, 4);
  }
  return list;
}

std::vector<std::string> sources(const std::vector<std::string> &laws, const std::vector<std::string> &ends) {
  std::vector<std::string> list;
  for (const std::string &law : laws) {
    for (const std::string &end : ends) list.emplace_back(law).append(":").append(end);
  }
  return list;
}

std::vector<Sweep> make_sweeps() {
  const std::vector<std::string> paper_laws = {"mono:1:125001", "uniform-size:50:125001", "uniform-volume:10:125001",
                                               "uniform-volume:50:125001"};
  const std::vector<std::string> two_laws = {"mono:1", "uniform-volume:50"};
  std::vector<std::string> ratios;
  for (const char *ratio : {"1", "2", "5", "10", "20", "50", "100", "200", "500", "1000"}) {
    ratios.push_back(std::string(ratio) + ":1000000");
  }
  return {
      {"", "every contestant", {}, everything, 0, 0},
      {"size", "time against N",
       sources(two_laws, {"1000", "3000", "10000", "30000", "100000", "300000", "1000000", "3000000", "10000000"}),
       main_contestants, 0, 0},
      {"ratio", "time against the ratio of sizes", sources({"uniform-size", "uniform-volume"}, ratios), with_classical,
       0, 0},
      {"levels", "time against the number of levels", paper_laws, each_level_count, 0, 0},
      {"threads", "time against threads", sources(two_laws, {"125001", "1000000"}), each_thread_count, 0, 0},
      {"skin", "time of a step against the skin", sources(two_laws, {"125001"}), each_skin, kStepsPerRun, kStepLength},
  };
}

}  // namespace

const std::vector<Sweep> &all_sweeps() {
  static const std::vector<Sweep> sweeps = make_sweeps();
  return sweeps;
}

std::string key_of(const Contestant &contestant) {
  return contestant.name + '/' + contestant.variant + '/' + contestant.isa + '/' + std::to_string(contestant.threads);
}

std::vector<Contestant> chosen(std::vector<Contestant> all, const std::vector<std::string> &isas,
                               const std::vector<std::string> &only, const std::vector<std::string> &skip) {
  const auto matches = [&isas](const Contestant &contestant, const std::vector<std::string> &patterns) {
    Contestant by_rank = contestant;
    if (contestant.isa == isas.front()) by_rank.isa = "best";
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string &pattern) {
      return fnmatch(pattern.c_str(), key_of(contestant).c_str(), 0) == 0 ||
             fnmatch(pattern.c_str(), key_of(by_rank).c_str(), 0) == 0;
    });
  };
  const auto unwanted = [&](const Contestant &contestant) {
    return (!only.empty() && !matches(contestant, only)) || matches(contestant, skip);
  };
  all.erase(std::remove_if(all.begin(), all.end(), unwanted), all.end());
  return all;
}

}  // namespace bench
