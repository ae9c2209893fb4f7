// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>

namespace handwheel::fuzz {

// Returns a valid file with some changes. Each change is described by eight bytes of the fuzzer's input. A library that
// reads files in a process of its own gives the fuzzer no coverage, so random files would all be refused at their first
// bytes.
inline std::string changedFile(std::string file, const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kBytes = 8, kMostChanges = 16;
  constexpr std::size_t kHead = 600;  // bytes at the beginning that control the reader
  const std::size_t count = std::min(size / kBytes, kMostChanges);
  for (std::size_t i = 0; i < count && !file.empty(); ++i) {
    const std::uint8_t* const change = data + i * kBytes;
    const std::size_t value = std::size_t{change[1]} | std::size_t{change[2]} << 8 | std::size_t{change[3]} << 16;
    const std::size_t at = value % ((change[0] & 8) != 0 ? std::min(kHead, file.size()) : file.size());
    const auto* const number = reinterpret_cast<const char*>(change + 4);
    switch (change[0] & 7) {
      case 0:  // cut off
        file.resize(at);
        break;
      case 1:
        file.erase(at, std::size_t{change[4]} + 1);
        break;
      case 2:
        file.insert(at, file.substr((std::size_t{change[4]} | std::size_t{change[5]} << 8) % file.size(), change[6]));
        break;
      case 3:
        file.insert(at, std::string(std::size_t{change[5]} + 1, static_cast<char>(change[4])));
        break;
      case 4:  // four bytes of all zeros or all ones
        file.replace(at, 4, 4, static_cast<char>((change[4] & 1) * 255));
        break;
      case 5:
        file.replace(at, 4, number, 4);
        break;
      default:
        file[at] = number[0];
    }
  }
  return file;
}

// Cancels the reading of a file after some seconds. A damaged file may keep its process busy until its time limit, most
// of a minute, and a fuzz test has to read many files.
class ReadingTime {
 public:
  ReadingTime() : m_watch([this] { watch(); }) {}
  ~ReadingTime() {
    {
      const std::lock_guard lock(m_mutex);
      m_isOver = true;
    }
    m_ended.notify_one();
    m_watch.join();
  }
  ReadingTime(const ReadingTime&) = delete;
  ReadingTime& operator=(const ReadingTime&) = delete;

  Progress progress() { return Progress(m_state); }

 private:
  void watch() {
    std::unique_lock lock(m_mutex);
    m_state.cancelled = !m_ended.wait_for(lock, std::chrono::seconds(4), [this] { return m_isOver; });
  }

  JobState m_state;
  std::mutex m_mutex;
  std::condition_variable m_ended;
  bool m_isOver = false;
  std::thread m_watch;
};

// Aborts unless the error is one that isolated readers may return, for a file that they refuse or that outlasts a
// ReadingTime.
inline void requireReaderError(ErrorCode code, const char* fuzzer) {
  if (code == ErrorCode::LibraryFailed || code == ErrorCode::OutOfMemory || code == ErrorCode::Cancelled) return;
  std::fprintf(stderr, "%s: an error that no reader of its kind gives\n", fuzzer);
  std::abort();
}

}  // namespace handwheel::fuzz
