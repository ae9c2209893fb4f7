// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <map>
#include <mutex>
#include <thread>

namespace tbb {

template <class Value>
class enumerable_thread_specific {
 public:
  Value& local() {
    const std::scoped_lock lock(m_mutex);
    Value*& mine = m_byThread[std::this_thread::get_id()];
    if (!mine) mine = &m_values.emplace_back();
    return *mine;
  }
  auto begin() const { return m_values.begin(); }
  auto end() const { return m_values.end(); }

 private:
  std::mutex m_mutex;
  std::list<Value> m_values;
  std::map<std::thread::id, Value*> m_byThread;
};

}  // namespace tbb
