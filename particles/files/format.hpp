// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The file formats for particles: what is offered, recognised, read and written comes from their table.
#pragma once

#include "particles/particle_set.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace particles {

class Output;
struct ReadOptions;
struct TextFile;

using Reader = ParticleSet(const TextFile &file, const ReadOptions &options);
using Writer = void(Output &out, const ParticleSet &particles);

struct Format {
  const char *name;                       // the word for it in options and scenes, and one of its endings
  const char *title;                      // what it is called
  const char *endings;                    // of file names, with blanks between
  const char *needs;                      // what a file must hold to be read
  bool (*begins)(std::string_view text);  // whether the text of a file begins as only this format does
  Reader *read;                           // nullptr: files are only written
  Writer *write;                          // nullptr: files are only read
  // What of a set a file could not hold, "" if it can hold all.
  std::string (*loss)(const ParticleSet &particles) = [](const ParticleSet &) { return std::string(); };
};

const std::vector<Format> &all_formats();
std::vector<Format> readable_formats();
std::vector<Format> writable_formats();

// Nothing is nullptr. By the name of a format; by the ending of a file's name; by what a text begins with.
const Format *format_of_word(std::string_view word);
const Format *format_of_name(std::string_view path);
const Format *format_of_content(std::string_view text);

// Whether a line before the rows names x and y, as in CSV.
bool names_columns(std::string_view text);

}  // namespace particles
