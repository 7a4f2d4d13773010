// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulation leaves to the next one.
#include "dem/state/handover.hpp"

#include "dem/setup/space_order.hpp"

#include <algorithm>
#include <string>

namespace dem {
namespace {

// Of a contact whose particles change places: slip is the way of a against b, so it turns round; roll is a turn about
// the normal, which turns round, too, and stays.
bool turns_round(size_t history) { return history == history_of(kFriction); }

// rename(pair) gives its particles their new numbers; returns -1 if they change places, 0 if one is gone, else 1.
template <class Rename>
ContactMemory renumbered(const ContactMemory &memory, Rename rename) {
  const size_t count = memory.pairs.size();
  std::vector<hg_pair> pairs = memory.pairs;
  std::vector<int> signs;
  std::vector<size_t> order;
  for (size_t p = 0; p < count; p++) {
    signs.push_back(rename(pairs[p]));
    if (signs[p] != 0) order.push_back(p);
  }
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
void visit_arrays(SomeHandover &handover, const std::string &when, Visit visit) {
  visit(when + " centers", handover.particles.centers);
  visit(when + " velocities", handover.particles.velocities);
  visit(when + " radii", handover.particles.radii);
  visit(when + " masses", handover.particles.masses);
  visit(when + " spins", handover.particles.spins);
  visit(when + " materials", handover.particles.material_ids);
  visit_memory(when + " pair", handover.beginning.pairs, visit);
  visit_memory(when + " wall", handover.beginning.walls, visit);
  visit_memory(when + " surface", handover.beginning.surfaces, visit);
}

void save_places(const std::vector<NamedPlace> &places, const std::string &when, Checkpoint &checkpoint) {
  std::vector<std::string> names;
  std::vector<double> numbers;
  std::vector<uint64_t> surfaces;
  for (const NamedPlace &wall : places) {
    names.push_back(wall.name);
    numbers.insert(numbers.end(), wall.place.shift, wall.place.shift + 3);
    numbers.insert(numbers.end(), {wall.place.angle, wall.place.press_speed});
    surfaces.insert(surfaces.end(), {wall.first_surface, wall.surface_count});
  }
  checkpoint.put_texts(when + " wall names", names);
  checkpoint.put(when + " wall places", numbers);
  checkpoint.put(when + " wall surfaces", surfaces);
}

std::vector<NamedPlace> restore_places(const std::string &when, const Checkpoint &checkpoint) {
  const std::vector<std::string> names = checkpoint.get_texts(when + " wall names");
  std::vector<uint64_t> surfaces;
  checkpoint.get_all(when + " wall surfaces", surfaces);
  std::vector<NamedPlace> places(surfaces.size() / 2);
  std::vector<double> numbers(5 * places.size());
  checkpoint.get(when + " wall places", numbers);
  if (names.size() != places.size())
    throw Error("the checkpoint names " + std::to_string(names.size()) + " walls of " + std::to_string(places.size()));
  for (size_t k = 0; k < places.size(); k++) {
    places[k].name = names[k];
    std::copy_n(&numbers[5 * k], 3, places[k].place.shift);
    places[k].place.angle = numbers[5 * k + 3];
    places[k].place.press_speed = numbers[5 * k + 4];
    places[k].first_surface = surfaces[2 * k];
    places[k].surface_count = surfaces[2 * k + 1];
  }
  return places;
}

}  // namespace

Handover without(const Handover &handover, const std::vector<bool> &gone) {
  std::vector<uint32_t> kept, numbers(gone.size(), kGone);
  for (size_t i = 0; i < gone.size(); i++) {
    if (gone[i]) continue;
    numbers[i] = static_cast<uint32_t>(kept.size());
    kept.push_back(static_cast<uint32_t>(i));
  }
  Handover result = handover;
  reorder(result.particles, kept);
  result.beginning.pairs = renumbered_pairs(handover.beginning.pairs, numbers);
  result.beginning.walls = renumbered_walls(handover.beginning.walls, numbers);
  result.beginning.surfaces = renumbered_walls(handover.beginning.surfaces, numbers);
  return result;
}

ContactMemory renumbered_pairs(const ContactMemory &memory, const std::vector<uint32_t> &numbers) {
  return renumbered(memory, [&](hg_pair &pair) {
    const uint32_t a = numbers[static_cast<size_t>(pair.a)], b = numbers[static_cast<size_t>(pair.b)];
    pair = {static_cast<int32_t>(std::min(a, b)), static_cast<int32_t>(std::max(a, b))};
    return a == kGone || b == kGone ? 0 : a < b ? 1 : -1;
  });
}

ContactMemory renumbered_walls(const ContactMemory &memory, const std::vector<uint32_t> &numbers) {
  return renumbered(memory, [&](hg_pair &pair) {
    const uint32_t a = numbers[static_cast<size_t>(pair.a)];
    pair.a = static_cast<int32_t>(a);
    return a == kGone ? 0 : 1;
  });
}

void save_handover(const Handover &handover, const std::string &when, Checkpoint &checkpoint) {
  checkpoint.put_value(when + " step", handover.beginning.step);
  checkpoint.put_value(when + " time", handover.beginning.time);
  checkpoint.put_value(when + " image offset", handover.beginning.image_offset);
  visit_arrays(handover, when, [&](const std::string &name, const auto &items) { checkpoint.put(name, items); });
  save_places(handover.beginning.wall_places, when, checkpoint);
}

Handover restore_handover(const std::string &when, const Checkpoint &checkpoint) {
  Handover handover;
  handover.beginning.step = checkpoint.get_value<uint64_t>(when + " step");
  handover.beginning.time = checkpoint.get_value<double>(when + " time");
  handover.beginning.image_offset = checkpoint.get_value<double>(when + " image offset");
  visit_arrays(handover, when, [&](const std::string &name, auto &items) { checkpoint.get_all(name, items); });
  handover.beginning.wall_places = restore_places(when, checkpoint);
  return handover;
}

}  // namespace dem
