// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The scenes of a folder.
#include "dem/scene/shipped.hpp"

#include "dem/base/error.hpp"
#include "dem/scene/table.hpp"

#include <algorithm>
#include <filesystem>

namespace scene {

std::vector<Entry> scenes_in(const std::string &folder) {
  std::error_code error;
  std::vector<Entry> entries;
  for (const auto &file : std::filesystem::directory_iterator(folder, error)) {
    if (file.path().extension() == ".toml") entries.push_back({file.path().string(), ""});
  }
  if (error) throw dem::Error(folder + ": " + error.message());
  if (entries.empty()) throw dem::Error(folder + ": holds no scene");
  std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) { return a.path < b.path; });
  for (Entry &entry : entries) {
    const SceneFile file(entry.path);
    entry.title = file.top().text("title", "");
  }
  return entries;
}

}  // namespace scene
