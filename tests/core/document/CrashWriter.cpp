// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CrashModel.h"
#include "document/AtomicFile.h"
#include "document/recovery/Recovery.h"

#include <unistd.h>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

// The child of CrashTest: edits, autosaves and saves until it is killed, and tells on standard output what it does:
//   CrashWriter SAVED-FILE RECOVERY-ROOT RANDOM-SEED INTERVAL-IN-MICROSECONDS
// Lines: "edit N T", "saving N T", "saved N T", "storing N T", "stored N T", "removed N T", and "idle 0 T" where the
// autosaver looked and nothing was due. N: edits so far; T: microseconds of the steady clock.

using namespace handwheel;
using namespace handwheel::test;

namespace {

std::int64_t now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(time).count();
}

// One write for a line, so that lines of two threads do not mix and none is lost in a buffer.
void tell(const char* what, std::uint64_t number, std::int64_t time = now()) {
  char line[80];
  const int length = std::snprintf(line, sizeof line, "%s %llu %lld\n", what, static_cast<unsigned long long>(number),
                                   static_cast<long long>(time));
  if (::write(STDOUT_FILENO, line, static_cast<std::size_t>(length)) != length) std::abort();
}

void require(const Status& status) {
  if (!status) std::abort();
}

class Writer {
 public:
  Writer(const char* file, const char* root, unsigned seed, std::int64_t interval)
      : m_file(file), m_session(root), m_random(seed), m_interval(interval) {}

  [[noreturn]] void run() {
    std::thread([this] { autosave(); }).detach();
    for (;;) {
      const auto choice = m_random() % 1000;
      if (choice < 3)
        save();
      else if (choice < 600)
        edit();
      else
        std::this_thread::sleep_for(std::chrono::microseconds(m_random() % 2000));
    }
  }

 private:
  void edit() {
    const std::lock_guard guard(m_mutex);
    m_model.edit();
    const std::int64_t time = now();
    tell("edit", m_model.edits(), time);
    if (m_oldestEdit == 0) m_oldestEdit = time;
  }

  CrashModel snapshot() {
    const std::lock_guard guard(m_mutex);
    return m_model;
  }

  void save() {
    const CrashModel model = snapshot();
    tell("saving", model.edits());
    require(writeFileAtomically(m_file, model.archive(Compression::Fast)));
    tell("saved", model.edits());
    const std::lock_guard guard(m_mutex);
    if (m_model.edits() != model.edits()) return;
    m_oldestEdit = 0;
    m_session.remove(kKey);
    tell("removed", model.edits());
  }

  [[noreturn]] void autosave() {
    for (;;) {
      if (isDue())
        store();
      else
        std::this_thread::sleep_for(std::chrono::microseconds(m_interval / 10));
    }
  }

  bool isDue() {
    const std::lock_guard guard(m_mutex);
    const std::int64_t time = now();
    const bool due = m_oldestEdit != 0 && time - m_oldestEdit >= m_interval;
    if (!due) tell("idle", 0, time);
    return due;
  }

  void store() {
    const CrashModel model = [this] {
      const std::lock_guard guard(m_mutex);
      m_oldestEdit = 0;
      tell("storing", m_model.edits());
      return m_model;
    }();
    require(m_session.store(kKey, {"id", m_file, "name", "crash"}, model.archive(Compression::None)));
    tell("stored", model.edits());
  }

  static constexpr std::uint64_t kKey = 1;

  std::string m_file;
  RecoverySession m_session;
  std::mt19937 m_random;
  std::int64_t m_interval;
  std::mutex m_mutex;  // for those below
  CrashModel m_model;
  std::int64_t m_oldestEdit = 0;  // the oldest edit in no autosave or save; 0: none
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  Writer(argv[1], argv[2], static_cast<unsigned>(std::atoi(argv[3])), std::atoll(argv[4])).run();
}
