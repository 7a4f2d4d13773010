// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulation leaves to the next one.
#include "dem/state/handover.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace dem {
namespace {

// Of a contact whose particles change places: slip is the way of a against b, so it turns round; roll is a turn about
// the normal, which turns round, too, and stays.
bool turns_round(size_t history) { return history == history_of(kFriction); }

template <class Rename>
ContactMemory renumbered(const ContactMemory &memory, Rename rename) {
  const size_t count = memory.pairs.size();
  std::vector<hg_pair> pairs = memory.pairs;
  std::vector<double> signs(count, 1.0);
  for (size_t p = 0; p < count; p++) signs[p] = rename(pairs[p]) ? -1 : 1;
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t x, size_t y) {
    return pairs[x].a != pairs[y].a ? pairs[x].a < pairs[y].a : pairs[x].b < pairs[y].b;
  });
  ContactMemory result;
  for (const size_t p : order) {
    result.pairs.push_back(pairs[p]);
    for (size_t k = 0; k < kHistoryCount; k++) {
      const std::vector<double> &rows = memory.rows[k];
      const size_t width = rows.size() / count;
      const double sign = turns_round(k) ? signs[p] : 1;
      for (size_t axis = 0; axis < width; axis++) result.rows[k].push_back(sign * rows[p * width + axis]);
    }
  }
  return result;
}

// All arrays of a handover under the names that they have in checkpoints: what is written and what is read is one list.
template <class SomeHandover, class Visit>
void visit_arrays(SomeHandover &handover, Visit visit) {
  visit("start centers", handover.particles.centers);
  visit("start velocities", handover.particles.velocities);
  visit("start radii", handover.particles.radii);
  visit("start masses", handover.particles.masses);
  visit("start spins", handover.particles.spins);
  visit("start materials", handover.particles.material_ids);
  const auto visit_memory = [&](const std::string &name, auto &memory) {
    visit(name + " pairs", memory.pairs);
    for (size_t k = 0; k < kHistoryCount; k++) visit(name + " rows " + std::to_string(k), memory.rows[k]);
  };
  visit_memory("start pair", handover.beginning.pairs);
  visit_memory("start wall", handover.beginning.walls);
}

}  // namespace

ContactMemory renumbered_pairs(const ContactMemory &memory, const std::vector<uint32_t> &numbers) {
  return renumbered(memory, [&](hg_pair &pair) {
    pair.a = static_cast<int32_t>(numbers[static_cast<size_t>(pair.a)]);
    pair.b = static_cast<int32_t>(numbers[static_cast<size_t>(pair.b)]);
    if (pair.a < pair.b) return false;
    std::swap(pair.a, pair.b);
    return true;
  });
}

ContactMemory renumbered_walls(const ContactMemory &memory, const std::vector<uint32_t> &numbers) {
  return renumbered(memory, [&](hg_pair &pair) {
    pair.a = static_cast<int32_t>(numbers[static_cast<size_t>(pair.a)]);
    return false;
  });
}

void save_handover(const Handover &handover, Checkpoint &checkpoint) {
  checkpoint.put_value("start step", handover.beginning.step);
  checkpoint.put_value("start time", handover.beginning.time);
  checkpoint.put_value("start image offset", handover.beginning.image_offset);
  visit_arrays(handover, [&](const std::string &name, const auto &items) { checkpoint.put(name, items); });
}

Handover restore_handover(const Checkpoint &checkpoint) {
  Handover handover;
  handover.beginning.step = checkpoint.get_value<uint64_t>("start step");
  handover.beginning.time = checkpoint.get_value<double>("start time");
  handover.beginning.image_offset = checkpoint.get_value<double>("start image offset");
  visit_arrays(handover, [&](const std::string &name, auto &items) { checkpoint.get_all(name, items); });
  return handover;
}

}  // namespace dem
