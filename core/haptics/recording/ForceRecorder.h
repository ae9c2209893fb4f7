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

// Records every tick of a servo loop. A separate thread fetches the ticks from the loop's ring buffer a hundred times a
// second, so that none is lost even if the window thread is busy. The recorder must be the only consumer of the loop's
// samples.
class ForceRecorder {
 public:
  // Largest number of ticks, at which recording ends. It is reached after ten minutes at 8 kHz, with 1.8 GB. Memory is
  // allocated as needed: 220 MB for ten minutes at 1 kHz.
  static constexpr std::size_t kMostTicks = 4'800'000;

  // The loop must outlive the recorder.
  explicit ForceRecorder(ServoLoop& loop, std::size_t mostTicks = kMostTicks) : m_loop(loop), m_mostTicks(mostTicks) {}
  ~ForceRecorder() { stop(); }
  ForceRecorder(const ForceRecorder&) = delete;
  ForceRecorder& operator=(const ForceRecorder&) = delete;

  // Discards the previous recording, and starts recording.
  void start();
  void stop();  // ends recording, after fetching the pending samples
  bool isRecording() const { return m_thread.joinable(); }
  // Discards everything, including pending samples. It is for use without a thread, when the caller runs the loop and
  // calls fetch().
  void clear();
  void fetch();  // records the pending samples

  // Adds an event at the last recorded tick.
  void mark(std::string text);
  // Sets a description of the contents of the next scene. It becomes an event, kSceneEvent and the text, at the first
  // tick in that scene or in a later one. Must be called before ServoLoop::setScene() and on the same thread, because
  // otherwise ticks in the scene may already have been fetched.
  void noteNextScene(std::string text);

  // Returns the recording up to the present tick. Recording continues.
  Recording recording() const;
  bool isFull() const;
  // Returns the number of recorded ticks, without access to the ticks.
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
  std::deque<SceneNote> m_scenes;  // scenes in which no tick was recorded yet
  bool m_isStopping = false;
  std::thread m_thread;
};

}  // namespace handwheel
