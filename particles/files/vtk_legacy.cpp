// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Legacy files of VTK, ASCII or binary, versions 1 to 5: the points of PolyData or an unstructured grid with their
// arrays. Cells and their data are passed over.
#include "particles/error.hpp"
#include "particles/files/point_rows.hpp"
#include "particles/files/reader.hpp"
#include "particles/files/vtk_numbers.hpp"
#include "particles/text/number.hpp"
#include "particles/text/text_file.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace particles {
namespace {

bool is_space(char letter) { return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r'; }

class LegacyReader {
 public:
  explicit LegacyReader(const TextFile &file) : file_(file), text_(file.text) {}

  ParticleSet read(const ReadOptions &options) {
    read_head();
    for (std::string key = word(); !key.empty(); key = word()) read_section(lower_case(key));
    if (!has_points_) fail("the file holds no POINTS");
    return particles_of_points(file_.name, points_, arrays_, options);
  }

 private:
  [[noreturn]] void fail(const std::string &message) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(offset_);
    throw Error(file_.name, binary_ ? 0 : static_cast<size_t>(std::count(text_.begin(), end, '\n')) + 1, message);
  }

  std::string_view line() {
    const size_t end = std::min(text_.find('\n', offset_), text_.size());
    std::string_view found = text_.substr(offset_, end - offset_);
    offset_ = std::min(end + 1, text_.size());
    if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
    return trimmed(found);
  }

  // "" at the end of the file.
  std::string word() {
    while (offset_ < text_.size() && is_space(text_[offset_])) offset_++;
    const size_t first = offset_;
    while (offset_ < text_.size() && !is_space(text_[offset_])) offset_++;
    return std::string(text_.substr(first, offset_ - first));
  }

  size_t count() {
    const std::string found = word();
    size_t number = 0;
    // Whatever is counted takes a byte, or is passed over.
    if (!read_count(found, number) || number > text_.size())
      fail(in_quotes(found) + " is not the number of what follows");
    return number;
  }

  void read_head() {
    line();
    line();
    const std::string kind = lower_case(line());
    if (kind != "ascii" && kind != "binary") fail("ASCII or BINARY should stand above, not " + in_quotes(kind));
    const std::string key = lower_case(word()), data = lower_case(word());
    if (key != "dataset" || (data != "polydata" && data != "unstructured_grid"))
      fail("DATASET POLYDATA or UNSTRUCTURED_GRID should stand here, not " + in_quotes(key + " " + data));
    binary_ = kind == "binary";
  }

  std::vector<double> numbers(size_t count, const std::string &type_name) {
    const VtkType *type = vtk_type(lower_case(type_name));
    if (type == nullptr) fail("the type " + in_quotes(type_name) + " is unknown");
    std::vector<double> values;
    if (count > (text_.size() - offset_) / (binary_ ? type->size : 1))
      fail("the file ends before " + std::to_string(count) + " values");
    values.reserve(count);
    if (binary_) {
      line();
      if (count * type->size > text_.size() - offset_)
        fail("the file ends before " + std::to_string(count) + " values");
      type->read(text_.substr(offset_, count * type->size), is_little_endian(), values);
      offset_ += count * type->size;
      return values;
    }
    for (size_t k = 0; k < count; k++) {
      const std::string found = word();
      values.push_back(0);
      if (const char *fault = number_fault(found, values.back())) fail(in_quotes(found) + " " + fault);
    }
    return values;
  }

  void keep(std::string name, size_t width, const std::string &type) {
    PointArray array{std::move(name), width, numbers(of_points_ * width, type)};
    if (is_of_points_) arrays_.push_back(std::move(array));
  }

  void read_scalars() {
    const std::string name = word(), type = word();
    const std::string_view rest = line();
    size_t width = 1;
    if (!rest.empty() && (!read_count(rest, width) || width == 0 || width > 1000))
      fail(in_quotes(rest) + " is not a number of components");
    // The name of a table of colours may stand in between.
    const size_t before = offset_;
    if (lower_case(word()) == "lookup_table") {
      word();
    } else {
      offset_ = before;
    }
    // In binary files numbers() goes to the next line: here it begins already.
    if (binary_ && offset_ == before && offset_ > 0) offset_--;
    keep(name, width, type);
  }

  void read_field() {
    word();
    for (size_t arrays = count(); arrays > 0; arrays--) {
      std::string name = word();
      if (lower_case(name) == "metadata") {
        skip_metadata();
        name = word();
      }
      const size_t width = count(), rows = count();
      const std::string type = word();
      if (width > 0 && rows > text_.size() / width) fail("the file ends before the field " + in_quotes(name));
      PointArray array{name, width, numbers(width * rows, type)};
      if (is_of_points_ && width > 0) arrays_.push_back(std::move(array));
    }
  }

  void skip_metadata() {
    line();
    while (offset_ < text_.size() && !line().empty()) continue;
  }

  void read_cells() {
    const size_t cells = count(), size = count();
    const size_t before = offset_;
    if (lower_case(word()) != "offsets") {
      offset_ = before;
      numbers(size, "int");
      return;
    }
    numbers(cells, word());
    const std::string key = word();
    if (lower_case(key) != "connectivity") fail("CONNECTIVITY should stand here, not " + in_quotes(key));
    numbers(size, word());
  }

  void read_section(const std::string &key) {
    if (key == "points") {
      const size_t rows = count();
      points_ = numbers(3 * rows, word());
      has_points_ = true;
    } else if (key == "vertices" || key == "lines" || key == "polygons" || key == "triangle_strips" || key == "cells") {
      read_cells();
    } else if (key == "cell_types") {
      numbers(count(), "int");
    } else if (key == "point_data" || key == "cell_data") {
      is_of_points_ = key == "point_data";
      of_points_ = count();
    } else if (key == "scalars") {
      read_scalars();
    } else if (key == "vectors" || key == "normals" || key == "tensors") {
      const std::string name = word();
      keep(name, key == "tensors" ? 9 : 3, word());
    } else if (key == "texture_coordinates") {
      const std::string name = word();
      const size_t width = count();
      keep(name, width, word());
    } else if (key == "color_scalars") {
      const std::string name = word();
      keep(name, count(), "unsigned_char");
    } else if (key == "lookup_table") {
      word();
      numbers(4 * count(), "unsigned_char");
    } else if (key == "field") {
      read_field();
    } else if (key == "metadata") {
      skip_metadata();
    } else {
      fail("the section " + in_quotes(key) + " is unknown");
    }
  }

  const TextFile &file_;
  std::string_view text_;
  size_t offset_ = 0, of_points_ = 0;
  bool binary_ = false, has_points_ = false, is_of_points_ = false;
  std::vector<double> points_;
  std::vector<PointArray> arrays_;
};

}  // namespace

ParticleSet read_vtk(const TextFile &file, const ReadOptions &options) {
  if (options.frame > 1)
    throw Error(file.name, 0, "frame " + std::to_string(options.frame) + " of a VTK file, which has only one");
  return LegacyReader(file).read(options);
}

}  // namespace particles
