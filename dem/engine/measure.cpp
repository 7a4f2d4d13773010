// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state.
#include "dem/engine/measure.hpp"

#include "dem/effects/body_force.hpp"
#include "dem/effects/choice.hpp"
#include "dem/engine/step_load.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

template <int D>
using Vector = Vec<D, double>;

// The effects that a normal force has.
constexpr EffectSet kNormalEffects = kContactEffects & ~effects_with_history();

struct Spring {
  double force, energy;
  double stiffness;  // dF/dd, which the tangential springs follow
  double damping;    // of the dashpot beside it
};

template <EffectSet E>
Spring spring_of(const ContactLaw<double> &law, const NormalContact<double> &contact) {
  const NormalForce<double> force = normal_force<E>(law, contact);
  return {force.value, elastic_energy<E>(law, contact, force), force.stiffness, force.damping};
}

size_t material_of(const Snapshot &state, size_t i) { return state.material_ids.empty() ? 0 : state.material_ids[i]; }

template <int D>
void measure_particles(const Setup &setup, const Snapshot &state, Measurement &result) {
  Vector<D> momentum = Vector<D>::Zero();
  Spin<D, double> angular = Spin<D, double>::Zero();
  const auto body_force = make_body_force<D, double>(setup);
  const auto potential =
      choose<kBodyEffects, double>(setup.effects, [](auto set) { return &potential_energy<decltype(set)::value, D>; });
  for (size_t i = 0; i < state.radii.size(); i++) {
    const double m = state.masses[i];
    if (!std::isfinite(m)) continue;
    const Vector<D> x = vector_at<Vector<D>>(state.centers, i), v = vector_at<Vector<D>>(state.velocities, i);
    result.translation += 0.5 * m * v.squaredNorm();
    result.gravity += potential(body_force, x, m);
    momentum += m * v;
    angular += moment<D, double>(x, m * v);
    if (state.spins.empty()) continue;
    const Spin<D, double> spin = vector_at<Spin<D, double>>(state.spins, i);
    const double inertia = m * state.radii[i] * state.radii[i] / inverse_shape(D);
    result.rotation += 0.5 * inertia * spin.squaredNorm();
    angular += inertia * spin;
  }
  std::copy_n(momentum.data(), D, result.momentum);
  std::copy_n(angular.data(), angular.size(), result.angular_momentum);
}

// Adds contact p to the sums; its spring. Surfaces have no closing speed here.
template <int D>
Spring add_contact(const Setup &setup, const ContactLaw<double> &law, const ContactState<D> &contacts, size_t p,
                   const NormalContact<double> &contact, double smaller_radius, Measurement &result) {
  const Spring spring = choose<kNormalEffects, double>(
      setup.effects, [](auto set) { return &spring_of<decltype(set)::value>; })(law, contact);
  result.contact += spring.energy;
  for (const EffectRow &row : kEffects) {
    if (row.history == nullptr || !has(setup.effects, row.effect)) continue;
    const auto &stretches = contacts.history[history_of(row.effect)];
    const double stiffness = stiffness_ratio(law, row.effect) * spring.stiffness;
    if (!stretches.empty()) result.contact += 0.5 * stiffness * stretches[p].squaredNorm();
  }
  result.largest_overlap = std::max(result.largest_overlap, contact.overlap / smaller_radius);
  return spring;
}

template <int D>
void measure_pairs(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                   const ContactState<D> &contacts, std::vector<LoadedContact<D>> &loaded, Measurement &result) {
  const LawTable<double> laws(setup, Partner::kParticle);
  const auto nearest = choose<kImageEffects, double>(
      setup.effects, [](auto set) { return &Boundary<D, double>::template nearest<decltype(set)::value>; });
  for (size_t p = 0; p < contacts.list.size(); p++) {
    const auto a = static_cast<size_t>(contacts.list[p].a), b = static_cast<size_t>(contacts.list[p].b);
    // Neighbours in a wall of fixed particles may overlap as they like: nothing comes of it.
    if (!std::isfinite(state.masses[a]) && !std::isfinite(state.masses[b])) continue;
    Vector<D> separation = vector_at<Vector<D>>(state.centers, b) - vector_at<Vector<D>>(state.centers, a);
    (boundary.*nearest)(separation);
    Vector<D> normal;
    const double distance = normalize<D>(separation, normal), overlap = state.radii[a] + state.radii[b] - distance;
    const ContactLaw<double> &law = laws.at(material_of(state, a), material_of(state, b));
    const NormalContact<double> contact{overlap, 0, 1 / state.masses[a] + 1 / state.masses[b],
                                        1 / state.radii[a] + 1 / state.radii[b],
                                        law.share[0] / state.radii[a] + law.share[1] / state.radii[b]};
    const double smaller = std::min(state.radii[a], state.radii[b]);
    const Spring spring = add_contact<D>(setup, law, contacts, p, contact, smaller, result);
    result.virial += spring.force * distance;
    loaded.push_back({a, b, normal, spring.stiffness, spring.damping, law.tangential_ratio, law.rolling_ratio,
                      1 / contact.inverse_radius});
    if (overlap > 0) result.contacts++;
  }
}

template <int D>
void measure_walls(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                   const ContactState<D> &contacts, std::vector<LoadedContact<D>> &loaded, Measurement &result) {
  const LawTable<double> laws(setup, Partner::kWall);
  for (size_t p = 0; p < contacts.list.size(); p++) {
    const auto i = static_cast<size_t>(contacts.list[p].a);
    const int32_t wall = contacts.list[p].b;
    const double x = state.centers[i * D + static_cast<size_t>(axis_of(wall))];
    const ContactLaw<double> &law = laws.at(material_of(state, i), boundary.materials[wall]);
    const NormalContact<double> contact{wall_overlap(boundary, x, state.radii[i], wall), 0, 1 / state.masses[i],
                                        1 / state.radii[i], 1 / state.radii[i]};
    const Spring spring = add_contact<D>(setup, law, contacts, p, contact, state.radii[i], result);
    loaded.push_back({i, LoadedContact<D>::kWall, Vector<D>::Unit(axis_of(wall)), spring.stiffness, spring.damping,
                      law.tangential_ratio, law.rolling_ratio, state.radii[i]});
    if (contact.overlap > 0) result.wall_contacts++;
    if (contact.overlap > state.radii[i]) result.behind_walls++;
  }
}

}  // namespace

template <int D>
Measurement measure_state(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                          const ContactState<D> &pairs, const ContactState<D> &walls) {
  Measurement result;
  result.time = state.time;
  measure_particles<D>(setup, state, result);
  std::vector<LoadedContact<D>> loaded;
  measure_pairs<D>(setup, boundary, state, pairs, loaded, result);
  measure_walls<D>(setup, boundary, state, walls, loaded, result);
  result.step_load = step_load<D>(setup, state, loaded);
  return result;
}

template Measurement measure_state(const Setup &, const Boundary<2, double> &, const Snapshot &,
                                   const ContactState<2> &, const ContactState<2> &);
template Measurement measure_state(const Setup &, const Boundary<3, double> &, const Snapshot &,
                                   const ContactState<3> &, const ContactState<3> &);

}  // namespace dem
