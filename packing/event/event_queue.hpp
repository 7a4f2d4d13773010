// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The next event of every particle, the earliest on top: a heap that knows where each particle stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace packing::event {

// Always holds every particle once. Four children per node: half the depth of a binary heap, and the children of a
// node lie side by side in memory.
class EventQueue {
 public:
  explicit EventQueue(size_t count) : nodes_(count), place_(count) {}

  // Takes the times of all particles. O(N).
  void fill(const std::vector<double> &times) {
    for (size_t k = 0; k < nodes_.size(); k++) {
      nodes_[k] = {times[k], static_cast<int32_t>(k)};
      place_[k] = static_cast<uint32_t>(k);
    }
    for (size_t k = nodes_.size() / kChildren + 1; k-- > 0;) {
      if (k < nodes_.size()) sink(k, nodes_[k]);
    }
  }

  int32_t first() const { return nodes_.front().particle; }
  double first_time() const { return nodes_.front().time; }

  // Sets the time of one particle. O(log N).
  void set(int32_t particle, double time) {
    const size_t k = place_[static_cast<size_t>(particle)];
    const Node node{time, particle};
    if (time < nodes_[k].time) {
      rise(k, node);
    } else {
      sink(k, node);
    }
  }

 private:
  static constexpr size_t kChildren = 4;

  struct Node {
    double time;
    int32_t particle;
  };

  void put(size_t k, const Node &node) {
    nodes_[k] = node;
    place_[static_cast<size_t>(node.particle)] = static_cast<uint32_t>(k);
  }

  void rise(size_t k, Node node) {
    while (k > 0) {
      const size_t parent = (k - 1) / kChildren;
      if (!(node.time < nodes_[parent].time)) break;
      put(k, nodes_[parent]);
      k = parent;
    }
    put(k, node);
  }

  void sink(size_t k, Node node) {
    const size_t count = nodes_.size();
    for (;;) {
      const size_t begin = k * kChildren + 1;
      if (begin >= count) break;
      const size_t end = begin + kChildren < count ? begin + kChildren : count;
      size_t least = begin;
      for (size_t child = begin + 1; child < end; child++) {
        if (nodes_[child].time < nodes_[least].time) least = child;
      }
      if (!(nodes_[least].time < node.time)) break;
      put(k, nodes_[least]);
      k = least;
    }
    put(k, node);
  }

  std::vector<Node> nodes_;
  std::vector<uint32_t> place_;  // of each particle in nodes_
};

}  // namespace packing::event
