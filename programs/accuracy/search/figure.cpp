// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/figure.hpp"

#include "programs/accuracy/search/studies.hpp"

namespace accuracy {
namespace {

bool starts_with(const std::string &text, const std::string &start) {
  return text.compare(0, start.size(), start) == 0;
}

bool of_skin(const Point &p) {
  return p.parameter == "skin" && p.system == "uniform volume, ratio 10" && p.error_of == "contacts missed";
}

std::string short_choice(const Point &p) {
  const std::string all = "all radii, ", library = "library, ";
  if (starts_with(p.setting, all)) return p.setting.substr(all.size());
  return starts_with(p.setting, library)
             ? p.setting.substr(library.size(), p.setting.find(' ', library.size()) - library.size())
             : p.setting;
}

}  // namespace

const Figure &search_figure() {
  static const Figure figure = {
      "What does accuracy of the search cost?",
      "ns per particle and step",
      {{"How is overlap decided?",
        {"pairs wrong, of a relaxed packing,", "sizes of ratio 50"},
        [](const Point &p) { return p.parameter == "accuracy" && p.system == "relaxed packing, ratio 50"; },
        setting_of},
       {"\u2026 where all pairs just touch?",
        {"pairs wrong, of a turned lattice"},
        [](const Point &p) { return p.parameter == "accuracy" && p.system == "turned lattice, all touching"; },
        setting_of},
       {"When are candidates searched anew?",
        {"contacts missed, ratio 10;", "the library's `skin`"},
        [](const Point &p) { return of_skin(p) && !starts_with(p.setting, "every"); },
        setting_of},
       {"\u2026 or after a fixed number of steps?",
        {"the same, a plain list"},
        [](const Point &p) { return of_skin(p) && starts_with(p.setting, "every"); },
        setting_of},
       {"How are the levels chosen?",
        {"cost above the least, uniform volume,", "ratio 50; the library's with K = 0.3"},
        [](const Point &p) { return p.parameter == "optimiser" && p.system == "uniform volume, ratio 50"; },
        short_choice}}};
  return figure;
}

}  // namespace accuracy
