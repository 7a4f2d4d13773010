// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What somebody may have meant by a word that is not known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scene {

// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
size_t edit_distance(std::string_view a, std::string_view b);

// ": did you mean 'x'?" with the nearest of the known words, or a list of them if none is near.
std::string suggestion(std::string_view word, const std::vector<std::string> &known);

}  // namespace scene
