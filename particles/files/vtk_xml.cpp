// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of VTK in XML: the points of PolyData or an unstructured grid with their arrays; ASCII, base64 or raw, inline
// or appended, as they are or packed by zlib.
#include "particles/error.hpp"
#include "particles/files/point_rows.hpp"
#include "particles/files/reader.hpp"
#include "particles/files/vtk_numbers.hpp"
#include "particles/text/base64.hpp"
#include "particles/text/number.hpp"
#include "particles/text/text_file.hpp"

#include <pugixml.hpp>
#include <zlib.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace particles {
namespace {

// zlib packs no tighter.
constexpr uint64_t kTightest = 1032;

class XmlReader {
 public:
  explicit XmlReader(const TextFile &file) : file_(file) {}

  ParticleSet read(const ReadOptions &options) {
    load();
    const pugi::xml_node root = document_.child("VTKFile");
    pugi::xml_node data = root.child("PolyData");
    if (!data) data = root.child("UnstructuredGrid");
    if (!data)
      fail("the file holds neither PolyData nor UnstructuredGrid but " + in_quotes(root.attribute("type").value()));
    swap_ = (std::string_view(root.attribute("byte_order").value()) == "BigEndian") == is_little_endian();
    header_size_ = std::string_view(root.attribute("header_type").value()) == "UInt64" ? 8 : 4;
    compressor_ = root.attribute("compressor").value();
    if (!compressor_.empty() && compressor_ != "vtkZLibDataCompressor")
      fail("data packed by " + in_quotes(compressor_) + " are not read; write them with zlib or as they are");
    for (const pugi::xml_node piece : data.children("Piece")) read_piece(piece);
    return particles_of_points(file_.name, points_, arrays_, options);
  }

 private:
  [[noreturn]] void fail(const std::string &message) const { throw Error(file_.name, 0, message); }

  // Raw data are no XML, so they are cut off.
  void load() {
    const std::string &text = file_.text;
    std::string xml;
    const size_t tag = text.find("<AppendedData");
    if (tag != std::string::npos) {
      const size_t end = std::min(text.find('>', tag), text.size());
      is_raw_ = std::string_view(text).substr(tag, end - tag).find("base64") == std::string_view::npos;
      const size_t mark = text.find('_', end);
      if (mark == std::string::npos) fail("the appended data do not begin with '_'");
      appended_ = std::string_view(text).substr(mark + 1);
      xml = text.substr(0, tag) + "</VTKFile>";
    }
    const std::string &whole = tag == std::string::npos ? text : xml;
    const pugi::xml_parse_result parsed = document_.load_buffer(whole.data(), whole.size());
    if (parsed) return;
    const auto fault = whole.begin() + static_cast<std::ptrdiff_t>(std::min<size_t>(parsed.offset, whole.size()));
    throw Error(file_.name, static_cast<size_t>(std::count(whole.begin(), fault, '\n')) + 1,
                std::string("no sound XML: ") + parsed.description());
  }

  void read_piece(const pugi::xml_node piece) {
    const std::vector<double> points = values(piece.child("Points").child("DataArray"));
    points_.insert(points_.end(), points.begin(), points.end());
    const bool is_first = pieces_++ == 0;
    size_t place = 0;
    for (const pugi::xml_node node : piece.child("PointData").children("DataArray")) {
      if (vtk_type(node.attribute("type").value()) == nullptr) continue;
      const size_t width = std::max(1U, node.attribute("NumberOfComponents").as_uint(1));
      const std::string name = node.attribute("Name").value();
      if (is_first) arrays_.push_back({name, width, {}});
      if (place >= arrays_.size() || arrays_[place].name != name)
        fail("the pieces differ in their arrays, at " + in_quotes(name));
      const std::vector<double> more = values(node);
      std::vector<double> &all = arrays_[place++].values;
      all.insert(all.end(), more.begin(), more.end());
    }
  }

  std::vector<double> values(const pugi::xml_node node) const {
    const std::string_view type_name = node.attribute("type").value(), format = node.attribute("format").value();
    const std::string name = in_quotes(node.attribute("Name").value());
    const VtkType *type = vtk_type(type_name);
    if (type == nullptr) fail("the array " + name + " has the unknown type " + in_quotes(type_name));
    const std::string_view text = node.text().get();
    std::vector<double> result;
    if (format == "ascii" || format.empty()) {
      read_ascii(text, name, result);
    } else if (format == "binary") {
      type->read(unpacked(text, false, name), swap_, result);
    } else if (format == "appended") {
      const auto offset = node.attribute("offset").as_ullong();
      if (offset > appended_.size()) fail("the array " + name + " begins behind the end of the appended data");
      type->read(unpacked(appended_.substr(offset), is_raw_, name), swap_, result);
    } else {
      fail("the array " + name + " has the unknown format " + in_quotes(format));
    }
    return result;
  }

  void read_ascii(std::string_view text, const std::string &name, std::vector<double> &result) const {
    std::string plain(text);
    std::replace_if(
        plain.begin(), plain.end(), [](char letter) { return letter == '\n' || letter == '\r'; }, ' ');
    for (const std::string_view word : split_words(plain)) {
      result.push_back(0);
      if (const char *fault = number_fault(word, result.back()))
        fail(in_quotes(word) + " in the array " + name + " " + fault);
    }
  }

  // The first bytes of what is stored at the beginning of `text`.
  std::string bytes(std::string_view text, bool is_raw, uint64_t count, const std::string &name) const {
    std::string result = is_raw ? std::string(text.substr(0, count)) : from_base64(text, count);
    if (result.size() < count) fail("the array " + name + " ends before " + std::to_string(count) + " bytes");
    return result;
  }

  uint64_t header_word(const std::string &bytes, size_t k) const {
    std::string word = bytes.substr(k * header_size_, header_size_);
    if (!is_little_endian()) std::reverse(word.begin(), word.end());
    if (swap_) std::reverse(word.begin(), word.end());
    uint64_t value = 0;
    for (size_t n = header_size_; n > 0; n--) value = value << 8 | static_cast<unsigned char>(word[n - 1]);
    return value;
  }

  // How many bytes there are comes first; packed: of how many blocks, of each one, of the last, and of each packed.
  std::string unpacked(std::string_view text, bool is_raw, const std::string &name) const {
    if (compressor_.empty()) {
      const uint64_t size = header_word(bytes(text, is_raw, header_size_, name), 0);
      if (size > text.size()) fail("the array " + name + " ends before " + std::to_string(size) + " bytes");
      return bytes(text, is_raw, header_size_ + size, name).substr(header_size_);
    }
    const uint64_t blocks = header_word(bytes(text, is_raw, header_size_, name), 0);
    if (blocks == 0) return "";
    if (blocks > text.size()) fail("the array " + name + " ends before " + std::to_string(blocks) + " blocks");
    const size_t head_size = (3 + blocks) * header_size_;
    const std::string head = bytes(text, is_raw, head_size, name);
    uint64_t total = head_size;
    for (size_t k = 0; k < blocks; k++) {
      const uint64_t packed = header_word(head, 3 + k);
      if (packed > text.size()) fail("the array " + name + " ends before " + std::to_string(packed) + " bytes");
      total += packed;
    }
    const std::string all = bytes(text, is_raw, total, name);
    const uint64_t last = header_word(head, 2);
    std::string result;
    size_t first = head_size;
    for (size_t k = 0; k < blocks; k++) {
      const uint64_t packed = header_word(head, 3 + k),
                     size = k + 1 == blocks && last > 0 ? last : header_word(head, 1);
      append_block(std::string_view(all).substr(first, packed), size, name, result);
      first += packed;
    }
    return result;
  }

  void append_block(std::string_view packed, uint64_t size, const std::string &name, std::string &result) const {
    if (size > kTightest * (packed.size() + 1)) fail("the array " + name + " holds a block that claims too much");
    const size_t before = result.size();
    result.resize(before + size);
    uLongf length = size;
    const int status = uncompress(reinterpret_cast<Bytef *>(result.data() + before), &length,
                                  reinterpret_cast<const Bytef *>(packed.data()), packed.size());
    if (status != Z_OK || length != size) fail("the array " + name + " holds a block that zlib cannot unpack");
  }

  const TextFile &file_;
  pugi::xml_document document_;
  std::string_view appended_;
  std::string compressor_;
  size_t header_size_ = 4, pieces_ = 0;
  bool is_raw_ = false, swap_ = false;
  std::vector<double> points_;
  std::vector<PointArray> arrays_;
};

}  // namespace

ParticleSet read_vtp(const TextFile &file, const ReadOptions &options) {
  if (options.frame > 1)
    throw Error(file.name, 0, "frame " + std::to_string(options.frame) + " of a VTK file, which has only one");
  return XmlReader(file).read(options);
}

}  // namespace particles
