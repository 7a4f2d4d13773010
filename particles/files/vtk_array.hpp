// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of numbers in VTK's files in XML, stored as the machine holds them, in base64.
#pragma once

#include "particles/text/base64.hpp"
#include "particles/text/output.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace particles {

template <class T>
constexpr const char *kVtkTypeName = nullptr;
template <>
inline constexpr const char *kVtkTypeName<double> = "Float64";
template <>
inline constexpr const char *kVtkTypeName<int64_t> = "Int64";

template <class T>
void write_vtk_array(Output &out, std::string_view name, size_t components, const std::vector<T> &numbers) {
  out << "<DataArray type=\"" << kVtkTypeName<T> << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
      << "\" format=\"binary\">";
  // The number of bytes comes first, in the type that header_type says.
  const uint64_t size = numbers.size() * sizeof(T);
  std::string bytes(reinterpret_cast<const char *>(&size), sizeof size);
  if (size > 0) bytes.append(reinterpret_cast<const char *>(numbers.data()), size);
  out << base64(bytes) << "</DataArray>";
}

}  // namespace particles
