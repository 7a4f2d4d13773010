// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What an earlier run has left in a folder.
#pragma once

#include <string>

namespace output {

// A new run must not be mixed with another: throws particles::Error if the folder holds files of a run, or removes
// those, and nothing else, if they may be overwritten.
void require_no_earlier_run(const std::string &folder, bool overwrite);

}  // namespace output
