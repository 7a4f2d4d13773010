// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the reader of scenes: any text is a scene that an engine takes and steps, or refused with a text.
#include "dem/scene/scene.hpp"

#include "dem/base/error.hpp"
#include "fuzz/expect.hpp"
#include "fuzz/memory_file.hpp"

#include <toml++/toml.h>

#include <cmath>
#include <cstdint>
#include <string_view>

namespace {

// Large scenes are no fault and small ones show as much: numbers of particles stay below this. Files are left to the
// targets of their formats.
constexpr double kMost = 30;

bool is_small(const toml::node &node, std::string_view key);

bool is_small(const toml::table &table) {
  for (const auto &[key, value] : table) {
    if (key.str() == "file" || !is_small(value, key.str())) return false;
  }
  return true;
}

bool is_small(const toml::node &node, std::string_view key) {
  if (const toml::table *table = node.as_table()) return is_small(*table);
  if (const toml::array *array = node.as_array()) {
    for (const toml::node &item : *array) {
      if (!is_small(item, key)) return false;
    }
    return true;
  }
  const bool counts = key == "count" || key == "counts" || key == "sweeps" || key == "threads";
  return !counts || !(node.value_or(0.0) > (key == "counts" ? 3 : kMost));
}

void run(std::string_view text) {
  const fuzz::MemoryFile file(text);
  const scene::Scene scene = scene::read_scene(file.path());
  fuzz::expect(scene.setup.count() > 0, "a scene without particles");
  fuzz::expect(std::isfinite(scene.setup.time_step) && scene.setup.time_step > 0, "a time step that is none");
  const auto engine = dem::make_engine(scene.setup, scene.precision);
  engine->run(3);
  engine->measure();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const std::string_view text(reinterpret_cast<const char *>(data), size);
  try {
    if (!is_small(toml::parse(text))) return 0;
  } catch (const toml::parse_error &) {
    // Refused below, too.
  }
  try {
    run(text);
  } catch (const dem::Error &error) {
    fuzz::expect(error.what()[0] != '\0', "a refusal without a text");
  }
  return 0;
}
