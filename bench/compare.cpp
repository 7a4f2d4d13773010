// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// hgrid_compare: times the library against the classical linked-cell search on a particle file and checks that all find
// the same pairs. Exit code 0 only if they do.
#include "hierarchical_grid.hpp"
#include "linked_cell.hpp"
#include "measure/search_timer.hpp"
#include "output.hpp"
#include "pair_sets.hpp"
#include "particles/reader.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Options {
  std::string file;
  int repeats = 7;
  int baseline_repeats = 1;
  int threads = 1;
  std::string csv;
};

struct Row {
  std::string name;
  int repeats = 1;
  std::size_t levels = 1;
  double candidates = 0;  // per particle
  std::vector<double> seconds;
  std::vector<hg_pair> pairs;  // sorted
  std::function<void(Row &)> run;

  double median_seconds() const { return measure::median(seconds); }
};

bench::Particles view(const app::ParticleSet &set) { return {set.count(), set.centers.data(), set.radii.data()}; }

// A row for one of the plain searches of this folder.
template <class Search>
Row baseline_row(const std::string &name, int repeats, const app::ParticleSet &set, std::size_t levels, Search search) {
  Row row;
  row.name = name;
  row.repeats = repeats;
  row.levels = levels;
  row.run = [&set, search](Row &self) {
    std::vector<hg_pair> pairs;
    std::int64_t tested = 0;
    self.seconds.push_back(measure::seconds_of([&] { pairs = search(&tested); }));
    self.candidates = static_cast<double>(tested) / static_cast<double>(set.count());
    self.pairs = bench::sorted(pairs.data(), pairs.size());
  };
  return row;
}

// A row for the library; `timer` is shared because std::function copies.
Row library_row(const std::string &name, int repeats, const app::ParticleSet &set, const hg_grid_def &def) {
  Row row;
  row.name = name;
  row.repeats = repeats;
  auto timer = std::make_shared<measure::SearchTimer>(def, set);
  row.run = [&set, timer](Row &self) {
    timer->run();
    self.seconds = timer->seconds();
    self.pairs = bench::sorted(timer->pairs().data, timer->pairs().count);
    self.levels = timer->grid().levels().count;
    self.candidates = static_cast<double>(timer->grid().stats().candidate_count) / static_cast<double>(set.count());
  };
  return row;
}

hg_grid_def library_def(const app::ParticleSet &set, int threads, std::int32_t rule, std::int32_t level_count) {
  hg_grid_def def = measure::def_of(set);
  def.thread_count = threads;
  def.level_rule = rule;
  def.level_count = level_count;
  return def;
}

std::vector<double> cell_sizes_of_paper(const app::ParticleSet &set) {
  app::Grid grid(library_def(set, 1, HG_LEVELS_PAPER, 0));
  grid.insert(set);
  std::vector<double> sizes;
  for (const hg_level &level : grid.levels()) sizes.push_back(level.cell_size);
  return sizes;
}

std::vector<Row> make_rows(const Options &options, const app::ParticleSet &set) {
  const int repeats = options.repeats;
  const std::vector<double> sizes = cell_sizes_of_paper(set);
  std::vector<Row> rows;
  rows.push_back(baseline_row("classical linked cells", options.baseline_repeats, set, 1, [&set](std::int64_t *tested) {
    return bench::linked_cell_pairs(set.dimension, view(set), tested);
  }));
  rows.push_back(
      baseline_row("plain hierarchical grid", repeats, set, sizes.size(), [&set, sizes](std::int64_t *tested) {
        return bench::hierarchical_grid_pairs(set.dimension, view(set), sizes, tested);
      }));
  rows.push_back(library_row("library, one level", options.baseline_repeats, set,
                             library_def(set, options.threads, HG_LEVELS_PAPER, 1)));
  rows.push_back(
      library_row("library, levels of the paper", repeats, set, library_def(set, options.threads, HG_LEVELS_PAPER, 0)));
  rows.push_back(
      library_row("library, levels chosen", repeats, set, library_def(set, options.threads, HG_LEVELS_AUTO, 0)));
  return rows;
}

// Round after round over all rows, so that a slow moment of the machine touches all alike.
void run_rows(std::vector<Row> &rows) {
  for (int round = 0;; ++round) {
    bool any = false;
    for (Row &row : rows) {
      if (round >= row.repeats) continue;
      row.run(row);
      any = true;
    }
    if (!any) return;
  }
}

double ns_per_particle(const Row &row, const app::ParticleSet &set) {
  return 1e9 * row.median_seconds() / static_cast<double>(set.count());
}

void print_rows(const Options &options, const app::ParticleSet &set, const std::vector<Row> &rows) {
  std::printf("%s: %zu particles, %zu pairs\n", options.file.c_str(), set.count(), rows.back().pairs.size());
  std::printf("from double arrays in memory to the complete pair list; library threads: %s; median of the runs\n\n",
              options.threads == 0 ? "all" : std::to_string(options.threads).c_str());
  std::printf("%-30s %6s %14s %12s %14s %5s\n", "search", "levels", "candidates per", "ns per", "times faster", "runs");
  std::printf("%-30s %6s %14s %12s %14s\n", "", "", "particle", "particle", "than classical");
  const double classical = ns_per_particle(rows.front(), set);
  for (const Row &row : rows) {
    const double ns = ns_per_particle(row, set);
    std::printf("%-30s %6zu %14.1f %12.1f %14.1f %5zu\n", row.name.c_str(), row.levels, row.candidates, ns,
                classical / ns, row.seconds.size());
  }
  std::printf("\n");
}

void write_csv(const Options &options, const app::ParticleSet &set, const std::vector<Row> &rows) {
  app::Output out(options.csv);
  out << "search,levels,candidates_per_particle,median_ns_per_particle,runs,pairs\n";
  for (const Row &row : rows) {
    out << '"' << row.name << '"' << ',' << row.levels << ',' << row.candidates << ',' << ns_per_particle(row, set)
        << ',' << row.seconds.size() << ',' << row.pairs.size() << '\n';
  }
  out.close();
}

// Exact arithmetic may decide otherwise than the plain doubles of the baselines where particles touch within rounding,
// nowhere else.
bool same_pairs_but_for_rounding(const app::ParticleSet &set, const std::vector<Row> &rows) {
  bool good = true;
  std::size_t rounded = 0;
  for (const Row &row : rows) {
    const std::vector<hg_pair> odd = bench::differences(rows.front().pairs, row.pairs);
    const auto touch = [&set](const hg_pair &pair) { return bench::touch_within_rounding(set, pair); };
    const std::size_t excused = static_cast<std::size_t>(std::count_if(odd.begin(), odd.end(), touch));
    rounded = std::max(rounded, excused);
    if (excused == odd.size()) continue;
    std::printf("%s: %zu pairs differ from the classical search\n", row.name.c_str(), odd.size() - excused);
    good = false;
  }
  if (good && rounded == 0) std::printf("all searches find the same pairs\n");
  if (good && rounded > 0) {
    std::printf(
        "all searches find the same pairs, but for %zu that touch within rounding: there the library decides\n"
        "exactly, the plain searches as doubles do\n",
        rounded);
  }
  return good;
}

// HG_DOUBLE promises the very predicate of the baselines: no difference is allowed at all.
bool same_pairs_in_doubles(const Options &options, const app::ParticleSet &set, const Row &classical) {
  hg_grid_def def = library_def(set, options.threads, HG_LEVELS_AUTO, 0);
  def.accuracy = HG_DOUBLE;
  app::Grid grid(def);
  grid.insert(set);
  const app::Borrowed<hg_pair> pairs = grid.pairs();
  const std::size_t odd = bench::differences(classical.pairs, bench::sorted(pairs.data, pairs.count)).size();
  if (odd == 0) {
    std::printf("asked to decide as doubles do (HG_DOUBLE), the library finds the %zu pairs of the classical search\n",
                pairs.count);
  } else {
    std::printf("library with HG_DOUBLE: %zu pairs differ from the classical search\n", odd);
  }
  return odd == 0;
}

int compare(const Options &options) {
  app::ParticleSet set = app::read_particles(options.file);
  if (set.count() == 0) throw app::Error(options.file, 0, "no particles to time");
  // The baselines know open axes only.
  for (int &periodic : set.periodic) periodic = 0;
  std::vector<Row> rows = make_rows(options, set);
  run_rows(rows);
  print_rows(options, set, rows);
  if (!options.csv.empty()) write_csv(options, set, rows);
  const bool exact_good = same_pairs_but_for_rounding(set, rows);
  const bool double_good = same_pairs_in_doubles(options, set, rows.front());
  if (!exact_good || !double_good) {
    std::fprintf(stderr, "hgrid_compare: the searches do not find the same pairs\n");
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char **argv) {
  CLI::App command("Time the contact search of libhgrid against the classical linked-cell search");
  Options options;
  command.add_option("FILE", options.file, "Particle file (all axes are taken as open)")->required();
  command.add_option("--repeats", options.repeats, "Runs of the fast searches")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_option("--baseline-repeats", options.baseline_repeats, "Runs of the searches with one level")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_option("--threads", options.threads, "Threads of the library, 0 = all")->capture_default_str();
  command.add_option("--csv", options.csv, "Also write the table to this file");
  CLI11_PARSE(command, argc, argv);
  try {
    return compare(options);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "hgrid_compare: %s\n", error.what());
    return 1;
  }
}
