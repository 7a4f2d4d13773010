// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The renderer POV-Ray, as a program of its own.
#pragma once

#include <string>

namespace command {

// Renders the scene to a PNG file. Throws particles::Error if the program is not there, or with what it says.
void render(const std::string &scene_file, const std::string &picture, int width, int height);

}  // namespace command
