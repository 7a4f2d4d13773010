// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Looking at a simulation over ranks, saving and restoring it.
#include "dem/engine/acting_contacts.hpp"
#include "dem/engine/measure.hpp"
#include "dem/engine/snapshots.hpp"
#include "dem_mpi/exact_sum.hpp"
#include "dem_mpi/rank_simulation.hpp"
#include "dem_mpi/springs.hpp"

#include <algorithm>
#include <string>

namespace dem::ranks {
namespace {

// The numbers of a measurement that are sums: visit(number).
template <class SomeMeasurement, class Visit>
void visit_sums(SomeMeasurement &m, Visit visit) {
  for (auto *number : {&m.translation, &m.rotation, &m.contact, &m.gravity, &m.virial}) visit(*number);
  for (auto &number : m.momentum) visit(number);
  for (auto &number : m.angular_momentum) visit(number);
}

class ExactMeasurement {
 public:
  // What one particle or one contact has.
  void add(const Measurement &one) {
    size_t k = 0;
    visit_sums(one, [&](const double &number) { sums_[k++].add(number); });
    total_.contacts += one.contacts;
    total_.wall_contacts += one.wall_contacts;
    total_.behind_walls += one.behind_walls;
    total_.largest_overlap = std::max(total_.largest_overlap, one.largest_overlap);
  }

  // Of all ranks.
  Measurement total(const Ranks &ranks) {
    std::vector<int64_t> numbers;
    for (const ExactSum &sum : sums_) numbers.insert(numbers.end(), sum.limbs(), sum.limbs() + ExactSum::kWidth);
    for (const size_t count : {total_.contacts, total_.wall_contacts, total_.behind_walls})
      numbers.push_back(static_cast<int64_t>(count));
    ranks.add_up(numbers);
    const int64_t *next = numbers.data();
    for (ExactSum &sum : sums_) {
      std::copy_n(next, ExactSum::kWidth, sum.limbs());
      next += ExactSum::kWidth;
    }
    size_t k = 0;
    visit_sums(total_, [&](double &number) { number = sums_[k++].value(); });
    for (size_t *count : {&total_.contacts, &total_.wall_contacts, &total_.behind_walls})
      *count = static_cast<size_t>(*next++);
    total_.largest_overlap = ranks.largest(total_.largest_overlap);
    return total_;
  }

 private:
  Measurement total_;
  ExactSum sums_[11];  // as many as visit_sums visits
};

}  // namespace

template <int D>
void RankSimulation<D>::visit_loads_of(const Snapshot &lagging, const LoadVisit<D> &visit) const {
  ContactState<D> of_pairs = pairs_in<D>(setup_, boundary_, lagging, pairs_.rows());
  ContactState<D> of_walls = walls_in<D>(setup_, boundary_, lagging, {walls_.data(), walls_.size()});
  std::vector<hg_pair> names;
  const auto name = [&](int32_t row) { return static_cast<int32_t>(names_[static_cast<size_t>(row)]); };
  for (const hg_pair &pair : of_pairs.list) names.push_back({name(pair.a), name(pair.b)});
  add_history(pairs_.history(), pairs_.names(), names, of_pairs);
  names.clear();
  for (const hg_pair &wall : of_walls.list) names.push_back({name(wall.a), wall.b});
  add_history(wall_history_, wall_names(), names, of_walls);
  visit_loads<D>(setup_, boundary_, lagging, of_pairs, of_walls, {}, visit);
}

template <int D>
Measurement RankSimulation<D>::measure() {
  if (lag() != 0) find_forces();
  meet();
  tell_faults();
  ExactMeasurement sums;
  ranks_.together([&] {
    const Snapshot state = snapshot_of(bodies_, owned_, setup_.effects, body_force_, lag(), 0.0);
    Snapshot lagging = snapshot_of(bodies_, bodies_.count(), setup_.effects, body_force_, 0.0, 0.0);
    lagging.material_ids = bodies_.materials;
    const ParticleMeasure<D> particle(setup_);
    for (size_t i = 0; i < owned_; i++) {
      Measurement one;
      particle.add(state, i, one);
      sums.add(one);
    }
    visit_loads_of(lagging, [&](const ContactLoad<D> &load) {
      Measurement one;
      add_contact(load, one);
      sums.add(one);
    });
  });
  Measurement result = sums.total(ranks_);
  result.time = time();
  return result;
}

template <int D>
OwnedParticles RankSimulation<D>::owned() {
  if (lag() != 0) find_forces();
  OwnedParticles result;
  static_cast<Snapshot &>(result) = snapshot_of(bodies_, owned_, setup_.effects, body_force_, lag(), 0.0);
  result.time = time();
  if (has(setup_.effects, kMaterials))
    result.material_ids.assign(bodies_.materials.begin(), bodies_.materials.begin() + static_cast<ptrdiff_t>(owned_));
  bring_into_box(setup_, result);
  result.numbers = numbers_;
  return result;
}

namespace {

void save_memory(const std::string &name, const ContactMemory &memory, Checkpoint &part) {
  visit_memory(name, memory, [&](const std::string &block, const auto &items) { part.put(block, items); });
}

ContactMemory restored_memory(const std::string &name, const Checkpoint &part) {
  ContactMemory memory;
  visit_memory(name, memory, [&](const std::string &block, auto &items) { part.get_all(block, items); });
  return memory;
}

}  // namespace

template <int D>
void RankSimulation<D>::save(Checkpoint &part) const {
  dem::save(fingerprint(), setup_, part);
  part.put_value("steps", steps_);
  part.put_value("forces known", static_cast<uint64_t>(forces_known_));
  part.put_value("last drift", last_drift_);
  part.put("names", names_.data(), owned_);
  part.put("numbers", numbers_.data(), owned_);
  visit_quantities(bodies_, [&](const char *name, size_t count, size_t width, auto numbers_of) {
    std::vector<double> numbers;
    for (size_t i = 0; i < owned_ && i < count; i++)
      numbers.insert(numbers.end(), numbers_of(i), numbers_of(i) + width);
    part.put(name, numbers);
  });
  part.put("materials", bodies_.materials.data(), bodies_.materials.empty() ? 0 : owned_);
  save_memory("pair", pairs_.memory(), part);
  save_memory("wall", wall_history_.memory_of(wall_names()), part);
}

template <int D>
Fingerprint RankSimulation<D>::fingerprint() const {
  return {D, sizeof(double), setup_.effects, count_of_all_, setup_.time_step};
}

// Adds the particles of a part to those that this rank owns.
template <int D>
void RankSimulation<D>::add_part(const Checkpoint &part) {
  require_same(fingerprint(), setup_, part);
  steps_ = part.get_value<uint64_t>("steps");
  forces_known_ = part.get_value<uint64_t>("forces known") != 0;
  last_drift_ = part.get_value<double>("last drift");
  std::vector<int64_t> names, numbers;
  part.get_all("names", names);
  part.get_all("numbers", numbers);
  const size_t first = owned_, added = names.size();
  names_.insert(names_.end(), names.begin(), names.end());
  numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
  owned_ += added;
  bodies_.resize(owned_, setup_.effects);
  visit_quantities(bodies_, [&](const char *name, size_t count, size_t width, auto numbers_of) {
    std::vector<double> values(count > 0 ? width * added : 0);
    part.get(name, values);
    for (size_t k = 0; k < values.size() / width; k++)
      std::copy_n(values.data() + k * width, width, numbers_of(first + k));
  });
  if (has(setup_.effects, kMaterials)) part.get("materials", bodies_.materials.data() + first, added);
}

template <int D>
void RankSimulation<D>::restore(const std::vector<Checkpoint> &parts) {
  ranks_.together([&] {
    std::vector<ContactMemory> pairs, walls;
    for (const Checkpoint &part : parts) {
      add_part(part);
      pairs.push_back(restored_memory("pair", part));
      walls.push_back(restored_memory("wall", part));
    }
    pairs_.remember(joined(pairs, D));
    wall_history_.begin(joined(walls, D));
  });
  // Ranks without a part; the first one has one.
  steps_ = ranks_.of_first(steps_);
  forces_known_ = ranks_.of_first(forces_known_);
  last_drift_ = ranks_.of_first(last_drift_);
}

#define DEM_INSTANTIATE(D)                                       \
  template Measurement RankSimulation<D>::measure();             \
  template OwnedParticles RankSimulation<D>::owned();            \
  template void RankSimulation<D>::save(Checkpoint &part) const; \
  template void RankSimulation<D>::restore(const std::vector<Checkpoint> &parts);

DEM_INSTANTIATE(2)
DEM_INSTANTIATE(3)

}  // namespace dem::ranks
