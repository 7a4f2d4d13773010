// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/hgrid/sweep.hpp"

#include <CLI/CLI.hpp>

#include <cstddef>

namespace command {
namespace {

std::vector<std::string> values_of(const std::string &list) {
  std::vector<std::string> values(1);
  int depth = 0;
  bool quoted = false;
  for (const char letter : list) {
    if (letter == '"') quoted = !quoted;
    if (!quoted && (letter == '[' || letter == '{')) depth++;
    if (!quoted && (letter == ']' || letter == '}')) depth--;
    if (letter == ',' && depth == 0 && !quoted) {
      values.emplace_back();
    } else {
      values.back() += letter;
    }
  }
  return values;
}

}  // namespace

std::vector<Settings> combinations(const std::vector<std::string> &arguments) {
  std::vector<Settings> all(1);
  for (const std::string &argument : arguments) {
    const size_t equals = argument.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw CLI::ValidationError("--set", "'" + argument + "' is not TABLE.KEY=VALUE[,VALUE...]");
    const std::string path = argument.substr(0, equals);
    std::vector<Settings> longer;
    for (const Settings &settings : all) {
      for (const std::string &value : values_of(argument.substr(equals + 1))) {
        if (value.empty()) throw CLI::ValidationError("--set", "'" + argument + "' has an empty value");
        longer.push_back(settings);
        longer.back().push_back({path, value});
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string name_of(const Settings &settings) {
  std::string name;
  for (const scene::Setting &setting : settings) {
    name += (name.empty() ? "" : ",") + setting.path + "=" + setting.value;
  }
  for (char &letter : name) {
    if (letter == '/' || letter == '"' || letter == ' ') letter = '_';
  }
  return name;
}

}  // namespace command
