// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes written as text, for tests: what they mean, and what is said of faulty ones.
#pragma once

#include "dem/scene/scene.hpp"
#include "tests/support/refusal.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace scene_text {

inline const std::string kBasic =
    "title = \"t\"\n"
    "[[particles]]\n"
    "at = [[0, 0, 0], [3, 0, 0]]\n"
    "radius = 1\n"
    "[contact]\n"
    "stiffness = 1e4\n"
    "[time]\n"
    "steps = 10\n";

inline std::string write_file(const std::string &text) {
  std::string path =
      (std::filesystem::temp_directory_path() / ("hgrid-test-scene-" + std::to_string(getpid()) + ".toml")).string();
  std::ofstream(path) << text;
  return path;
}

inline scene::Scene read(const std::string &text) {
  const std::string path = write_file(text);
  scene::Scene result = scene::read_scene(path);
  std::filesystem::remove(path);
  return result;
}

// What is said about a faulty scene, without the folder.
inline std::string error_of(const std::string &text) {
  const std::string path = write_file(text);
  std::string what = test::error_of([&] { scene::read_scene(path); });
  if (what.compare(0, path.size(), path) == 0) what.erase(0, path.size());
  std::filesystem::remove(path);
  return what;
}

inline bool is_refused(const std::string &text, const std::string &start, const std::string &part = "") {
  const std::string what = error_of(text);
  const bool fits = what.compare(0, start.size(), start) == 0 && what.find(part) != std::string::npos;
  if (!fits) std::printf("refused with: %s\n", what.c_str());
  return fits;
}

}  // namespace scene_text
