// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The next event of every particle, the earliest on top: a heap that knows where each particle stands.
#ifndef HGRID_SIM_EVENT_EVENT_QUEUE_HPP
#define HGRID_SIM_EVENT_EVENT_QUEUE_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hgrid_sim::event {

// Always holds every particle once. Four children per node: half the depth of a binary heap, and the children of a
// node lie side by side in memory.
class EventQueue {
 public:
  explicit EventQueue(std::size_t count) : nodes_(count), place_(count) {}

  // Takes the times of all particles. O(N).
  void fill(const std::vector<double> &times) {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      nodes_[k] = {times[k], static_cast<std::int32_t>(k)};
      place_[k] = static_cast<std::uint32_t>(k);
    }
    for (std::size_t k = nodes_.size() / kChildren + 1; k-- > 0;) {
      if (k < nodes_.size()) sink(k, nodes_[k]);
    }
  }

  std::int32_t first() const { return nodes_.front().particle; }
  double first_time() const { return nodes_.front().time; }

  // Sets the time of one particle. O(log N).
  void set(std::int32_t particle, double time) {
    const std::size_t k = place_[static_cast<std::size_t>(particle)];
    const Node node{time, particle};
    if (time < nodes_[k].time) {
      rise(k, node);
    } else {
      sink(k, node);
    }
  }

 private:
  static constexpr std::size_t kChildren = 4;

  struct Node {
    double time;
    std::int32_t particle;
  };

  void put(std::size_t k, const Node &node) {
    nodes_[k] = node;
    place_[static_cast<std::size_t>(node.particle)] = static_cast<std::uint32_t>(k);
  }

  void rise(std::size_t k, Node node) {
    while (k > 0) {
      const std::size_t parent = (k - 1) / kChildren;
      if (!(node.time < nodes_[parent].time)) break;
      put(k, nodes_[parent]);
      k = parent;
    }
    put(k, node);
  }

  void sink(std::size_t k, Node node) {
    const std::size_t count = nodes_.size();
    for (;;) {
      const std::size_t begin = k * kChildren + 1;
      if (begin >= count) break;
      const std::size_t end = begin + kChildren < count ? begin + kChildren : count;
      std::size_t least = begin;
      for (std::size_t child = begin + 1; child < end; ++child) {
        if (nodes_[child].time < nodes_[least].time) least = child;
      }
      if (!(nodes_[least].time < node.time)) break;
      put(k, nodes_[least]);
      k = least;
    }
    put(k, node);
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> place_;  // of each particle in nodes_
};

}  // namespace hgrid_sim::event

#endif
