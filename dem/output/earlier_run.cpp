// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "dem/output/earlier_run.hpp"

#include "particles/error.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <vector>

namespace output {
namespace {

// By the names that recorder.cpp gives, and files over ranks.
bool is_of_a_run(const std::string &name) {
  constexpr const char *kNames[] = {"energy.csv", "bulk.csv",     "walls.csv", "regions.csv", "exchange.csv",
                                    "states.pvd", "contacts.pvd", "walls.pvd", "checkpoint"};
  const auto starts_with = [&](const std::string &start) { return name.compare(0, start.size(), start) == 0; };
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames) || starts_with("state-") ||
         starts_with("contacts-") || starts_with("walls-") || starts_with("checkpoint-");
}

}  // namespace

void require_no_earlier_run(const std::string &folder, bool overwrite) {
  std::vector<std::filesystem::path> found;
  std::error_code absent;
  for (const auto &entry : std::filesystem::directory_iterator(folder, absent)) {
    if (entry.is_regular_file() && is_of_a_run(entry.path().filename().string())) found.push_back(entry.path());
  }
  if (found.empty()) return;
  if (!overwrite) {
    throw particles::Error(folder + ": holds an earlier run, " + std::to_string(found.size()) + " files such as " +
                           found.front().filename().string() +
                           ": --overwrite removes it, --restart goes on with it, --output takes another folder");
  }
  for (const std::filesystem::path &file : found) std::filesystem::remove(file);
}

}  // namespace output
