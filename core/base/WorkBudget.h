// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace handwheel {

// A work budget that limits a computation by counted steps. The computation counts its steps itself; each step is worth
// about a microsecond. Unlike a time limit, the budget is the same on every machine and in every run. The class is
// thread-safe.
class WorkBudget {
 public:
  explicit WorkBudget(std::size_t most) : m_most(most) {}
  // Creates a part of another budget, which must outlive it. Its steps are charged to that budget, too.
  WorkBudget(std::size_t most, WorkBudget& whole) : m_most(std::min(most, whole.left())), m_whole(&whole) {}
  WorkBudget(const WorkBudget&) = delete;
  WorkBudget& operator=(const WorkBudget&) = delete;

  void spend(std::size_t steps) { spend(steps, steps); }

  // Returns the number of all steps done, including the steps of the parts and the steps beyond the limit. The number
  // may differ between runs if several threads work.
  std::size_t counted() const { return m_counted.load(std::memory_order_relaxed); }
  std::size_t spent() const { return std::min(m_spent.load(std::memory_order_relaxed), m_most); }
  std::size_t left() const { return m_whole ? std::min(m_most - spent(), m_whole->left()) : m_most - spent(); }
  bool isSpent() const { return left() == 0; }
  // Returns the fraction of the budget that is spent, 0 to 1.
  double shareSpent() const { return m_most > 0 ? static_cast<double>(spent()) / static_cast<double>(m_most) : 1.0; }

 private:
  // A part charges at most its own limit to the whole, so that the results do not depend on how far threads overrun
  // that limit.
  void spend(std::size_t steps, std::size_t counted) {
    m_counted.fetch_add(counted, std::memory_order_relaxed);
    const std::size_t before = m_spent.fetch_add(steps, std::memory_order_relaxed);
    if (m_whole) m_whole->spend(std::min(before + steps, m_most) - std::min(before, m_most), counted);
  }

  std::size_t m_most;
  WorkBudget* m_whole = nullptr;
  std::atomic<std::size_t> m_spent{0}, m_counted{0};
};

}  // namespace handwheel
