// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/Recording.h"
#include "haptics/servo/ServoLoop.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace handwheel {

// Records every tick of a servo loop. A thread of its own fetches them from the loop's ring buffer a hundred times a
// second, so that none is lost even if the window thread is busy. It must be the only consumer of the loop's samples.
class ForceRecorder {
 public:
  // Recording ends by itself after ten minutes at 8 kHz, 1.8 GB. Memory is used as needed: 220 MB for ten minutes at 1
  // kHz.
  static constexpr std::size_t kMostTicks = 4'800'000;

  // The loop must outlive the recorder.
  explicit ForceRecorder(ServoLoop& loop, std::size_t mostTicks = kMostTicks) : m_loop(loop), m_mostTicks(mostTicks) {}
  ~ForceRecorder() { stop(); }
  ForceRecorder(const ForceRecorder&) = delete;
  ForceRecorder& operator=(const ForceRecorder&) = delete;

  // Discards what was recorded and starts recording the ticks from now on.
  void start();
  void stop();  // fetches the last tick first
  bool isRecording() const { return m_thread.joinable(); }
  // For use without a thread, when the caller runs the loop and calls fetch(): discards everything, including pending
  // samples.
  void clear();
  void fetch();  // fetches the pending samples

  // Adds an event at the last recorded tick.
  void mark(std::string text);
  // Notes the contents of the scene that the loop is given next. To be called before ServoLoop::setScene(), on the same
  // thread: later, ticks in the scene may have been fetched already. Becomes an event, kSceneEvent and the text, at the
  // first tick in that scene or in one after it.
  void noteNextScene(std::string text);

  // Returns the recording up to now; recording continues.
  Recording recording() const;
  bool isFull() const;
  // Returns the length of the recording, without access to the ticks.
  std::size_t ticks() const;
  double duration() const;  // s

 private:
  void run();

  ServoLoop& m_loop;
  const std::size_t m_mostTicks;
  mutable std::mutex m_mutex;  // never locked by the servo thread
  std::condition_variable m_wake;
  Recording m_recording;
  struct SceneNote {
    std::uint64_t number;
    std::string text;
  };
  std::deque<SceneNote> m_scenes;  // scenes that no tick was in yet
  bool m_isStopping = false;
  std::thread m_thread;
};

}  // namespace handwheel
