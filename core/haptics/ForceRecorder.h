// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Recording.h"
#include "haptics/ServoLoop.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace handwheel {

// Records every tick of a servo loop: a thread of its own fetches them from the loop's ring a hundred times a second,
// so that neither the servo thread nor a busy window loses any. The only one that fetches samples from its loop.
class ForceRecorder {
 public:
  // Ten minutes at 8 kHz, 1.8 GB, of which as much is used as was recorded: 220 MB for ten minutes at 1 kHz. Then it
  // ends by itself.
  static constexpr std::size_t kMostTicks = 4'800'000;

  // The loop outlives it.
  explicit ForceRecorder(ServoLoop& loop, std::size_t mostTicks = kMostTicks) : m_loop(loop), m_mostTicks(mostTicks) {}
  ~ForceRecorder() { stop(); }
  ForceRecorder(const ForceRecorder&) = delete;
  ForceRecorder& operator=(const ForceRecorder&) = delete;

  // Forgets what was recorded and begins with the ticks from now on.
  void start();
  void stop();  // with the last tick that was
  bool isRecording() const { return m_thread.joinable(); }
  // Without a thread, where who runs the loop fetches in between: forgets everything, what waits in the ring as well;
  void clear();
  void fetch();  // takes what waits.

  // Notes something at the last tick recorded.
  void mark(std::string text);

  // What there is so far; goes on being recorded.
  Recording recording() const;
  bool isFull() const;
  // How much that is, without touching the ticks.
  std::size_t ticks() const;
  double duration() const;  // s

 private:
  void run();

  ServoLoop& m_loop;
  const std::size_t m_mostTicks;
  mutable std::mutex m_mutex;  // never the servo thread's
  std::condition_variable m_wake;
  Recording m_recording;
  bool m_isStopping = false;
  std::thread m_thread;
};

}  // namespace handwheel
