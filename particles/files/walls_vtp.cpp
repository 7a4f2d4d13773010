// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lines and polygons of VTK PolyData in XML, numbers as text. VTK counts the lines before the polygons; each has points
// of its own.
#include "particles/files/walls_vtp.hpp"

#include "particles/error.hpp"
#include "particles/files/vtk_head.hpp"
#include "particles/text/number.hpp"
#include "particles/text/output.hpp"
#include "particles/text/text_file.hpp"

#include <pugixml.hpp>

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace particles {
namespace {

constexpr double kMost = 1e9;  // of walls

template <class Number, class Visit>
void write_array(Output &out, const char *type, const char *name, int components, const WallShapes &walls,
                 Visit visit) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
      << "\" format=\"ascii\">";
  for (const std::vector<WallPart> *parts : {&walls.lines, &walls.faces}) {
    for (const WallPart &part : *parts) visit(part, [&out](Number number) { out << number << ' '; });
  }
  out << "</DataArray>";
}

// Places of points, and where each part ends among them.
void write_cells(Output &out, const char *kind, const std::vector<WallPart> &parts, int64_t first) {
  const WallShapes those{parts, {}};
  int64_t next = first, end = 0;
  out << '<' << kind << '>';
  write_array<int64_t>(out, "Int64", "connectivity", 1, those, [&](const WallPart &part, auto write) {
    for (size_t k = 0; k < part.points.size(); k++) write(next++);
  });
  write_array<int64_t>(out, "Int64", "offsets", 1, those, [&](const WallPart &part, auto write) {
    write(end += static_cast<int64_t>(part.points.size()));
  });
  out << "</" << kind << '>';
}

size_t point_count(const std::vector<WallPart> &parts) {
  size_t count = 0;
  for (const WallPart &part : parts) count += part.points.size();
  return count;
}

class WallReader {
 public:
  explicit WallReader(const std::string &path) : path_(path), file_(load_text(path)) {
    if (!document_.load_buffer(file_.text.data(), file_.text.size())) fail("is no sound XML");
    piece_ = document_.child("VTKFile").child("PolyData").child("Piece");
    points_ = numbers(piece_.child("Points"), "points");
    kinds_ = numbers(piece_.child("CellData"), "kind");
    walls_ = numbers(piece_.child("CellData"), "wall");
    if (points_.size() % 3 != 0 || kinds_.size() != walls_.size()) fail("holds no walls");
  }

  WallShapes read() {
    WallShapes shapes{parts(piece_.child("Lines")), parts(piece_.child("Polys"))};
    if (cell_ != kinds_.size()) fail("has kinds of other walls than it holds");
    return shapes;
  }

 private:
  [[noreturn]] void fail(const std::string &what) const { throw Error(path_, 0, what + ": is it of hgrid run?"); }

  std::vector<double> numbers(const pugi::xml_node parent, const char *name) const {
    const pugi::xml_node node = parent.find_child_by_attribute("DataArray", "Name", name);
    if (std::string_view(node.attribute("format").value()) != "ascii") fail(std::string("has no text of ") + name);
    std::vector<double> result;
    for (const std::string_view word : split_words(node.text().get())) {
      result.push_back(0);
      if (const char *fault = number_fault(word, result.back())) fail(in_quotes(word) + " " + fault);
    }
    return result;
  }

  std::vector<WallPart> parts(const pugi::xml_node cells) {
    const std::vector<double> places = numbers(cells, "connectivity"), ends = numbers(cells, "offsets");
    std::vector<WallPart> result;
    size_t next = 0;
    for (const double end : ends) {
      if (cell_ >= kinds_.size()) fail("has fewer kinds than walls");
      const double kind = kinds_[cell_], wall = walls_[cell_++];
      if (!(kind >= 0 && kind <= static_cast<double>(WallKind::kMesh) && std::fabs(wall) < kMost))
        fail("has another kind");
      WallPart part{static_cast<WallKind>(kind), static_cast<int64_t>(wall), {}};
      for (; static_cast<double>(next) < end; next++) {
        if (next >= places.size() || !(places[next] >= 0 && 3 * places[next] + 2 < static_cast<double>(points_.size())))
          fail("names a point that it lacks");
        const double *point = &points_[3 * static_cast<size_t>(places[next])];
        part.points.push_back({point[0], point[1], point[2]});
      }
      result.push_back(std::move(part));
    }
    return result;
  }

  std::string path_;
  TextFile file_;
  pugi::xml_document document_;
  pugi::xml_node piece_;
  std::vector<double> points_, kinds_, walls_;
  size_t cell_ = 0;
};

}  // namespace

void write_walls(const std::string &path, double time, const WallShapes &walls) {
  const size_t on_lines = point_count(walls.lines), on_faces = point_count(walls.faces);
  Output out(path);
  begin_poly_data(out, &time, {on_lines + on_faces, 0, walls.lines.size(), walls.faces.size()});
  out << "<CellData Scalars=\"wall\">";
  write_array<int64_t>(out, "Int64", "wall", 1, walls, [](const WallPart &part, auto write) { write(part.wall); });
  write_array<int64_t>(out, "Int64", "kind", 1, walls,
                       [](const WallPart &part, auto write) { write(static_cast<int64_t>(part.kind)); });
  out << "</CellData><Points>";
  write_array<double>(out, "Float64", "points", 3, walls, [](const WallPart &part, auto write) {
    for (const Point &point : part.points) {
      for (const double component : point) write(component);
    }
  });
  out << "</Points>";
  write_cells(out, "Lines", walls.lines, 0);
  write_cells(out, "Polys", walls.faces, static_cast<int64_t>(on_lines));
  out << "</Piece></PolyData></VTKFile>";
  out.close();
}

WallShapes read_walls(const std::string &path) { return WallReader(path).read(); }

}  // namespace particles
