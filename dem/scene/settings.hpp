// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Values of a scene's keys that stand instead of those in its file, such as friction.coefficient=0.2.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

namespace scene {

struct Setting {
  std::string path;   // tables and key, with a dot between each two
  std::string value;  // as in the file; what is no value there is a text: 10 mm
};

// Puts the value where the path leads; tables that are not there are made, which switches effects on. Of [[particles]]
// and other arrays a number picks one, counted from 1 (particles.2.radius), else all get the value. Throws dem::Error
// naming the path if it leads through a value.
void apply(const Setting &setting, toml::table &scene);

}  // namespace scene
