// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Every table and key a scene can have, with what it means.
#include "dem/scene/keys.hpp"

#include "dem/base/error.hpp"

namespace scene {

const std::vector<TableDoc> &all_tables() {
  static const std::vector<TableDoc> tables = {
      {"", "the top of the file"},
      {"particles", "particles, as an array of tables [[particles]]; each names one source: file, pack, lattice or at"},
      {"particles.pack", "a packing made on the spot, as by hgrid pack"},
      {"particles.lattice", "a lattice"},
      {"box", "the box; without it that of the pack or file, else none"},
      {"contact", "linear elastic contacts; needed unless there is [hertz]"},
      {"time", "how far and in what steps"},
      {"run", "how the work is done; none of it changes results, but for precision"},
      {"output", "what is written"},
      {"dissipation", "effect: collisions lose energy"},
      {"gravity", "effect: weight"},
      {"friction", "effect: tangential springs with sliders, and rotation"},
      {"rolling", "effect: resistance against rolling; needs [friction]"},
      {"adhesion", "effect: linear attraction near contact; not with [hertz]"},
      {"drag", "effect: Stokes drag 6 pi eta r v of a fluid at rest"},
      {"periodic", "effect: axes without ends"},
      {"growth", "effect: all radii grow at constant material density, R (1 + rate t)"},
      {"hertz", "effect: Hertz contacts instead of linear ones"},
      {"shear", "effect: Lees-Edwards shear along x with the gradient along y; needs periodic x and y"}};
  return tables;
}

const std::vector<Key> &all_keys() {
  static const std::vector<Key> keys = {
      {"", "title", Kind::kText, kPure, "none", "one line about the scene"},
      {"", "dimension", Kind::kCount, kPure, "3", "2 (discs) or 3 (spheres)"},

      {"particles", "file", Kind::kText, kPure, "none", "a particle file, relative to the scene's folder"},
      {"particles", "at", Kind::kList, kLength, "none", "centres, a list of vectors"},
      {"particles", "radius", Kind::kNumber, kLength, "needed for at and lattice",
       "of all particles of the group; of the smallest particle of a pack (1)"},
      {"particles", "density", Kind::kNumber, kDensity, "1", "of the material; per area in two dimensions (kg/m^2)"},
      {"particles", "velocity", Kind::kVector, kVelocity, "0", "of all particles of the group"},
      {"particles", "spin", Kind::kVector, kSpin, "0",
       "angular velocity (with [friction]); one number in a list in 2D"},
      {"particles", "temperature", Kind::kNumber, kEnergy, "0",
       "kT: adds Gaussian velocities of that energy per degree of freedom, without drift of the group"},
      {"particles", "overlap", Kind::kNumber, kPure, "none",
       "instead of temperature: so that two of the smallest particles overlap by this share of their radius on "
       "average"},
      {"particles", "seed", Kind::kCount, kPure, "1", "of the velocities"},
      {"particles", "fixed", Kind::kFlag, kPure, "false", "keep their velocity whatever pushes them"},

      {"particles.pack", "law", Kind::kText, kPure, "mono", "mono, two-sizes, uniform-size or uniform-volume"},
      {"particles.pack", "count", Kind::kCount, kPure, "needed", "number of particles"},
      {"particles.pack", "ratio", Kind::kNumber, kPure, "1; 10; 50; 50", "largest over smallest radius, by law"},
      {"particles.pack", "fraction", Kind::kNumber, kPure, "needed", "share of the box that the particles fill"},
      {"particles.pack", "method", Kind::kText, kPure, "relax",
       "relax: small overlaps stay; event: grown without any, which takes longer"},
      {"particles.pack", "seed", Kind::kCount, kPure, "1", "same seed, same packing"},
      {"particles.pack", "sweeps", Kind::kCount, kPure, "60", "sweeps that push overlapping particles apart"},

      {"particles.lattice", "kind", Kind::kText, kPure, "cubic", "cubic or hexagonal (close packing)"},
      {"particles.lattice", "counts", Kind::kVector, kPure, "needed", "particles along each axis"},
      {"particles.lattice", "spacing", Kind::kNumber, kLength, "2 radii", "of nearest neighbours"},
      {"particles.lattice", "origin", Kind::kVector, kLength, "0", "the first centre"},
      {"particles.lattice", "jitter", Kind::kNumber, kLength, "0", "largest random shift along each axis"},
      {"particles.lattice", "seed", Kind::kCount, kPure, "1", "of the shifts"},

      {"box", "min", Kind::kVector, kLength, "0", "lower corner"},
      {"box", "max", Kind::kVector, kLength, "needed", "upper corner"},
      {"box", "walls", Kind::kText, kPure, "all axes that are not periodic", "axes with walls at both ends, e.g. xz"},

      {"contact", "stiffness", Kind::kNumber, kStiffness, "needed", "k of the force k d at overlap d"},

      {"time", "end", Kind::kNumber, kTime, "needed, or steps", "when the simulation ends"},
      {"time", "steps", Kind::kCount, kPure, "by end", "number of steps instead of end"},
      {"time", "step", Kind::kNumber, kTime, "by steps_per_contact", "the time step"},
      {"time", "steps_per_contact", Kind::kNumber, kPure, "50",
       "time steps in the shortest contact; fewer than 10 are refused"},
      {"time", "scheme", Kind::kText, kPure, "velocity-verlet",
       "velocity-verlet, symplectic-euler, leapfrog or forest-ruth"},

      {"run", "threads", Kind::kCount, kPure, "1", "0: all that the machine offers"},
      {"run", "skin", Kind::kNumber, kLength, "0.1 of the smallest radius",
       "how far particles may move before the library searches candidates anew; 0: in every step"},
      {"run", "precision", Kind::kText, kPure, "double", "double or float numbers for the state"},

      {"output", "directory", Kind::kText, kPure, "the scene's name + -output", "relative to where hgrid runs"},
      {"output", "every", Kind::kNumber, kTime, "none", "time between pictures of the state"},
      {"output", "formats", Kind::kTexts, kPure, "vtp", "vtp (ParaView), xyz (OVITO, extended XYZ)"},
      {"output", "energy", Kind::kNumber, kTime, "a hundredth of the run", "time between the rows of energy.csv"},
      {"output", "checkpoint", Kind::kNumber, kTime, "none", "time between checkpoints; the last one stays"},

      {"dissipation", "restitution", Kind::kNumber, kPure, "needed", "e of every collision, 0 < e <= 1"},
      {"gravity", "acceleration", Kind::kVector, kAcceleration, "needed", "of free fall"},
      {"friction", "coefficient", Kind::kNumber, kPure, "needed", "tangential over normal force at most"},
      {"friction", "stiffness", Kind::kNumber, kPure, "2/7", "of the tangential spring over the normal one (linear)"},
      {"rolling", "coefficient", Kind::kNumber, kPure, "needed", "rolling over normal force at most"},
      {"rolling", "stiffness", Kind::kNumber, kPure, "2/7", "of the rolling spring over the normal one"},
      {"adhesion", "force", Kind::kNumber, kForce, "needed", "the pull-off force"},
      {"adhesion", "range", Kind::kNumber, kLength, "needed", "gap of the surfaces at which attraction ends"},
      {"drag", "viscosity", Kind::kNumber, kViscosity, "needed", "eta of the fluid"},
      {"periodic", "axes", Kind::kText, kPure, "needed", "e.g. xyz"},
      {"growth", "rate", Kind::kNumber, kRate, "needed", "of the radii, relative to those at the start"},
      {"growth", "end", Kind::kNumber, kTime, "never", "when growth stops"},
      {"hertz", "young_modulus", Kind::kNumber, kPressure, "needed", "of the particles"},
      {"hertz", "poisson_ratio", Kind::kNumber, kPure, "needed", "of the particles"},
      {"hertz", "wall_young_modulus", Kind::kNumber, kPressure, "rigid", "of the walls"},
      {"hertz", "wall_poisson_ratio", Kind::kNumber, kPure, "0", "of the walls"},
      {"hertz", "impact_speed", Kind::kNumber, kVelocity, "twice the fastest at the start",
       "fastest approach to reckon the time step with"},
      {"shear", "rate", Kind::kNumber, kRate, "needed", "du_x / dy; particles start with that profile added"}};
  return keys;
}

const Key &key_of(std::string_view table, std::string_view name) {
  for (const Key &key : all_keys()) {
    if (key.table == table && key.name == name) return key;
  }
  throw std::logic_error("no key '" + std::string(name) + "' in table '" + std::string(table) + "'");
}

std::vector<std::string> names_in(std::string_view table) {
  std::vector<std::string> names;
  for (const Key &key : all_keys()) {
    if (key.table == table) names.emplace_back(key.name);
  }
  for (const TableDoc &doc : all_tables()) {
    const std::string_view name = doc.name;
    if (name.empty()) continue;
    const size_t dot = name.rfind('.');
    const bool part = dot == std::string_view::npos ? table.empty() : table == name.substr(0, dot);
    if (part) names.emplace_back(dot == std::string_view::npos ? name : name.substr(dot + 1));
  }
  return names;
}

std::string key_reference() {
  std::string result;
  for (const TableDoc &table : all_tables()) {
    const std::string name = table.name;
    result += (name.empty() ? "Top of the file" : "`[" + name + "]` - " + table.meaning) + std::string("\n\n");
    result += "| key | unit | left out | meaning |\n|---|---|---|---|\n";
    for (const Key &key : all_keys()) {
      if (key.table != name) continue;
      const bool measured = key.kind == Kind::kNumber || key.kind == Kind::kVector || key.kind == Kind::kList;
      result += "| `" + std::string(key.name) + "` | " + (measured ? describe(key.unit) : "-") + " | " + key.fallback +
                " | " + key.meaning + " |\n";
    }
    result += "\n";
  }
  return result;
}

}  // namespace scene
