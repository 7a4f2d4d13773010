// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Who comes and who goes.
#include "dem/state/exchange.hpp"

#include "dem/setup/shortest_contact.hpp"
#include "packing/random.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

uint64_t interval_of(const Setup &setup) {
  if (!setup.exchanges()) return 0;
  constexpr double kMost = 1000;  // where nothing can move
  return static_cast<uint64_t>(std::clamp(std::round(shortest_contact(setup).duration / setup.time_step), 1.0, kMost));
}

// Of the numbers that choose places for particle `number` at a step.
packing::Random random_of(const Inflow &inflow, uint64_t number, uint64_t step) {
  return packing::Random(inflow.seed + 0x9e3779b97f4a7c15u * (number + 1) + 0xbf58476d1ce4e5b9u * step);
}

}  // namespace

template <int D, class Real>
Exchange<D, Real>::Exchange(const Setup &setup)
    : inflows_(setup.inflows),
      removals_(setup.removals),
      passed_(inflows_.size() + removals_.size()),
      boundary_(make_boundary<D, double>(setup)),
      start_(setup.beginning.time),
      interval_(interval_of(setup)) {}

template <int D, class Real>
std::vector<uint32_t> Exchange<D, Real>::staying(const Bodies<D, Real> &bodies) {
  std::vector<uint32_t> result;
  result.reserve(bodies.count());
  for (size_t i = 0; i < bodies.count(); i++) {
    Vec<D, double> x = bodies.position(i).template cast<double>();
    for (int axis = 0; axis < D; axis++)
      x[axis] -= boundary_.period[axis] * std::floor((x[axis] - boundary_.low[axis]) * boundary_.inverse_period[axis]);
    size_t k = 0;
    while (k < removals_.size() && !removals_[k].holds(x.data(), D)) k++;
    if (k == removals_.size()) {
      result.push_back(static_cast<uint32_t>(i));
      continue;
    }
    Passed &passed = passed_[inflows_.size() + k];
    passed.count++;
    if (bodies.inverse_mass(i) > 0) passed.mass += 1 / static_cast<double>(bodies.inverse_mass(i));
  }
  return result;
}

// Partners are decided by where they are now; who could be one is asked of the search, which knows where they were.
template <int D, class Real>
bool Exchange<D, Real>::is_free(const Newcomer<D> &one, const std::vector<Newcomer<D>> &others,
                                const Bodies<D, Real> &bodies, const ContactSearch &search,
                                const Surfaces<D> &surfaces) const {
  const auto overlaps = [&](const Vec<D, double> &center, double radius) {
    Vec<D, double> separation = center - one.center;
    boundary_.template nearest<kPeriodic>(separation);
    const double reach = radius + one.radius;
    return separation.squaredNorm() < reach * reach;
  };
  for (int32_t wall = 0; wall < 2 * D; wall++) {
    if (!boundary_.walled[axis_of(wall)]) continue;
    if (wall_overlap(boundary_, one.center[axis_of(wall)], one.radius, wall) > 0) return false;
  }
  for (const Surface<D> &surface : surfaces.surfaces()) {
    if (nearest_point<D>(surface, one.center).distance < one.radius) return false;
  }
  for (const Newcomer<D> &other : others) {
    if (overlaps(other.center, other.radius)) return false;
  }
  for (const int32_t id : search.near_ball(one.center.data(), one.radius)) {
    const auto i = static_cast<size_t>(id);
    if (overlaps(bodies.position(i).template cast<double>(), static_cast<double>(bodies.radius(i)))) return false;
  }
  return true;
}

// Each inflow keeps its order: one that finds no room is waited for, else the mixture of sizes would change.
template <int D, class Real>
std::vector<Newcomer<D>> Exchange<D, Real>::coming(double time, uint64_t step, const Bodies<D, Real> &bodies,
                                                   const ContactSearch &search, const Surfaces<D> &surfaces) {
  constexpr int kTries = 64;
  std::vector<Newcomer<D>> result;
  for (size_t k = 0; k < inflows_.size(); k++) {
    const Inflow &inflow = inflows_[k];
    Passed &passed = passed_[k];
    const double span = std::min(time, inflow.until - start_);
    const double due = std::min(std::floor(inflow.rate * span * (1 + 1e-12)), static_cast<double>(inflow.most));
    const Vec<D, double> low = Eigen::Map<const Vec<D, double>>(inflow.box.low),
                         size = Eigen::Map<const Vec<D, double>>(inflow.box.high) - low;
    bool has_room = true;
    while (has_room && static_cast<double>(passed.count) < due) {
      packing::Random random = random_of(inflow, passed.count, step);
      const size_t place = passed.count % inflow.radii.size();
      Newcomer<D> one;
      one.velocity = Eigen::Map<const Vec<D, double>>(inflow.velocity);
      one.radius = inflow.radii[place];
      one.mass = inflow.masses[place];
      one.material = static_cast<uint8_t>(std::max(inflow.material, 0));
      has_room = false;
      for (int tries = 0; tries < kTries && !has_room; tries++) {
        for (int axis = 0; axis < D; axis++)
          one.center[axis] = low[axis] + one.radius + random.uniform() * (size[axis] - 2 * one.radius);
        has_room = is_free(one, result, bodies, search, surfaces);
      }
      if (!has_room) break;
      result.push_back(one);
      passed.count++;
      passed.mass += one.mass;
    }
    passed.waiting = static_cast<uint64_t>(std::max(0.0, due - static_cast<double>(passed.count)));
  }
  return result;
}

template <int D, class Real>
std::vector<Passage> Exchange<D, Real>::passages() const {
  std::vector<Passage> result;
  for (size_t k = 0; k < passed_.size(); k++) {
    const bool comes = k < inflows_.size();
    const std::string &name = comes ? inflows_[k].box.name : removals_[k - inflows_.size()].name;
    result.push_back({name, passed_[k].count, passed_[k].mass, passed_[k].waiting});
  }
  return result;
}

template <int D, class Real>
void Exchange<D, Real>::save(Checkpoint &checkpoint) const {
  if (!empty()) checkpoint.put("exchange", passed_);
}

template <int D, class Real>
void Exchange<D, Real>::restore(const Checkpoint &checkpoint) {
  if (!empty()) checkpoint.get("exchange", passed_);
}

template class Exchange<2, double>;
template class Exchange<3, double>;
template class Exchange<2, float>;
template class Exchange<3, float>;

}  // namespace dem
