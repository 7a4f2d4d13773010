// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What more threads gain or cost where cores are shared: beside processes that never rest, after pauses, and in turns
// with parallel regions of the program itself (hgrid_threads_openmp, the same file compiled with OpenMP).
#include "packing/random.hpp"
#include "programs/bench/program.hpp"
#include "programs/measure/statistics.hpp"

#include <hgrid/hgrid.hpp>

#include <CLI/CLI.hpp>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Options {
  size_t count = 100000;
  int calls = 200, others = 0;
  double pause = 0, region = 0;  // ms
  std::vector<int> threads{1, 2};
};

// Processes that take whatever they get of the cores.
class Others {
 public:
  explicit Others(int count) {
    for (int k = 0; k < count; k++) {
      const pid_t child = fork();
      if (child == 0) {
        for (volatile unsigned turn = 0;; turn = turn + 1) {
        }
      }
      if (child > 0) children_.push_back(child);
    }
  }
  ~Others() {
    for (const pid_t child : children_) kill(child, SIGKILL);
  }
  Others(const Others &) = delete;
  Others &operator=(const Others &) = delete;

 private:
  std::vector<pid_t> children_;
};

void work_on_all_threads([[maybe_unused]] int threads, double milliseconds) {
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
#endif
  {
    const auto start = Clock::now();
    while (seconds_since(start) < milliseconds / 1e3) {
    }
  }
}

// Equal spheres at random, volume fraction 0.6.
struct Spheres {
  std::vector<double> centers, radii;

  explicit Spheres(size_t count) : centers(3 * count), radii(count, 0.5) {
    const double edge = std::cbrt(static_cast<double>(count) * 0.5235987755982988 / 0.6);
    packing::Random random(1);
    for (double &x : centers) x = edge * random.uniform();
  }
};

// Seconds of each call: all particles anew and their pairs.
std::vector<double> time_calls(const Options &options, const Spheres &spheres, int threads) {
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = threads;
  hgrid::Grid grid(def);
  std::vector<double> times;
  constexpr int kWarmUp = 3;
  for (int call = 0; call < options.calls + kWarmUp; call++) {
    if (options.region > 0) work_on_all_threads(threads, options.region);
    if (options.pause > 0) std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(options.pause));
    const auto start = Clock::now();
    grid.set(options.count, spheres.centers.data(), spheres.radii.data());
    grid.query_pairs();
    if (call >= kWarmUp) times.push_back(seconds_since(start));
  }
  std::sort(times.begin(), times.end());
  return times;
}

int run(const Options &options) {
  const Spheres spheres(options.count);
  const Others others(options.others);
  std::printf("ns per particle for all %zu particles anew and their pairs, %d calls\n", options.count, options.calls);
  std::printf("%8s %8s %8s %8s\n", "threads", "median", "90 %", "worst");
  for (const int threads : options.threads) {
    const std::vector<double> times = time_calls(options, spheres, threads);
    const double unit = 1e9 / static_cast<double>(options.count);
    std::printf("%8d %8.1f %8.1f %8.1f\n", threads, unit * measure::quantile(times, 0.5),
                unit * measure::quantile(times, 0.9), unit * times.back());
    std::fflush(stdout);
  }
  return 0;
}

void add_options(CLI::App &command, Options &options) {
  command.add_option("--count", options.count, "Particles")->capture_default_str()->check(CLI::Range(1, 100000000));
  command.add_option("--calls", options.calls, "Timed calls")->capture_default_str()->check(CLI::Range(1, 1000000));
  command.add_option("--others", options.others, "Processes beside that never rest")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  command.add_option("--pause", options.pause, "Sleep before each call, ms")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--region", options.region,
                  "Work of the program itself before each call, ms; on all threads with OpenMP")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command.add_option("--threads", options.threads, "Numbers of threads")
      ->capture_default_str()
      ->delimiter(',')
      ->check(CLI::Range(1, 1024));
}

}  // namespace

int main(int argc, char **argv) {
  return bench::run_program("hgrid_threads", "Time searches on several threads where cores are shared", argc, argv,
                            add_options, run);
}
