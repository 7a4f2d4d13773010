// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers as the files of VTK hold them in bytes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace particles {

struct VtkType {
  const char *names;  // with blanks around each: in XML, then in legacy files
  size_t size;
  void (*read)(std::string_view bytes, bool swap, std::vector<double> &values);
};

template <class T>
void read_vtk_bytes(std::string_view bytes, bool swap, std::vector<double> &values) {
  for (size_t k = 0; k + sizeof(T) <= bytes.size(); k += sizeof(T)) {
    char each[sizeof(T)];
    std::memcpy(each, bytes.data() + k, sizeof(T));
    if (swap) std::reverse(each, each + sizeof(T));
    T value;
    std::memcpy(&value, each, sizeof(T));
    values.push_back(static_cast<double>(value));
  }
}

// nullptr: there is no such type.
inline const VtkType *vtk_type(std::string_view name) {
  static const VtkType types[] = {
      {" Float64 double ", 8, read_vtk_bytes<double>},
      {" Float32 float ", 4, read_vtk_bytes<float>},
      {" Int64 long vtkidtype vtktypeint64 ", 8, read_vtk_bytes<int64_t>},
      {" UInt64 unsigned_long vtktypeuint64 ", 8, read_vtk_bytes<uint64_t>},
      {" Int32 int ", 4, read_vtk_bytes<int32_t>},
      {" UInt32 unsigned_int ", 4, read_vtk_bytes<uint32_t>},
      {" Int16 short ", 2, read_vtk_bytes<int16_t>},
      {" UInt16 unsigned_short ", 2, read_vtk_bytes<uint16_t>},
      {" Int8 char ", 1, read_vtk_bytes<int8_t>},
      {" UInt8 unsigned_char ", 1, read_vtk_bytes<uint8_t>},
  };
  for (const VtkType &type : types) {
    const std::string_view names = type.names;
    const size_t found = names.find(name);
    if (!name.empty() && found != std::string_view::npos && found > 0 && names[found - 1] == ' ' &&
        names[found + name.size()] == ' ')
      return &type;
  }
  return nullptr;
}

inline bool is_little_endian() {
  const uint16_t probe = 1;
  unsigned char first = 0;
  std::memcpy(&first, &probe, 1);
  return first == 1;
}

}  // namespace particles
