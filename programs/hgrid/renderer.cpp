// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/hgrid/renderer.hpp"

#include "particles/error.hpp"
#include "particles/text/text_file.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

namespace command {
namespace {

class FileActions {
 public:
  // What the program says goes to the file.
  explicit FileActions(const std::string &log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 2, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions_, 2, 1);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions &) = delete;
  FileActions &operator=(const FileActions &) = delete;

  const posix_spawn_file_actions_t *get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// The last lines, where the reason stands.
std::string end_of(const std::string &text) {
  constexpr size_t kShown = 600;
  return text.size() > kShown ? text.substr(text.size() - kShown) : text;
}

}  // namespace

void render(const std::string &scene_file, const std::string &picture, int width, int height) {
  const std::string log = scene_file + ".log";
  std::vector<std::string> words = {"povray",
                                    "+I" + scene_file,
                                    "+O" + picture,
                                    "+W" + std::to_string(width),
                                    "+H" + std::to_string(height),
                                    "+A0.1",
                                    "-D",
                                    "+FN8"};
  std::vector<char *> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string &word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const FileActions actions(log);
  pid_t child = 0;
  const int error = posix_spawnp(&child, words[0].c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (error == ENOENT) {
    throw particles::Error(
        "the renderer povray is not there (Debian: apt-get install povray); an output that ends with "
        ".pov writes its scene only");
  }
  if (error != 0) throw particles::Error(std::string("povray cannot be started: ") + std::strerror(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const std::string said = particles::load_text(log).text;
  std::filesystem::remove(log);
  if (status != 0) throw particles::Error("povray failed on " + scene_file + ": " + end_of(said));
}

}  // namespace command
