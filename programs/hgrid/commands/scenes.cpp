// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid scenes`: the scenes that come with the program, and what a scene can say.
#include "dem/scene/keys.hpp"
#include "dem/scene/shipped.hpp"
#include "particles/text/output.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/own_folder.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace command {
namespace {

struct ScenesOptions {
  std::string folder;
  bool keys = false;
};

void list_scenes(const ScenesOptions &options) {
  particles::Output out("-");
  if (options.keys) {
    out << scene::key_reference();
  } else {
    const std::string folder = options.folder.empty() ? beside_program(HGRID_SCENES) : options.folder;
    for (const scene::Entry &entry : scene::scenes_in(folder)) out << entry.path << "\n    " << entry.title << '\n';
  }
  out.close();
}

}  // namespace

void add_scenes(CLI::App &parent) {
  auto options = std::make_shared<ScenesOptions>();
  CLI::App *command = parent.add_subcommand("scenes", "List the scenes that come with hgrid, or what a scene can say");
  command->add_option("FOLDER", options->folder, "Scenes of this folder instead");
  command->add_flag("--keys", options->keys, "Every table and key of a scene with its meaning");
  command->callback([options] { list_scenes(*options); });
}

}  // namespace command
