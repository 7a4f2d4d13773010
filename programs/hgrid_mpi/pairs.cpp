// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid-mpi pairs: the contacts of a particle file over ranks; the same bytes as those of hgrid pairs --order id.
#include "particles/error.hpp"
#include "particles/text/output.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"
#include "programs/hgrid_mpi/command.hpp"
#include "programs/ranks/decomposition.hpp"

#include <hgrid/mpi.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace command {
namespace {

struct PairsOptions {
  ParticleOptions particles;
  GridOptions grid;
  std::string output = "-";
  bool count_only = false;
};

// A particle and a pair as they travel, as bytes.
struct Particle {
  int64_t gid;
  double center[3], radius;
};
struct GidPair {
  int64_t a, b;
};

// What each rank has, row after row.
template <class Row>
struct RowsOfRanks {
  std::vector<int> counts, places;
  std::vector<Row> rows;
};

struct Ranks {
  int rank = 0, size = 1;
  Ranks() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
  }
  bool is_first() const { return rank == 0; }
};

// Rows of a type, as MPI counts them.
class RowType {
 public:
  explicit RowType(size_t bytes) {
    MPI_Type_contiguous(static_cast<int>(bytes), MPI_BYTE, &type_);
    MPI_Type_commit(&type_);
  }
  ~RowType() { MPI_Type_free(&type_); }
  RowType(const RowType &) = delete;
  RowType &operator=(const RowType &) = delete;
  MPI_Datatype get() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

void need(const std::string &file, hg_status status) {
  if (status != HG_OK) throw particles::Error(file, 0, std::string(hg_status_string(status)) + ": " + hg_last_error());
}

// The first rank's text of what went wrong there, if anything, is thrown on all.
void share_failure(const std::string &fault) {
  char text[512] = "";
  std::snprintf(text, sizeof text, "%s", fault.c_str());
  MPI_Bcast(text, sizeof text, MPI_BYTE, 0, MPI_COMM_WORLD);
  if (text[0] != '\0') throw particles::Error(text);
}

// Read by the first rank, dealt out by bisection; *def becomes that of the file on all ranks.
std::vector<Particle> particles_of_rank(const PairsOptions &options, const Ranks &ranks, hg_grid_def *def) {
  RowsOfRanks<Particle> all;
  std::string fault;
  if (ranks.is_first()) {
    try {
      const particles::ParticleSet set = load_particles(options.particles);
      *def = grid_def(options.grid, set, {});
      const std::vector<int32_t> owners = ranks::bisect(set, std::vector<double>(set.count(), 1.0), ranks.size);
      std::vector<std::vector<Particle>> of(static_cast<size_t>(ranks.size));
      for (size_t k = 0; k < set.count(); k++) {
        Particle one{static_cast<int64_t>(k), {0, 0, 0}, set.radii[k]};
        std::copy_n(set.center(k), set.dimension, one.center);
        of[static_cast<size_t>(owners[k])].push_back(one);
      }
      for (const std::vector<Particle> &rows : of) {
        all.places.push_back(static_cast<int>(all.rows.size()));
        all.counts.push_back(static_cast<int>(rows.size()));
        all.rows.insert(all.rows.end(), rows.begin(), rows.end());
      }
    } catch (const std::exception &error) {
      fault = particles::message_of(error);
    }
  }
  share_failure(fault);
  MPI_Bcast(def, sizeof *def, MPI_BYTE, 0, MPI_COMM_WORLD);
  int count = 0;
  MPI_Scatter(all.counts.data(), 1, MPI_INT, &count, 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::vector<Particle> mine(static_cast<size_t>(count));
  const RowType row(sizeof(Particle));
  MPI_Scatterv(all.rows.data(), all.counts.data(), all.places.data(), row.get(), mine.data(), count, row.get(), 0,
               MPI_COMM_WORLD);
  return mine;
}

struct DestroyMpi {
  void operator()(hg_mpi *mpi) const { hg_mpi_destroy(mpi); }
};
using MpiHandle = std::unique_ptr<hg_mpi, DestroyMpi>;

MpiHandle make_world(const PairsOptions &options, const Ranks &ranks) {
  hg_grid_def def = hg_default_grid_def();
  const std::vector<Particle> mine = particles_of_rank(options, ranks, &def);
  def.index_base = 0;
  hg_mpi *made = nullptr;
  need(options.particles.file, hg_mpi_create(MPI_COMM_WORLD, &def, nullptr, &made));
  MpiHandle world(made);
  std::vector<int64_t> gids;
  std::vector<double> centers, radii;
  for (const Particle &one : mine) {
    gids.push_back(one.gid);
    centers.insert(centers.end(), one.center, one.center + def.dimension);
    radii.push_back(one.radius);
  }
  need(options.particles.file, hg_mpi_set(world.get(), gids.size(), gids.data(), centers.data(), radii.data()));
  return world;
}

std::vector<GidPair> pairs_of_rank(const PairsOptions &options, hg_mpi *world) {
  const hg_pair *pairs = nullptr;
  const int64_t *own = nullptr, *other = nullptr;
  size_t count = 0, owned = 0;
  need(options.particles.file, hg_mpi_query_pairs(world, &pairs, &count));
  need(options.particles.file, hg_mpi_owned(world, &owned, &own, nullptr, nullptr));
  need(options.particles.file, hg_mpi_ghosts(world, nullptr, &other, nullptr, nullptr, nullptr));
  std::vector<GidPair> result;
  for (size_t k = 0; k < count; k++) {
    const auto b = static_cast<size_t>(pairs[k].b);
    const int64_t gids[2] = {own[pairs[k].a], b < owned ? own[b] : other[b - owned]};
    result.push_back({std::min(gids[0], gids[1]), std::max(gids[0], gids[1])});
  }
  return result;
}

// On the first rank those of all ranks.
template <class Row>
std::vector<Row> gathered(const std::vector<Row> &mine, const Ranks &ranks) {
  RowsOfRanks<Row> all;
  const int count = static_cast<int>(mine.size());
  all.counts.resize(static_cast<size_t>(ranks.size));
  MPI_Gather(&count, 1, MPI_INT, all.counts.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  for (const int other : all.counts) {
    all.places.push_back(static_cast<int>(all.rows.size()));
    if (ranks.is_first()) all.rows.resize(all.rows.size() + static_cast<size_t>(other));
  }
  const RowType row(sizeof(Row));
  MPI_Gatherv(mine.data(), count, row.get(), all.rows.data(), all.counts.data(), all.places.data(), row.get(), 0,
              MPI_COMM_WORLD);
  return all.rows;
}

void write_pairs(const PairsOptions &options, std::vector<GidPair> pairs) {
  std::sort(pairs.begin(), pairs.end(),
            [](const GidPair &p, const GidPair &q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  particles::Output out(options.output);
  out << "a,b\n";
  for (const GidPair &pair : pairs) {
    out << pair.a + options.grid.index_base << ',' << pair.b + options.grid.index_base << '\n';
  }
  out.close();
}

void print_counts(const std::vector<hg_mpi_stats> &all) {
  int64_t pairs = 0;
  std::printf("rank,owned,ghosts,pairs,ranks sent to,ranks received from\n");
  for (size_t k = 0; k < all.size(); k++) {
    const hg_mpi_stats &stats = all[k];
    std::printf("%zu,%lld,%lld,%lld,%lld,%lld\n", k, static_cast<long long>(stats.owned_count),
                static_cast<long long>(stats.ghost_count), static_cast<long long>(stats.pair_count),
                static_cast<long long>(stats.send_rank_count), static_cast<long long>(stats.receive_rank_count));
    pairs += stats.pair_count;
  }
  std::printf("%lld contacts\n", static_cast<long long>(pairs));
}

void run(const PairsOptions &options) {
  const Ranks ranks;
  const MpiHandle world = make_world(options, ranks);
  const std::vector<GidPair> pairs = pairs_of_rank(options, world.get());
  std::string fault;
  try {
    if (options.count_only) {
      hg_mpi_stats stats{};
      need(options.particles.file, hg_mpi_get_stats(world.get(), &stats, sizeof stats));
      const std::vector<hg_mpi_stats> all = gathered(std::vector<hg_mpi_stats>{stats}, ranks);
      if (ranks.is_first()) print_counts(all);
    } else {
      const std::vector<GidPair> all = gathered(pairs, ranks);
      if (ranks.is_first()) write_pairs(options, all);
    }
  } catch (const std::exception &error) {
    fault = particles::message_of(error);
  }
  share_failure(fault);
}

}  // namespace

void add_rank_pairs(CLI::App &parent) {
  auto options = std::make_shared<PairsOptions>();
  CLI::App &command = *parent.add_subcommand("pairs", "Find the contacts of a particle file, under mpirun");
  add_particle_options(command, options->particles);
  add_grid_options(command, options->grid);
  auto *output =
      command
          .add_option("-o,--output", options->output,
                      "Where the contacts go: CSV with the columns a,b, a < b, ascending; - for standard output")
          ->capture_default_str();
  command.add_flag("--count", options->count_only, "Only count them, and tell what each rank has")->excludes(output);
  add_base_option(command, options->grid);
  command.footer(
      "The first rank reads and writes; particles are dealt out by bisection, as hgrid-mpi plan does.\n"
      "Example:\n"
      "  mpirun -n 4 hgrid-mpi pairs packing.csv --output contacts.csv");
  command.callback([options] { run(*options); });
}

}  // namespace command
