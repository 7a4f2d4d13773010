// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid pairs: the contacts of a particle file, written as CSV or counted.
#include "particles/text/lists.hpp"
#include "particles/text/output.hpp"
#include "particles/text/progress.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"
#include "programs/measure/timing.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace command {
namespace {

struct PairsOptions {
  ParticleOptions particles;
  GridOptions grid;
  std::string output = "-";
  std::vector<std::string> columns = {"place"};
  bool count_only = false;
};

// From a to the image of b that it meets.
struct Meeting {
  double distance;
  const int32_t *shift;  // [dimension], whole edges of the box
};

// One group of columns of the output.
struct PairColumn {
  const char *name, *meaning;
  void (*head)(particles::Output &out, int dimension);
  void (*write)(particles::Output &out, const PairsOptions &options, const particles::ParticleSet &set, size_t a,
                size_t b, const Meeting &meeting);
  bool needs_meeting;
};

const std::vector<PairColumn> &pair_columns() {
  static const std::vector<PairColumn> columns = {
      {"place", "a and b", [](particles::Output &out, int) { out << "a,b"; },
       [](particles::Output &out, const PairsOptions &options, const particles::ParticleSet &, size_t a, size_t b,
          const Meeting &) {
         const auto base = static_cast<size_t>(options.grid.index_base);
         out << a + base << ',' << b + base;
       },
       false},
      {"id", "the column id of the file, of both", [](particles::Output &out, int) { out << "id_a,id_b"; },
       [](particles::Output &out, const PairsOptions &, const particles::ParticleSet &set, size_t a, size_t b,
          const Meeting &) { out << set.ids[a] << ',' << set.ids[b]; },
       false},
      {"type", "its column type, species or element, of both",
       [](particles::Output &out, int) { out << "type_a,type_b"; },
       [](particles::Output &out, const PairsOptions &, const particles::ParticleSet &set, size_t a, size_t b,
          const Meeting &) { out << set.types[a] << ',' << set.types[b]; },
       false},
      {"distance", "of the centres, b by the image that a meets",
       [](particles::Output &out, int) { out << "distance"; },
       [](particles::Output &out, const PairsOptions &, const particles::ParticleSet &, size_t, size_t,
          const Meeting &meeting) { out << meeting.distance; },
       true},
      {"overlap", "both radii less the distance", [](particles::Output &out, int) { out << "overlap"; },
       [](particles::Output &out, const PairsOptions &, const particles::ParticleSet &set, size_t a, size_t b,
          const Meeting &meeting) { out << set.radii[a] + set.radii[b] - meeting.distance; },
       true},
      {"shift", "edges of the box from b to that image, along each axis",
       [](particles::Output &out, int dimension) {
         for (int axis = 0; axis < dimension; axis++)
           out << (axis > 0 ? "," : "") << "shift_"
               << "xyz"[axis];
       },
       [](particles::Output &out, const PairsOptions &, const particles::ParticleSet &set, size_t, size_t,
          const Meeting &meeting) {
         for (int axis = 0; axis < set.dimension; axis++) out << (axis > 0 ? "," : "") << meeting.shift[axis];
       },
       true},
  };
  return columns;
}

// What is written of each pair.
class PairWriter {
 public:
  PairWriter(const PairsOptions &options, const particles::ParticleSet &set) : options_(options), set_(set) {
    for (const std::string &name : options.columns) {
      const auto found = std::find_if(pair_columns().begin(), pair_columns().end(),
                                      [&](const PairColumn &column) { return column.name == name; });
      columns_.push_back(&*found);
      needs_meeting_ = needs_meeting_ || found->needs_meeting;
    }
  }

  void write_head(particles::Output &out) const {
    for (const PairColumn *column : columns_) {
      if (column != columns_.front()) out << ',';
      column->head(out, set_.dimension);
    }
    out << '\n';
  }

  bool needs_meeting() const { return needs_meeting_; }

  void write(particles::Output &out, const hg_pair &pair, const Meeting &meeting) const {
    const auto a = static_cast<size_t>(pair.a - options_.grid.index_base);
    const auto b = static_cast<size_t>(pair.b - options_.grid.index_base);
    for (const PairColumn *column : columns_) {
      if (column != columns_.front()) out << ',';
      column->write(out, options_, set_, a, b, meeting);
    }
    out << '\n';
  }

 private:
  const PairsOptions &options_;
  const particles::ParticleSet &set_;
  std::vector<const PairColumn *> columns_;
  bool needs_meeting_ = false;
};

// Counts the pairs, and hands each on.
template <class Take>
uint64_t take_pairs(hgrid::Grid &grid, Take take) {
  particles::Progress progress("searching", "contacts", 0);
  uint64_t count = 0;
  grid.visit_pairs([&](hgrid::View<hg_pair> pairs) {
    count += pairs.size();
    for (const hg_pair &pair : pairs) take(pair);
    progress.update(count);
  });
  return count;
}

// The pairs with what leads from one to the other, which the library keeps as a list.
void write_meetings(hgrid::Grid &grid, int dimension, const PairWriter &writer, particles::Output &out) {
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  const hgrid::PairVectors beside = grid.query_pair_vectors();
  for (size_t p = 0; p < pairs.size(); p++) {
    const size_t at = p * static_cast<size_t>(dimension);
    const double *d = beside.vectors.data() + at;
    const double distance = dimension == 3 ? std::hypot(d[0], d[1], d[2]) : std::hypot(d[0], d[1]);
    writer.write(out, pairs[p], {distance, beside.shifts.data() + at});
  }
}

void print_count(hgrid::Grid &grid, size_t particles) {
  const auto start = std::chrono::steady_clock::now();
  grid.build();
  const double build = measure::seconds_since(start);
  const uint64_t count = take_pairs(grid, [](const hg_pair &) {});
  const double total = measure::seconds_since(start);

  const double number = static_cast<double>(particles);
  const double mean = particles > 0 ? 2.0 * static_cast<double>(count) / number : 0.0;
  char text[512];
  std::snprintf(text, sizeof text,
                "particles              %zu\n"
                "contacts               %llu\n"
                "contacts per particle  %.6g  (each contact counts for both)\n"
                "time to build          %.6f s\n"
                "time to search         %.6f s\n"
                "time per particle      %.1f ns\n",
                particles, static_cast<unsigned long long>(count), mean, build, total - build,
                particles > 0 ? 1e9 * total / number : 0.0);
  particles::Output out("-");
  out << text;
  out.close();
}

bool has_column(const PairsOptions &options, const char *name) {
  return std::find(options.columns.begin(), options.columns.end(), name) != options.columns.end();
}

void run(PairsOptions &options) {
  options.particles.ids = has_column(options, "id");
  options.particles.types = has_column(options, "type");
  const particles::ParticleSet particles = load_particles(options.particles);
  hgrid::Grid grid = filled_grid(options.grid, particles, options.particles.file);
  if (options.count_only) {
    print_count(grid, particles.count());
    return;
  }
  // Built first: what the library refuses then must not cost the file that is overwritten.
  grid.build();
  particles::Output out(options.output);
  const PairWriter writer(options, particles);
  writer.write_head(out);
  if (writer.needs_meeting()) {
    write_meetings(grid, particles.dimension, writer, out);
  } else {
    take_pairs(grid, [&](const hg_pair &pair) { writer.write(out, pair, {}); });
  }
  out.close();
}

}  // namespace

void add_pairs(CLI::App &parent) {
  auto options = std::make_shared<PairsOptions>();
  CLI::App &command = *parent.add_subcommand("pairs", "Find the contacts of a particle file");
  add_particle_options(command, options->particles);
  add_grid_options(command, options->grid);
  auto *output = command
                     .add_option("-o,--output", options->output,
                                 "Where the contacts go: CSV with the columns a,b, a < b (a <= b with --images all);\n"
                                 "- for standard output")
                     ->capture_default_str();
  std::string meanings = "What is written of each contact, with commas between:";
  for (const PairColumn &column : pair_columns()) meanings += std::string("\n") + column.name + ": " + column.meaning;
  auto *columns = command.add_option("--columns", options->columns, meanings)
                      ->delimiter(',')
                      ->check(CLI::IsMember(particles::names_of(pair_columns())))
                      ->default_str("place");
  command.add_flag("--count", options->count_only, "Only count them, and tell the time it took")
      ->excludes(output)
      ->excludes(columns);
  add_base_option(command, options->grid);
  command.footer(
      "a and b are the places of the particles in the file, the first being 0 (or 1 with --base 1).\n"
      "Spheres that exactly touch are no contact, unless --touching says so. Each contact stands on one line; with\n"
      "--images all there is a line for each periodic image in reach, so that a,b may stand on several, and a,a where "
      "a\n"
      "particle meets its own image.\n"
      "Examples:\n"
      "  hgrid pairs packing.csv --output contacts.csv\n"
      "  hgrid pairs dump.lammpstrj --frame 1 --count\n"
      "  hgrid pairs packing.xyz --margin 0.1 --order id --base 1\n"
      "  hgrid pairs open.csv --box 0,0,0,1,1,1 --periodic xy\n"
      "  hgrid pairs sheared.csv --box 0,0,0,1,1,1 --periodic xyz --tilt 0.25,0,0\n"
      "  hgrid pairs crystal.xyz --touching --images all\n"
      "  hgrid pairs dump.lammpstrj --columns id,distance,shift");
  command.callback([options] { run(*options); });
}

}  // namespace command
