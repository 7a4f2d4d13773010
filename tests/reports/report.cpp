// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reports/report.hpp"

#include "tests/support/scenes.hpp"

#include <algorithm>
#include <initializer_list>

namespace hgtest {
namespace {

struct Form {
  std::string name;
  hg_grid_def def;
  Particles particles;
  std::optional<size_t> pairs;
};

Form with_radii(const System &system, const std::string &name, const std::vector<double> &pattern) {
  Form form{system.name + ", " + name, system.def, {}, system.pairs};
  form.particles.dimension = system.def.dimension;
  for (size_t i = 0; i < system.centers.size(); i++) {
    form.particles.add(system.centers[i].data(), pattern[i % pattern.size()]);
  }
  return form;
}

// Halves, quarters and so on of a cut-off are doubles: the first three forms have the same pairs, exactly.
std::vector<Form> forms_of(const System &system) {
  const double c = system.cutoff;
  if (!system.radii.empty()) return {with_radii(system, "spheres", system.radii)};
  std::vector<Form> forms{with_radii(system, "equal spheres", {c / 2}), with_radii(system, "ranges", {c}),
                          with_radii(system, "points with a margin", {0}),
                          with_radii(system, "several sizes", {c / 2, c / 32, c / 8, c / 4, 0})};
  forms[1].def.interaction = HG_MAX_RANGE;
  forms[2].def.margin = c;
  forms[3].pairs.reset();
  return forms;
}

// Calls search(name, def) with every setting that must not change the pairs. Levels: 0 the cheapest, below 0 so many
// cells of the user, above 0 up to so many by the paper.
template <class Search>
void in_every_setting(const hg_grid_def &given, double reach, Search search) {
  const double cells[] = {reach / 32, reach / 8, reach};
  for (const int32_t levels : {0, -1, -3, 1, 4}) {
    if (levels < 0 && !(reach > 0)) continue;
    hg_grid_def def = given;
    def.level_rule = levels < 0 ? HG_LEVELS_USER : levels == 0 ? HG_LEVELS_AUTO : HG_LEVELS_PAPER;
    def.level_count = levels < 0 ? -levels : levels;
    def.cell_sizes = levels < 0 ? cells + 3 + levels : nullptr;
    for (const int32_t threads : {1, 4}) {
      for (const double skin : {0.0, reach / 16}) {
        def.thread_count = threads;
        def.skin = skin;
        search("levels " + std::to_string(levels) + ", threads " + std::to_string(threads) + (skin > 0 ? ", skin" : ""),
               def);
      }
    }
  }
}

void check_queries(const Form &form, const Pairs &expected) {
  const Grid grid = make_grid(form.def, form.particles);
  Pairs full = expected;
  for (const hg_pair &pair : expected) full.push_back({pair.b, pair.a});
  require_same((form.name + ", half rows").c_str(), pairs_of_rows(grid, HG_HALF), expected);
  require_same((form.name + ", full rows").c_str(), pairs_of_rows(grid, HG_FULL), sorted(full));
  for (size_t i = 0; i < form.particles.count(); i++) {
    const Sphere sphere{form.particles.center(i), form.particles.radii[i]};
    const hgrid::View<int32_t> ids = grid.query_sphere(sphere.center, sphere.radius);
    require_same((form.name + ", sphere " + std::to_string(i)).c_str(), std::vector<int32_t>(ids.begin(), ids.end()),
                 all_in_sphere(form.def, form.particles, sphere, exact_interact));
  }
}

void check_form(const Form &form) {
  const Pairs exact = all_pairs(form.def, form.particles, exact_interact);
  const Pairs in_doubles = all_pairs(form.def, form.particles, double_interact);
  if (form.pairs) {
    require(exact.size() == *form.pairs, form.name + ": " + std::to_string(exact.size()) + " pairs in truth, but " +
                                             std::to_string(*form.pairs) + " are known");
  }
  in_every_setting(form.def, largest_reach(form.def, form.particles), [&](const std::string &setting, hg_grid_def def) {
    const std::string what = form.name + ", " + setting;
    def.accuracy = HG_EXACT;
    require_same(what.c_str(), sorted_pairs_of(make_grid(def, form.particles)), exact);
    def.accuracy = HG_DOUBLE;
    require_same((what + ", HG_DOUBLE").c_str(), sorted_pairs_of(make_grid(def, form.particles)), in_doubles);
    def.accuracy = HG_FLOAT;
    require_superset(what + ", HG_FLOAT", def, form.particles, pairs_of(make_grid(def, form.particles)), exact);
  });
  check_queries(form, exact);
}

double reach_of(const Life &life) {
  double reach = 0;
  for (const Particles &step : life.steps) reach = std::max(reach, largest_reach(life.def, step));
  return reach;
}

}  // namespace

void check(const System &system) {
  for (const Form &form : forms_of(system)) check_form(form);
}

void check(const Life &life) {
  std::vector<Pairs> expected;
  for (size_t k = 0; k < life.steps.size(); k++) {
    expected.push_back(all_pairs(life.boxes.empty() ? life.def : life.boxes[k], life.steps[k], exact_interact));
  }
  for (size_t k = 0; k < life.pairs.size(); k++) {
    require(expected[k].size() == life.pairs[k], life.name + ": step " + std::to_string(k) + " has " +
                                                     std::to_string(expected[k].size()) + " pairs in truth, but " +
                                                     std::to_string(life.pairs[k]) + " are known");
  }
  in_every_setting(life.def, reach_of(life), [&](const std::string &setting, const hg_grid_def &def) {
    Grid grid = make_grid(def, life.steps[0]);
    for (size_t k = 0; k < life.steps.size(); k++) {
      const Particles &step = life.steps[k];
      if (!life.boxes.empty()) set_box(grid, life.boxes[k]);
      if (k > 0) grid.move(step.count(), step.centers.data(), step.radii.data());
      const std::string what = life.name + ", " + setting + ", step " + std::to_string(k);
      require_same(what.c_str(), sorted_pairs_of(grid), expected[k]);
      require_same((what + ", half rows").c_str(), pairs_of_rows(grid, HG_HALF), expected[k]);
    }
  });
}

}  // namespace hgtest
