// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One row for each file format, and how a format is recognised.
#include "particles/files/format.hpp"

#include "particles/text/number.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace particles {

// Each in the file of its format.
Reader read_csv, read_lammps, read_lammps_data, read_vtk, read_vtp, read_xyz;
bool begins_lammps_data(std::string_view text);
Writer write_csv, write_lammps, write_xyz, write_vtp;
std::string loss_in_lammps(const ParticleSet &particles);
std::string loss_in_xyz(const ParticleSet &particles);

namespace {

bool never(std::string_view) { return false; }

bool begins_lammps(std::string_view text) { return text.substr(0, 5) == "ITEM:"; }

// A whole number alone on its line.
bool begins_xyz(std::string_view text) {
  std::string_view line = text.substr(0, text.find('\n'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  size_t count = 0;
  return read_count(trimmed(line), count);
}

bool begins_vtk(std::string_view text) { return text.substr(0, 14) == "# vtk DataFile"; }

bool begins_vtp(std::string_view text) {
  return trimmed(text).substr(0, 1) == "<" && text.substr(0, 1000).find("<VTKFile") != std::string_view::npos;
}

template <class Test>
const Format *find_format(Test test) {
  const auto found = std::find_if(all_formats().begin(), all_formats().end(), test);
  return found != all_formats().end() ? &*found : nullptr;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

const std::vector<Format> &all_formats() {
  static const std::vector<Format> formats = {
      {"csv", "CSV", ".csv .tsv .txt .dat", "a header naming x, y, z (none in 2D) and r, radius, d or diameter", never,
       read_csv, write_csv},
      {"lammps", "LAMMPS text dump", ".lammpstrj .dump .lammps",
       "ITEM: ATOMS naming x, y, z, unwrapped or scaled, and radius or diameter", begins_lammps, read_lammps,
       write_lammps, loss_in_lammps},
      {"xyz", "extended XYZ", ".xyz .extxyz", "Properties naming pos and radius", begins_xyz, read_xyz, write_xyz,
       loss_in_xyz},
      {"data", "LAMMPS data file", ".data .lmp", "Atoms # sphere, or another style and --type-radius",
       begins_lammps_data, read_lammps_data, nullptr},
      {"vtp", "VTK PolyData", ".vtp", "points and radius or diameter, also of an UnstructuredGrid", begins_vtp,
       read_vtp, write_vtp},
      {"vtk", "VTK legacy file", ".vtk", "points and radius or diameter of POLYDATA or an UNSTRUCTURED_GRID",
       begins_vtk, read_vtk, nullptr},
  };
  return formats;
}

std::vector<Format> readable_formats() {
  std::vector<Format> readable;
  std::copy_if(all_formats().begin(), all_formats().end(), std::back_inserter(readable),
               [](const Format &format) { return format.read != nullptr; });
  return readable;
}

std::vector<Format> writable_formats() {
  std::vector<Format> writable;
  std::copy_if(all_formats().begin(), all_formats().end(), std::back_inserter(writable),
               [](const Format &format) { return format.write != nullptr; });
  return writable;
}

const Format *format_of_word(std::string_view word) {
  return find_format([&](const Format &format) { return format.name == word; });
}

const Format *format_of_name(std::string_view path) {
  const std::string name = lower_case(path);
  return find_format([&](const Format &format) {
    const std::vector<std::string_view> endings = split_words(format.endings);
    return std::any_of(endings.begin(), endings.end(), [&](std::string_view end) { return ends_with(name, end); });
  });
}

const Format *format_of_content(std::string_view text) {
  return find_format([&](const Format &format) { return format.begins(text); });
}

}  // namespace particles
