// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The file formats for particles and how one is recognised.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace particles {

enum class Format { kCsv, kLammps, kXyz };

// "csv", "lammps", "xyz".
const char *format_name(Format format);

// The inverse of format_name; nothing for any other word.
std::optional<Format> format_of_word(std::string_view word);

// By the ending of a file name: .csv .txt .tsv .dat; .lammpstrj .dump .lammps; .xyz .extxyz. Nothing for any other.
std::optional<Format> format_of_name(std::string_view path);

// By what the text begins with: "ITEM:" is a LAMMPS dump, a lone whole number an XYZ file; nothing otherwise.
std::optional<Format> format_of_content(std::string_view text);

}  // namespace particles
