// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs of one scene with different values: what --set asks for.
#pragma once

#include "dem/scene/settings.hpp"

#include <string>
#include <vector>

namespace command {

// One value for each key that is set.
using Settings = std::vector<scene::Setting>;

// Every combination of the values of arguments such as friction.coefficient=0.1,0.2, the last changing fastest; one
// without settings if there is no argument. Commas in brackets or quotes do not part values. Throws
// CLI::ValidationError if an argument is not so.
std::vector<Settings> combinations(const std::vector<std::string> &arguments);

// For names of folders and lines: friction.coefficient=0.1,contact.stiffness=1e4. What names cannot hold becomes '_'.
std::string name_of(const Settings &settings);

}  // namespace command
