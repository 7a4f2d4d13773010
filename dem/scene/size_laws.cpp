// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Size laws as tables of a scene name them.
#include "dem/scene/size_laws.hpp"

#include "particles/error.hpp"
#include "particles/text/lists.hpp"

#include <filesystem>

namespace scene {
namespace {

void read_sizes(const Table &table, const std::string &folder, packing::SizeLaw &law) {
  if (!table.has("sizes")) return;
  std::string fault;
  try {
    fault = packing::set_sizes(law, (std::filesystem::path(folder) / table.text("sizes", "")).string());
  } catch (const particles::Error &error) {
    fault = error.what();
  }
  if (!fault.empty()) table.fail("sizes", fault);
}

}  // namespace

packing::SizeLaw read_law(const Table &table, const std::string &folder, int dimension) {
  packing::SizeLaw law = packing::usual_law(table.choice("law", particles::names_of(packing::size_laws())));
  law.dimension = dimension;
  for (const packing::LawParameter *parameter : packing::law_parameters()) {
    if (!table.has(parameter->name)) continue;
    const std::string fault = packing::set_parameter(law, *parameter, table.number(parameter->name));
    if (!fault.empty()) table.fail(parameter->name, fault);
  }
  read_sizes(table, folder, law);
  return law;
}

}  // namespace scene
