// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_parts: what each call of the library costs by itself, through Google Benchmark. One thread.
#include "packing/packing.hpp"
#include "particles/grid_handle.hpp"

#include <hgrid/hgrid.h>

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
    grid_.insert(*set_);
    grid_.pairs();  // memory is there from now on
  }
  // Moving to the same places makes the grid forget what it has built and found.
  void forget() { particles::check(hg_move(get(), set_->count(), set_->centers.data(), nullptr)); }
  hg_grid *get() { return grid_.get(); }
  particles::Grid &grid() { return grid_; }
  const particles::ParticleSet &set() const { return *set_; }

 private:
  static hg_grid_def serial() {
    hg_grid_def def = hg_default_grid_def();
    def.thread_count = 1;
    return def;
  }

  const particles::ParticleSet *set_;
  particles::Grid grid_;
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
      state, grid, [&] { particles::check(hg_clear(grid.get())); }, [&] { grid.grid().insert(grid.set()); });
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
  run(state, grid, before, [&] { benchmark::DoNotOptimize(grid.grid().pairs().data); });
}

int32_t count_pairs(void *context, const hg_pair *, size_t count) {
  *static_cast<size_t *>(context) += count;
  return 0;
}

void visit(benchmark::State &state) {
  FilledGrid grid(state);
  size_t pairs = 0;
  const auto before = [&] {
    grid.forget();
    grid.grid().build();
  };
  run(state, grid, before, [&] { grid.grid().visit_pairs(count_pairs, &pairs); });
  benchmark::DoNotOptimize(pairs);
}

void neighbors(benchmark::State &state) {
  FilledGrid grid(state);
  const auto before = [&] {
    grid.forget();
    grid.grid().build();
  };
  run(state, grid, before, [&] {
    const int64_t *offsets = nullptr;
    const int32_t *list = nullptr;
    particles::check(hg_query_neighbors(grid.get(), HG_FULL, &offsets, &list));
    benchmark::DoNotOptimize(list);
  });
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
