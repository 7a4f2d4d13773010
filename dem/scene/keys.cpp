// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Every table and key a scene can have, with what it means.
#include "dem/scene/keys.hpp"

#include "dem/effects/table.hpp"
#include "packing/size_law.hpp"
#include "particles/files/format.hpp"
#include "particles/text/lists.hpp"

#include <deque>
#include <stdexcept>
#include <utility>

namespace scene {
namespace {

// Keys point to their texts: those put together here stay as long as the program.
const char *kept(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text)).c_str();
}

// Puts before `others` the law of packings and inflows and what laws take.
std::vector<Key> with_size_laws(const std::vector<Key> &others) {
  std::vector<Key> keys;
  for (const char *table : {"particles.pack", "inflow.radii"}) {
    keys.push_back({table, "law", Kind::kText, kPure, "mono",
                    kept(particles::joined(particles::names_of(packing::size_laws()), " or "))});
    for (const packing::LawParameter *parameter : packing::law_parameters()) {
      keys.push_back({table, parameter->name, parameter->is_whole ? Kind::kCount : Kind::kNumber, kPure,
                      kept(packing::usual_values(*parameter)), kept(packing::describe(*parameter))});
    }
    keys.push_back({table, "sizes", Kind::kText, kPure, "needed for table", packing::kSizesMeaning});
  }
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

const char *format_list() {
  std::string list;
  for (const particles::Format &format : particles::writable_formats())
    list += std::string(list.empty() ? "" : ", ") + format.name + " (" + format.title + ")";
  return kept(std::move(list));
}

std::vector<TableDoc> with_effects(std::vector<TableDoc> tables) {
  for (const dem::EffectRow &row : dem::kEffects) {
    if (row.meaning == nullptr) continue;
    std::string meaning = std::string("effect: ") + row.meaning;
    if (row.needs != 0) meaning += "; needs " + dem::tables_of(row.needs);
    if (row.excludes != 0) meaning += "; not with " + dem::tables_of(row.excludes);
    tables.push_back({row.name, std::move(meaning), true});
  }
  return tables;
}

// What materials, and pairs of them, have instead of one number for all.
std::vector<Key> with_materials(std::vector<Key> keys) {
  const std::pair<const char *, const char * dem::Parameter::*> tables[] = {{"material", &dem::Parameter::in_material},
                                                                            {"pair", &dem::Parameter::in_pair}};
  for (const auto &[table, key] : tables) {
    for (const dem::Parameter &parameter : dem::kParameters) {
      if (parameter.*key == nullptr) continue;
      const std::string all = std::string("[") + table_of(parameter.effect) + "]";
      keys.push_back({table, parameter.*key, Kind::kNumber, parameter.unit, kept("that of " + all),
                      kept("instead of the " + std::string(parameter.key) + " of " + all)});
    }
  }
  return keys;
}

std::vector<Key> with_effects(std::vector<Key> keys) {
  constexpr Kind kKinds[] = {Kind::kNumber, Kind::kNumber, Kind::kVector, Kind::kText};  // by alternative of Place
  for (const dem::Parameter &parameter : dem::kParameters) {
    keys.push_back({table_of(parameter.effect), parameter.key, kKinds[parameter.place.index()], parameter.unit,
                    parameter.fallback, parameter.meaning});
  }
  return with_materials(std::move(keys));
}

}  // namespace

const std::vector<TableDoc> &all_tables() {
  static const std::vector<TableDoc> tables = with_effects(std::vector<TableDoc>{
      {"", "the top of the file"},
      {"particles", "particles, as an array of tables [[particles]]; each names one source: file, pack, lattice or at",
       true},
      {"particles.pack", "a packing made on the spot, as by hgrid pack"},
      {"particles.lattice", "a lattice"},
      {"material", "materials, as an array of tables [[material]]; without any all is of the numbers in other tables"},
      {"pair", "what two materials share, as an array of tables [[pair]]; particles and walls alike", true},
      {kStage, "parts of the run, as an array of tables [[stage]]: what differs from the scene; false takes away"},
      {"box", "the box; without it that of the pack or file, else none", true},
      {"wall", "a wall beside the box's, as an array of tables [[wall]]: a plane, cylinder or triangle mesh", true},
      {"inflow", "where particles come in, as an array of tables [[inflow]]; not with [shear] and [growth]", true},
      {"inflow.radii", "the sizes of those that come in"},
      {"removal", "where particles go out, as an array of tables [[removal]]; not with [shear] and [growth]", true},
      {"region", "a box in regions.csv, as an array of tables [[region]]", true},
      {dem::kLinearName, "linear elastic contacts; needed unless there is [hertz]", true},
      {"time", "how far and in what steps", true},
      {"run", "how the work is done; none of it changes results, but for precision"},
      {"output", "what is written", true}});
  return tables;
}

const std::vector<Key> &all_keys() {
  static const std::vector<Key> keys = with_effects(with_size_laws(
      {{"", "title", Kind::kText, kPure, "none", "one line about the scene"},
       {"", "dimension", Kind::kCount, kPure, "3", "2 (discs) or 3 (spheres)"},

       {"particles", "file", Kind::kText, kPure, "none",
        "a particle file, relative to the scene's folder; velocities, spins, masses, materials in it count"},
       {"particles", "at", Kind::kList, kLength, "none", "centres, a list of vectors"},
       {"particles", "radius", Kind::kNumber, kLength, "needed for at and lattice",
        "of all particles of the group; of the smallest particle of a pack (1; table: as in it)"},
       {"particles", "density", Kind::kNumber, kDensity, "1",
        "of the material; per area in two dimensions (kg/m^2); of a file its masses"},
       {"particles", "material", Kind::kText, kPure, "needed with [[material]]", "its name; of a file its materials"},
       {"particles", "velocity", Kind::kVector, kVelocity, "0",
        "of all particles of the group; added to those of a file"},
       {"particles", "spin", Kind::kVector, kSpin, "0",
        "angular velocity (with [friction]); one number in a list in 2D"},
       {"particles", "temperature", Kind::kNumber, kEnergy, "0",
        "kT: adds Gaussian velocities of that energy per degree of freedom, without drift of the group"},
       {"particles", "overlap", Kind::kNumber, kPure, "none",
        "instead of temperature: so that two of the smallest particles overlap by this share of their radius on "
        "average"},
       {"particles", "seed", Kind::kCount, kPure, "1", "of the velocities"},
       {"particles", "fixed", Kind::kFlag, kPure, "false", "keep their velocity whatever pushes them"},

       {"particles.pack", "count", Kind::kCount, kPure, "needed", "number of particles"},
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

       {"material", "name", Kind::kText, kPure, "needed", "for groups of particles, the box and pairs"},
       {"material", "density", Kind::kNumber, kDensity, "that of the groups", "per area in two dimensions (kg/m^2)"},
       {"pair", "materials", Kind::kTexts, kPure, "needed", "the names of two, or twice that of one"},
       {kStage, "name", Kind::kText, kPure, "its number", "in messages"},
       {kStage, "duration", Kind::kNumber, kTime, "needed, or steps", "how long the stage lasts"},
       {kStage, "steps", Kind::kCount, kPure, "by duration", "its number of steps instead"},
       {kStage, "remove", Kind::kList, kLength, "none",
        "lower and upper corner: particles whose centres lie between go when the stage begins"},

       {"box", "min", Kind::kVector, kLength, "0", "lower corner"},
       {"box", "max", Kind::kVector, kLength, "needed", "upper corner"},
       {"box", "walls", Kind::kText, kPure, "all axes that are not periodic", "axes with walls at both ends, e.g. xz"},
       {"box", "material", Kind::kText, kPure, "none: walls as [contact] or [hertz] says", "of the walls, its name"},

       {"wall", "name", Kind::kText, kPure, "wall- and its number", "in walls.csv, and from stage to stage"},
       {"wall", "point", Kind::kVector, kLength, "needed; mesh: 0",
        "on the plane, on the axis of the cylinder; where the origin of the mesh goes"},
       {"wall", "normal", Kind::kVector, kPure, "needed for planes", "of a plane, to the side of the particles"},
       {"wall", "radius", Kind::kNumber, kLength, "none", "of a cylinder that holds particles inside"},
       {"wall", "file", Kind::kText, kPure, "none", "an STL file, relative to the scene's folder (3D)"},
       {"wall", "scale", Kind::kNumber, kPure, "1", "lengths for one in the file"},
       {"wall", "material", Kind::kText, kPure, "none: as [contact] or [hertz] says", "its name"},
       {"wall", "velocity", Kind::kVector, kVelocity, "0", "shifts the wall"},
       {"wall", "swing", Kind::kVector, kLength, "0", "shifts it by this times sin(2 pi frequency t)"},
       {"wall", "frequency", Kind::kNumber, kRate, "0", "of the swing"},
       {"wall", "turning", Kind::kNumber, kRate, "0", "angle per time: planes turn about their normal"},
       {"wall", "axis", Kind::kVector, kPure, "needed for cylinders; mesh: z", "of cylinders and turning meshes (3D)"},
       {"wall", "pivot", Kind::kVector, kLength, "0", "on the axis of a turning mesh"},
       {"wall", "force", Kind::kNumber, kForce, "none", "a plane moves along its normal so that particles bear this"},
       {"wall", "speed", Kind::kNumber, kVelocity, "needed for force",
        "of such a plane at most, where nothing resists"},

       {"inflow", "name", Kind::kText, kPure, "inflow- and its number", "in exchange.csv"},
       {"inflow", "min", Kind::kVector, kLength, "needed", "lower corner of the box in which particles appear wholly"},
       {"inflow", "max", Kind::kVector, kLength, "needed", "upper corner"},
       {"inflow", "rate", Kind::kNumber, kRate, "needed",
        "particles per time since the stage began; who finds no room waits"},
       {"inflow", "count", Kind::kCount, kPure, "any", "how many come in a stage at most"},
       {"inflow", "until", Kind::kNumber, kTime, "the end", "when the last is due, in the time of the run"},
       {"inflow", "radius", Kind::kNumber, kLength, "needed without radii",
        "of all of them; with radii of the smallest (1; table: as in it)"},
       {"inflow", "density", Kind::kNumber, kDensity, "1", "as of [[particles]]"},
       {"inflow", "material", Kind::kText, kPure, "needed with [[material]]", "its name"},
       {"inflow", "velocity", Kind::kVector, kVelocity, "0", "with which they appear"},
       {"inflow", "seed", Kind::kCount, kPure, "1", "of the places and the order of sizes"},
       {"removal", "name", Kind::kText, kPure, "removal- and its number", "in exchange.csv"},
       {"removal", "min", Kind::kVector, kLength, "needed, or point",
        "lower corner: particles whose centres come into"},
       {"removal", "max", Kind::kVector, kLength, "needed, or normal", "upper corner: the box go"},
       {"removal", "point", Kind::kVector, kLength, "none",
        "of a plane instead: those whose centres come behind it go"},
       {"removal", "normal", Kind::kVector, kPure, "none", "of the plane, to the side of those that stay"},
       {"region", "name", Kind::kText, kPure, "region- and its number", "in regions.csv"},
       {"region", "min", Kind::kVector, kLength, "needed", "lower corner"},
       {"region", "max", Kind::kVector, kLength, "needed", "upper corner"},

       {"time", "end", Kind::kNumber, kTime, "needed, or steps", "when the simulation ends; with stages these tell"},
       {"time", "steps", Kind::kCount, kPure, "by end", "number of steps instead of end"},
       {"time", "step", Kind::kNumber, kTime, "by steps_per_contact", "the time step"},
       {"time", "steps_per_contact", Kind::kNumber, kPure, "50, or as many as are stable",
        "time steps in the shortest contact; fewer than 10, or than are stable, are refused"},
       {"time", "scheme", Kind::kText, kPure, "velocity-verlet",
        "velocity-verlet, symplectic-euler, leapfrog or forest-ruth"},

       {"run", "threads", Kind::kCount, kPure, "1", "0: all that the machine offers"},
       {"run", "skin", Kind::kNumber, kLength, "0.1 of the smallest radius",
        "how far particles may move before the library searches candidates anew; 0: in every step"},
       {"run", "precision", Kind::kText, kPure, "double", "double or float numbers for the state"},

       {"output", "directory", Kind::kText, kPure, "the scene's name + -output", "relative to where hgrid runs"},
       {"output", "every", Kind::kNumber, kTime, "none", "time between pictures of the state"},
       {"output", "formats", Kind::kTexts, kPure, "vtp", format_list()},
       {"output", "energy", Kind::kNumber, kTime, "a hundredth of the run", "time between the rows of energy.csv"},
       {"output", "work", Kind::kFlag, kPure, "false",
        "energy.csv also tells what is dissipated and put in, and the balance; steps take several times as long"},
       {"output", "bulk", Kind::kFlag, kPure, "false",
        "bulk.csv: stress, fabric, coordination, granular temperature of the box, by the same times as energy.csv"},
       {"output", "contacts", Kind::kFlag, kPure, "false", "the network of contacts beside each picture, for ParaView"},
       {"output", "checkpoint", Kind::kNumber, kTime, "none", "time between checkpoints; the last one stays"}}));
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
    const bool part = dot == std::string_view::npos ? table.empty() || (table == kStage && doc.in_stages)
                                                    : table == name.substr(0, dot);
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
