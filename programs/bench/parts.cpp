// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_parts: what each call of the library costs by itself, through Google Benchmark. One thread.
#include "packing/packing.hpp"
#include "particles/insert.hpp"

#include <hgrid/hgrid.hpp>

#include <benchmark/benchmark.h>

#include <map>
#include <utility>

namespace {

// The second argument of every benchmark: the ratio of sizes, 1 for equal ones.
const particles::ParticleSet &particles_of(const benchmark::State &state) {
  static std::map<std::pair<int64_t, int64_t>, particles::ParticleSet> made;
  const auto key = std::make_pair(state.range(0), state.range(1));
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  packing::Request request;
  request.count = static_cast<size_t>(state.range(0));
  request.law.law = state.range(1) == 1 ? packing::Law::kMono : packing::Law::kUniformVolume;
  request.law.ratio = static_cast<double>(state.range(1));
  request.sweeps = 10;
  return made[key] = packing::make_packing(request, nullptr).particles;
}

class FilledGrid {
 public:
  explicit FilledGrid(const benchmark::State &state) : set_(&particles_of(state)), grid_(serial()) {
    particles::insert(*set_, grid_);
    grid_.query_pairs();  // memory is there from now on
  }
  // Moving to the same places makes the grid forget what it has built and found.
  void forget() { grid_.move(set_->count(), set_->centers.data()); }
  hgrid::Grid &grid() { return grid_; }
  const particles::ParticleSet &set() const { return *set_; }

 private:
  static hg_grid_def serial() {
    hg_grid_def def = hg_default_grid_def();
    def.thread_count = 1;
    return def;
  }

  const particles::ParticleSet *set_;
  hgrid::Grid grid_;
};

// Times `part`; `before` comes before each run, off the clock.
template <class Before, class Part>
void run(benchmark::State &state, FilledGrid &grid, Before before, Part part) {
  for (auto _ : state) {
    state.PauseTiming();
    before();
    state.ResumeTiming();
    part();
  }
  const double particles = static_cast<double>(grid.set().count()) * static_cast<double>(state.iterations());
  state.counters["per_particle"] =
      benchmark::Counter(particles, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void insert(benchmark::State &state) {
  FilledGrid grid(state);
  run(
      state, grid, [&] { grid.grid().clear(); }, [&] { particles::insert(grid.set(), grid.grid()); });
}

void move(benchmark::State &state) {
  FilledGrid grid(state);
  run(
      state, grid, [] {}, [&] { grid.forget(); });
}

// Keys, scatter and sort.
void build(benchmark::State &state) {
  FilledGrid grid(state);
  run(
      state, grid, [&] { grid.forget(); }, [&] { grid.grid().build(); });
}

void search(benchmark::State &state) {
  FilledGrid grid(state);
  const auto before = [&] {
    grid.forget();
    grid.grid().build();
  };
  run(state, grid, before, [&] { benchmark::DoNotOptimize(grid.grid().query_pairs().data()); });
}

void visit(benchmark::State &state) {
  FilledGrid grid(state);
  size_t pairs = 0;
  const auto before = [&] {
    grid.forget();
    grid.grid().build();
  };
  run(state, grid, before,
      [&] { grid.grid().visit_pairs([&](hgrid::View<hg_pair> batch) { pairs += batch.size(); }); });
  benchmark::DoNotOptimize(pairs);
}

void neighbors(benchmark::State &state) {
  FilledGrid grid(state);
  const auto before = [&] {
    grid.forget();
    grid.grid().build();
  };
  run(state, grid, before, [&] { benchmark::DoNotOptimize(grid.grid().query_neighbors(HG_FULL).ids.data()); });
}

void sizes(benchmark::internal::Benchmark *benchmark) {
  benchmark->ArgNames({"particles", "ratio"})->Args({125001, 1})->Args({125001, 50})->Unit(benchmark::kMillisecond);
}

}  // namespace

BENCHMARK(insert)->Apply(sizes);
BENCHMARK(move)->Apply(sizes);
BENCHMARK(build)->Apply(sizes);
BENCHMARK(search)->Apply(sizes);
BENCHMARK(visit)->Apply(sizes);
BENCHMARK(neighbors)->Apply(sizes);
