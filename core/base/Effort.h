// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace handwheel {

// How much a piece of work may do, in steps that it counts itself, each worth about a microsecond. Unlike a limit of
// time it is the same on every machine and in every run. Any thread.
class Effort {
 public:
  explicit Effort(std::size_t most) : m_most(most) {}
  // A share of another, which pays for it and must outlive it.
  Effort(std::size_t most, Effort& whole) : m_most(std::min(most, whole.left())), m_whole(&whole) {}
  Effort(const Effort&) = delete;
  Effort& operator=(const Effort&) = delete;

  // The whole pays for no more than the share: how far threads go beyond it does not matter to what follows.
  void spend(std::size_t steps) {
    const std::size_t before = m_spent.fetch_add(steps, std::memory_order_relaxed);
    if (m_whole) m_whole->spend(std::min(before + steps, m_most) - std::min(before, m_most));
  }

  std::size_t spent() const { return std::min(m_spent.load(std::memory_order_relaxed), m_most); }
  std::size_t left() const { return m_whole ? std::min(m_most - spent(), m_whole->left()) : m_most - spent(); }
  bool isSpent() const { return left() == 0; }
  // 0…1.
  double shareSpent() const { return m_most > 0 ? static_cast<double>(spent()) / static_cast<double>(m_most) : 1.0; }

 private:
  std::size_t m_most;
  Effort* m_whole = nullptr;
  std::atomic<std::size_t> m_spent{0};
};

}  // namespace handwheel
