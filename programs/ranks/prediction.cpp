// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/ranks/prediction.hpp"

#include "mpi/size_boxes.hpp"

#include <cmath>

namespace ranks {
namespace {

constexpr double kPerNano = 1e-9, kPerMicro = 1e-6, kPerGiga = 1e9;

// ns to look at the boxes of another rank that is far away.
constexpr double kFarRank = 50;

double seconds_of_work(double particles, double ghosts, double pairs, const Assumptions &assumed) {
  return kPerNano * (particles * assumed.particle_ns + pairs * assumed.pair_ns +
                     (particles + ghosts) * assumed.search_ns / assumed.interval);
}

// Of one ghost's byte: what leaves the node shares its network, the rest goes from memory to memory.
double seconds_per_byte(const Machine &machine, const Assumptions &assumed) {
  const bool one_node = machine.rank_count <= assumed.node_ranks;
  const double leaving = one_node ? 0 : std::pow(assumed.node_ranks, -1.0 / machine.dimension);
  return leaving * assumed.node_ranks / (assumed.node_gb_per_s * kPerGiga) +
         (1 - leaving) / (assumed.rank_gb_per_s * kPerGiga);
}

}  // namespace

const std::vector<AssumptionRow> &assumption_rows() {
  static const std::vector<AssumptionRow> rows = {
      {"--particle-ns", &Assumptions::particle_ns, "Work per particle and step, in ns"},
      {"--pair-ns", &Assumptions::pair_ns, "Work per pair and step, in ns"},
      {"--search-ns", &Assumptions::search_ns, "A new search, per particle and ghost, in ns"},
      {"--choice-ns", &Assumptions::choice_ns, "A new choice of ghosts, per particle, in ns"},
      {"--interval", &Assumptions::interval, "Steps from one search to the next"},
      {"--forward-bytes", &Assumptions::forward_bytes, "Sent for each ghost in each step"},
      {"--back-bytes", &Assumptions::back_bytes, "Sent back for each ghost in each step"},
      {"--node-ranks", &Assumptions::node_ranks, "Ranks of a node"},
      {"--node-bandwidth", &Assumptions::node_gb_per_s, "Network of a node, in GB/s"},
      {"--rank-bandwidth", &Assumptions::rank_gb_per_s, "From rank to rank in a node, in GB/s for each"},
      {"--latency", &Assumptions::latency_us, "Of a message, in us"},
  };
  return rows;
}

double bytes_per_step(const Load &load, const Assumptions &assumed) {
  return static_cast<double>(load.exchange.ghosts) * assumed.forward_bytes +
         static_cast<double>(load.exchange.sent) * assumed.back_bytes;
}

double step_seconds(const Load &load, const Machine &machine, const Assumptions &assumed) {
  const auto owned = static_cast<double>(load.exchange.owned), ghosts = static_cast<double>(load.exchange.ghosts);
  const double per_byte = seconds_per_byte(machine, assumed), latency = kPerMicro * assumed.latency_us;
  double seconds = seconds_of_work(owned, ghosts, load.pairs, assumed);
  if (machine.rank_count == 1) return seconds;
  seconds += bytes_per_step(load, assumed) * per_byte;
  seconds += static_cast<double>(load.exchange.send_ranks + load.exchange.receive_ranks) * latency;
  // Whether ghosts must be chosen anew: up and down a tree of ranks.
  seconds += 2 * std::log2(machine.rank_count) * latency;
  const double box_bytes = machine.boxes * sizeof(hgrid::mpi::SizeBox);
  const double choice = kPerNano * (owned * assumed.choice_ns + machine.rank_count * kFarRank) +
                        machine.rank_count * box_bytes * assumed.node_ranks / (assumed.node_gb_per_s * kPerGiga);
  return seconds + choice / assumed.interval;
}

double serial_seconds(double particles, double pairs, const Assumptions &assumed) {
  return seconds_of_work(particles, 0, pairs, assumed);
}

}  // namespace ranks
