// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list of an animation, in XML.
#include "dem/output/animation.hpp"

#include "particles/error.hpp"
#include "particles/files/vtk_head.hpp"
#include "particles/text/output.hpp"

#include <pugixml.hpp>

#include <cstdio>

namespace output {

void write_animation(const std::string &path, const std::vector<TimedFile> &files) {
  particles::Output out(path);
  out << particles::vtk_head("Collection") << "<Collection>";
  for (const TimedFile &file : files) out << "<DataSet timestep=\"" << file.time << "\" file=\"" << file.name << "\"/>";
  out << "</Collection></VTKFile>";
  out.close();
}

std::vector<TimedFile> read_animation(const std::string &path) {
  std::vector<TimedFile> files;
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_file(path.c_str());
  if (parsed.status == pugi::status_file_not_found) return files;
  const pugi::xml_node collection = document.child("VTKFile").child("Collection");
  if (!parsed || !collection) throw particles::Error(path + ": is no list of VTK files");
  for (const pugi::xml_node entry : collection.children("DataSet"))
    files.push_back({entry.attribute("timestep").as_double(), entry.attribute("file").as_string()});
  return files;
}

std::string name_of_step(const char *what, uint64_t step, const std::string &format) {
  char name[64];
  std::snprintf(name, sizeof name, "%s-%012llu.", what, static_cast<unsigned long long>(step));
  return name + format;
}

std::vector<TimedFile> files_until(const std::string &list, const std::string &last) {
  std::vector<TimedFile> kept;
  for (const TimedFile &file : read_animation(list)) {
    if (file.name <= last) kept.push_back(file);
  }
  return kept;
}

}  // namespace output
