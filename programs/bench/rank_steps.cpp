// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_rank_steps: whole steps over ranks of MPI: motion, pairs, forces of springs, forces back to owners. Run it
// on one rank and on more, and compare. Prints one line of CSV.
#include "particles/insert.hpp"
#include "programs/bench/mpi_clock.hpp"
#include "programs/bench/program.hpp"
#include "programs/bench/thrown.hpp"
#include "programs/measure/timing.hpp"

#include <hgrid/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

struct Options {
  bench::Thrown thrown;
  int steps = 100;
  double skin = 0.4;    // in smallest radii
  double speed = 0.02;  // of the fastest, in smallest radii per step
};

void need(hg_status status) {
  if (status != HG_OK) throw particles::Error(std::string(hg_status_string(status)) + ": " + hg_last_error());
}

double sum_of(double mine, MPI_Op op = MPI_SUM) {
  double all = 0;
  PMPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, op, MPI_COMM_WORLD);
  return all;
}

class Steps {
 public:
  Steps(const Options &options, const particles::ParticleSet &set) : speed_(options.speed) {
    hg_grid_def def = hg_default_grid_def();
    particles::set_box(set, def);
    def.thread_count = 1;
    smallest_ = *std::min_element(set.radii.begin(), set.radii.end());
    def.skin = options.skin * smallest_;
    for (size_t axis = 0; axis < 3; axis++) {
      length_[axis] = def.periodic[axis] != 0 ? def.box_max[axis] - def.box_min[axis] : 0;
      per_length_[axis] = length_[axis] > 0 ? 1 / length_[axis] : 0;
    }
    need(hg_mpi_create(MPI_COMM_WORLD, &def, nullptr, &mpi_));
    hand_out(set);
  }
  ~Steps() { hg_mpi_destroy(mpi_); }
  Steps(const Steps &) = delete;
  Steps &operator=(const Steps &) = delete;

  size_t owned() const { return radii_.size(); }
  void step() {
    for (size_t k = 0; k < x_.size(); k++) x_[k] += v_[k];
    need(hg_mpi_move(mpi_, owned(), x_.data(), nullptr, nullptr));
    const double *ghosts = nullptr, *ghost_radii = nullptr;
    size_t ghost_count = 0, pair_count = 0;
    need(hg_mpi_ghosts(mpi_, &ghost_count, nullptr, nullptr, &ghosts, &ghost_radii));
    const hg_pair *pairs = nullptr;
    need(hg_mpi_query_pairs(mpi_, &pairs, &pair_count));
    const size_t n = owned();
    f_.assign(3 * (n + ghost_count), 0);
    for (size_t k = 0; k < pair_count; k++) {
      const auto a = static_cast<size_t>(pairs[k].a), b = static_cast<size_t>(pairs[k].b);
      const double *xb = b < n ? &x_[3 * b] : ghosts + 3 * (b - n);
      push(&x_[3 * a], xb, radii_[a] + (b < n ? radii_[b] : ghost_radii[b - n]), &f_[3 * a], &f_[3 * b]);
    }
    need(hg_mpi_reverse_add(mpi_, 3, f_.data() + 3 * n, f_.data()));
    // So weak that all move on about as they began.
    for (size_t k = 0; k < x_.size(); k++) v_[k] += 1e-6 * f_[k];
  }
  hg_mpi_stats stats() const {
    hg_mpi_stats stats{};
    need(hg_mpi_get_stats(mpi_, &stats, sizeof stats));
    return stats;
  }

 private:
  void hand_out(const particles::ParticleSet &set) {
    int rank = 0, size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    std::vector<int64_t> gids;
    for (auto row = static_cast<size_t>(rank); row < set.count(); row += static_cast<size_t>(size)) {
      gids.push_back(static_cast<int64_t>(row));
      x_.insert(x_.end(), set.center(row), set.center(row) + 3);
      radii_.push_back(set.radii[row]);
    }
    need(hg_mpi_set(mpi_, gids.size(), gids.data(), x_.data(), radii_.data()));
    size_t count = 0;
    need(hg_mpi_balance(mpi_, nullptr, &count));
    const int64_t *own = nullptr;
    const double *x = nullptr, *r = nullptr;
    need(hg_mpi_owned(mpi_, nullptr, &own, &x, &r));
    x_.assign(x, x + 3 * count);
    radii_.assign(r, r + count);
    // Of each particle, whoever owns it.
    for (size_t k = 0; k < 3 * count; k++) {
      const auto mixed = static_cast<uint64_t>(3 * own[k / 3] + static_cast<int64_t>(k % 3)) * 0x9e3779b97f4a7c15U;
      v_.push_back(speed_ * smallest_ * (static_cast<double>(mixed >> 11) * 0x1p-52 - 1) / std::sqrt(3.0));
    }
  }
  void push(const double *xa, const double *xb, double reach, double *fa, double *fb) const {
    double d[3], squares = 0;
    for (size_t axis = 0; axis < 3; axis++) {
      d[axis] = xa[axis] - xb[axis];
      d[axis] -= length_[axis] * std::nearbyint(d[axis] * per_length_[axis]);
      squares += d[axis] * d[axis];
    }
    const double distance = std::sqrt(squares), pull = distance > 0 ? (reach - distance) / distance : 0;
    for (size_t axis = 0; axis < 3; axis++) {
      fa[axis] += pull * d[axis];
      fb[axis] -= pull * d[axis];
    }
  }

  double speed_, smallest_ = 0;
  double length_[3]{}, per_length_[3]{};
  hg_mpi *mpi_ = nullptr;
  std::vector<double> x_, v_, f_, radii_;
};

int measure_steps(const Options &options) {
  const particles::ParticleSet set = bench::throw_particles(options.thrown);
  Steps steps(options, set);
  for (int k = 0; k < 5; k++) steps.step();
  const hg_mpi_stats before = steps.stats();
  const bench::RankTime start = bench::rank_time();
  const double wall = measure::seconds_of([&] {
    for (int k = 0; k < options.steps; k++) steps.step();
  });
  const bench::RankTime end = bench::rank_time();
  const hg_mpi_stats after = steps.stats();
  const double per = 1e3 / options.steps, work = (end.work() - start.work()) * per;
  const double processor = (end.processor - start.processor) * per;
  const auto sum = [](int64_t mine) { return sum_of(static_cast<double>(mine)); };
  const double ranks = sum(1), ghosts = sum(after.ghost_count), pairs = sum(after.pair_count);
  const double bytes = sum(after.sent_byte_count - before.sent_byte_count) / options.steps;
  const double slowest = sum_of(wall * per, MPI_MAX), most = sum_of(work, MPI_MAX), all = sum_of(work);
  const double all_processor = sum_of(processor);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::printf(
        "ranks,particles,ghosts,pairs,steps,choices of ghosts,MB per step,ms per step,work of the busiest "
        "rank ms,work of all ms,processor time of all ms\n");
    std::printf("%.0f,%zu,%.0f,%.0f,%d,%lld,%.3f,%.2f,%.2f,%.2f,%.2f\n", ranks, set.count(), ghosts, pairs,
                options.steps, static_cast<long long>(after.selection_count - before.selection_count), 1e-6 * bytes,
                slowest, most, all, all_processor);
  }
  return 0;
}

void add_options(CLI::App &command, Options &options) {
  bench::add_thrown_options(command, options.thrown);
  command.add_option("--steps", options.steps, "Steps that are timed")->capture_default_str();
  command.add_option("--skin", options.skin, "Skin in smallest radii")->capture_default_str();
  command.add_option("--speed", options.speed, "Of the fastest, in smallest radii per step")->capture_default_str();
}

}  // namespace

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  const int code = bench::run_program("hgrid_rank_steps", "Time whole steps over ranks of MPI", argc, argv, add_options,
                                      measure_steps);
  // A rank that failed does not let others wait.
  if (code != 0) MPI_Abort(MPI_COMM_WORLD, code);
  MPI_Finalize();
  return code;
}
