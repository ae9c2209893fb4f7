// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/ForceRecorder.h"

#include <cassert>
#include <chrono>

namespace handwheel {

namespace {
constexpr std::chrono::milliseconds kInterval{10};  // a ring holds 16 s at 1 kHz, 2 s at 8
}

void ForceRecorder::start() {
  assert(!isRecording());
  clear();
  m_isStopping = false;
  m_thread = std::thread([this] { run(); });
}

void ForceRecorder::stop() {
  if (!isRecording()) return;
  {
    const std::lock_guard lock(m_mutex);
    m_isStopping = true;
  }
  m_wake.notify_one();
  m_thread.join();
  fetch();
}

void ForceRecorder::clear() {
  const std::lock_guard lock(m_mutex);
  ServoSample old;
  while (m_loop.nextSample(old)) {
  }
  m_recording = {};
  m_scenes.clear();
}

void ForceRecorder::fetch() {
  const std::lock_guard lock(m_mutex);
  ServoSample sample;
  while (m_loop.nextSample(sample)) {
    if (m_recording.size() >= m_mostTicks) continue;
    for (; !m_scenes.empty() && m_scenes.front().number <= sample.scene; m_scenes.pop_front())
      m_recording.addEvent({sample.tick, std::string(kSceneEvent) + m_scenes.front().text});
    m_recording.add(recorded(sample));
  }
}

void ForceRecorder::noteNextScene(std::string text) {
  const std::lock_guard lock(m_mutex);
  m_scenes.push_back({m_loop.sceneNumber() + 1, std::move(text)});
}

void ForceRecorder::mark(std::string text) {
  const std::lock_guard lock(m_mutex);
  const std::size_t size = m_recording.size();
  m_recording.addEvent({size > 0 ? m_recording[size - 1].tick : 0, std::move(text)});
}

Recording ForceRecorder::recording() const {
  const std::lock_guard lock(m_mutex);
  return m_recording;
}

bool ForceRecorder::isFull() const {
  const std::lock_guard lock(m_mutex);
  return m_recording.size() >= m_mostTicks;
}

std::size_t ForceRecorder::ticks() const {
  const std::lock_guard lock(m_mutex);
  return m_recording.size();
}

double ForceRecorder::duration() const {
  const std::lock_guard lock(m_mutex);
  return m_recording.duration();
}

void ForceRecorder::run() {
  for (bool isLast = false; !isLast;) {
    fetch();
    std::unique_lock lock(m_mutex);
    isLast = m_wake.wait_for(lock, kInterval, [this] { return m_isStopping; });
  }
}

}  // namespace handwheel
