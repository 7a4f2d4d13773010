// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Work in a process of its own: the library chooses its instruction set once per process, memory can be counted, and a
// peer that crashes or never ends harms nobody else.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace bench {

// The other end has said nothing for longer than it was given.
class PatienceEnded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The process at the other end is gone.
class ProcessEnded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Messages between the two processes: plain structs and arrays of them.
class Channel {
 public:
  Channel(int in, int out) : in_(in), out_(out) {}

  // From now on, waiting longer than that throws PatienceEnded. A process that is gone throws ProcessEnded always.
  void set_patience(double seconds) { patience_ = seconds; }

  template <class T>
  void send(const T &value) {
    static_assert(std::is_trivially_copyable_v<T>);
    write_bytes(&value, sizeof value);
  }
  template <class T>
  T receive() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    read_bytes(&value, sizeof value);
    return value;
  }
  template <class T>
  void send_array(const std::vector<T> &values) {
    static_assert(std::is_trivially_copyable_v<T>);
    send(values.size());
    write_bytes(values.data(), values.size() * sizeof(T));
  }
  template <class T>
  std::vector<T> receive_array() {
    std::vector<T> values(receive<size_t>());
    read_bytes(values.data(), values.size() * sizeof(T));
    return values;
  }

 private:
  void write_bytes(const void *bytes, size_t size);
  void read_bytes(void *bytes, size_t size);

  int in_, out_;
  double patience_ = 0;  // 0: for ever
};

class Child {
 public:
  // Forks. The process ends when `work` returns; what `work` throws is shown on standard error after `name`.
  Child(const std::string &name, const std::function<void(Channel &)> &work);
  // Ends the process at once if it still runs.
  ~Child();
  Child(const Child &) = delete;
  Child &operator=(const Child &) = delete;

  Channel &channel() { return channel_; }
  // Waits for the process to end by itself and says how it did, e.g. "signal 11".
  std::string wait();

 private:
  pid_t process_ = -1;
  int in_ = -1, out_ = -1;
  Channel channel_;
};

}  // namespace bench
