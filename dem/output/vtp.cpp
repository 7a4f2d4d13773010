// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK PolyData in XML (.vtp).
#include "dem/output/vtp.hpp"

#include "dem/base/error.hpp"
#include "dem/output/base64.hpp"
#include "dem/output/columns.hpp"

#include <pugixml.hpp>

#include <charconv>
#include <cstdint>
#include <cstring>

namespace output {
namespace {

template <class T>
constexpr const char *kTypeName = nullptr;
template <>
constexpr const char *kTypeName<double> = "Float64";
template <>
constexpr const char *kTypeName<int64_t> = "Int64";

bool is_little_endian() {
  const uint16_t probe = 1;
  unsigned char first = 0;
  std::memcpy(&first, &probe, 1);
  return first == 1;
}

template <class T>
pugi::xml_node add_array(pugi::xml_node parent, const char *name, int components, const std::vector<T> &numbers) {
  pugi::xml_node array = parent.append_child("DataArray");
  array.append_attribute("type") = kTypeName<T>;
  array.append_attribute("Name") = name;
  array.append_attribute("NumberOfComponents") = components;
  array.append_attribute("format") = "binary";
  // The number of bytes comes first, in the type that header_type says.
  const uint64_t size = numbers.size() * sizeof(T);
  std::string bytes(reinterpret_cast<const char *>(&size), sizeof size);
  if (size > 0) bytes.append(reinterpret_cast<const char *>(numbers.data()), size);
  array.text().set(base64(bytes).c_str());
  return array;
}

std::string number_text(double number) {
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
}

pugi::xml_node start_file(pugi::xml_document &document, const char *type) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = type;
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = is_little_endian() ? "LittleEndian" : "BigEndian";
  file.append_attribute("header_type") = "UInt64";
  return file;
}

void save(const pugi::xml_document &document, const std::string &path) {
  if (!document.save_file(path.c_str(), "", pugi::format_raw)) throw dem::Error(path + ": cannot write");
}

void add_piece(pugi::xml_node data, const dem::Snapshot &state) {
  const size_t count = state.radii.size();
  pugi::xml_node piece = data.append_child("Piece");
  piece.append_attribute("NumberOfPoints") = static_cast<unsigned long long>(count);
  piece.append_attribute("NumberOfVerts") = static_cast<unsigned long long>(count);
  for (const char *none : {"NumberOfLines", "NumberOfStrips", "NumberOfPolys"}) piece.append_attribute(none) = 0;

  pugi::xml_node points = piece.append_child("PointData");
  points.append_attribute("Scalars") = "radius";
  add_array(points, "radius", 1, state.radii);
  add_array(points, "mass", 1, state.masses);
  add_array(points, "velocity", 3, three_columns(state.velocities, state.dimension));
  if (!state.spins.empty()) add_array(points, "spin", 3, spin_columns(state));
  add_array(piece.append_child("Points"), "centers", 3, three_columns(state.centers, state.dimension));

  std::vector<int64_t> ids(count), ends(count);
  for (size_t i = 0; i < count; i++) {
    ids[i] = static_cast<int64_t>(i);
    ends[i] = static_cast<int64_t>(i + 1);
  }
  pugi::xml_node vertices = piece.append_child("Verts");
  add_array(vertices, "connectivity", 1, ids);
  add_array(vertices, "offsets", 1, ends);
}

}  // namespace

void write_vtp(const std::string &path, const dem::Snapshot &state) {
  pugi::xml_document document;
  pugi::xml_node data = start_file(document, "PolyData").append_child("PolyData");
  pugi::xml_node time = data.append_child("FieldData").append_child("DataArray");
  time.append_attribute("type") = "Float64";
  time.append_attribute("Name") = "TimeValue";
  time.append_attribute("NumberOfTuples") = 1;
  time.append_attribute("format") = "ascii";
  time.text().set(number_text(state.time).c_str());
  add_piece(data, state);
  save(document, path);
}

void write_pvd(const std::string &path, const std::vector<TimedFile> &files) {
  pugi::xml_document document;
  pugi::xml_node collection = start_file(document, "Collection").append_child("Collection");
  for (const TimedFile &file : files) {
    pugi::xml_node entry = collection.append_child("DataSet");
    entry.append_attribute("timestep") = number_text(file.time).c_str();
    entry.append_attribute("file") = file.name.c_str();
  }
  save(document, path);
}

std::vector<TimedFile> read_pvd(const std::string &path) {
  std::vector<TimedFile> files;
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_file(path.c_str());
  if (parsed.status == pugi::status_file_not_found) return files;
  const pugi::xml_node collection = document.child("VTKFile").child("Collection");
  if (!parsed || !collection) throw dem::Error(path + ": is no list of VTK files");
  for (const pugi::xml_node entry : collection.children("DataSet")) {
    files.push_back({entry.attribute("timestep").as_double(), entry.attribute("file").as_string()});
  }
  return files;
}

}  // namespace output
