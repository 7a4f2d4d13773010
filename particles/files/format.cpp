// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The file formats for particles and how one is recognised.
#include "particles/files/format.hpp"

#include "particles/text/number.hpp"

#include <cstddef>

namespace particles {
namespace {

struct NamedFormat {
  std::string_view name;
  Format format;
};

constexpr NamedFormat kWords[] = {{"csv", Format::kCsv}, {"lammps", Format::kLammps}, {"xyz", Format::kXyz}};

constexpr NamedFormat kEndings[] = {
    {".csv", Format::kCsv},       {".tsv", Format::kCsv},          {".txt", Format::kCsv},
    {".dat", Format::kCsv},       {".lammpstrj", Format::kLammps}, {".dump", Format::kLammps},
    {".lammps", Format::kLammps}, {".xyz", Format::kXyz},          {".extxyz", Format::kXyz}};

}  // namespace

const char *format_name(Format format) {
  for (const NamedFormat &entry : kWords)
    if (entry.format == format) return entry.name.data();
  return "unknown";
}

std::optional<Format> format_of_word(std::string_view word) {
  for (const NamedFormat &entry : kWords)
    if (entry.name == word) return entry.format;
  return std::nullopt;
}

std::optional<Format> format_of_name(std::string_view path) {
  const std::string name = lower_case(path);
  for (const NamedFormat &entry : kEndings)
    if (name.size() > entry.name.size() &&
        name.compare(name.size() - entry.name.size(), std::string::npos, entry.name.data(), entry.name.size()) == 0)
      return entry.format;
  return std::nullopt;
}

std::optional<Format> format_of_content(std::string_view text) {
  if (text.substr(0, 5) == "ITEM:") return Format::kLammps;
  std::string_view line = text.substr(0, text.find('\n'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  size_t count = 0;
  if (read_count(trimmed(line), count)) return Format::kXyz;
  return std::nullopt;
}

}  // namespace particles
