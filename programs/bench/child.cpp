// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Processes by fork alone: a child sees the particles of its parent without a copy.
#include "programs/bench/child.hpp"

#include "particles/error.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace bench {
namespace {

// The parent's ends of all pipes: a child that kept one open would keep its sister from seeing the parent leave.
std::vector<int> &parent_ends() {
  static std::vector<int> ends;
  return ends;
}

[[noreturn]] void fail(const char *what) {
  throw std::runtime_error(std::string(what) + " failed: " + std::strerror(errno));
}

[[noreturn]] void run_child(const std::string &name, const std::function<void(Channel &)> &work, int in, int out) {
  int status = 0;
  try {
    Channel channel(in, out);
    work(channel);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), particles::message_of(error).c_str());
    status = 1;
  }
  std::fflush(nullptr);
  _exit(status);
}

void forget(int end) {
  std::vector<int> &ends = parent_ends();
  ends.erase(std::remove(ends.begin(), ends.end(), end), ends.end());
  close(end);
}

}  // namespace

void Channel::write_bytes(const void *bytes, size_t size) {
  const char *next = static_cast<const char *>(bytes);
  while (size > 0) {
    const ssize_t written = write(out_, next, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) throw ProcessEnded("the other process ended");
    if (written <= 0) fail("writing to the other process");
    next += written;
    size -= static_cast<size_t>(written);
  }
}

void Channel::read_bytes(void *bytes, size_t size) {
  char *next = static_cast<char *>(bytes);
  while (size > 0) {
    if (patience_ > 0) {
      pollfd waiting{in_, POLLIN, 0};
      const int ready = poll(&waiting, 1, static_cast<int>(1e3 * patience_));
      if (ready < 0 && errno == EINTR) continue;
      if (ready == 0) throw PatienceEnded("took longer than " + std::to_string(std::lround(patience_)) + " s");
    }
    const ssize_t got = read(in_, next, size);
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) throw ProcessEnded("the other process ended");
    if (got < 0) fail("reading from the other process");
    next += got;
    size -= static_cast<size_t>(got);
  }
}

Child::Child(const std::string &name, const std::function<void(Channel &)> &work) : channel_(-1, -1) {
  std::signal(SIGPIPE, SIG_IGN);  // a child that is gone shall be an error, not the end
  int down[2], up[2];
  if (pipe(down) != 0 || pipe(up) != 0) fail("pipe");
  std::fflush(nullptr);
  process_ = fork();
  if (process_ < 0) fail("fork");
  if (process_ == 0) {
    for (const int end : parent_ends()) close(end);
    close(down[1]);
    close(up[0]);
    run_child(name, work, down[0], up[1]);
  }
  close(down[0]);
  close(up[1]);
  in_ = up[0];
  out_ = down[1];
  parent_ends().insert(parent_ends().end(), {in_, out_});
  channel_ = Channel(in_, out_);
}

Child::~Child() {
  forget(in_);
  forget(out_);
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  wait();
}

std::string Child::wait() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  return "exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace bench
