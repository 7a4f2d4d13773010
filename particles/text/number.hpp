// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers and words found in text, and how they are quoted in messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace particles {

// Reads all of `text` as a finite double, also with the D of Fortran (1.0D-3). Returns nullptr, or what is wrong with
// it ("is not a number").
const char *number_fault(std::string_view text, double &value);

// Reads all of `text` as a whole number >= 0.
bool read_count(std::string_view text, size_t &value);

// A number as it stands in messages.
std::string text(double number);

// `text` in single quotes, shortened if it is long, with unprintable bytes shown as '?'.
std::string in_quotes(std::string_view text);

// Without blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

// In ASCII lower case.
std::string lower_case(std::string_view text);

// Without the quotes, single or double, that it stands in.
std::string_view without_quotes(std::string_view text);

// The words between blanks and tabs.
std::vector<std::string_view> split_words(std::string_view text);

}  // namespace particles
