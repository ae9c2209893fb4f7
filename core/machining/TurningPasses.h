// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "machining/TurningPass.h"

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>

namespace handwheel {

// The passes that cut a part, in the order of cutting. A copy shares its memory pages with the original. A new version
// of a part with 100,000 passes therefore needs memory for the last page only.
class TurningPasses {
 public:
  using Pass = std::shared_ptr<const TurningPass>;

  TurningPasses() = default;
  TurningPasses(std::initializer_list<Pass> passes) {
    for (const Pass& pass : passes) push_back(pass);
  }

  std::size_t size() const { return m_passes.size(); }
  bool empty() const { return m_passes.empty(); }
  const Pass& operator[](std::size_t i) const { return m_passes[i]; }
  const Pass& front() const { return m_passes[0]; }
  const Pass& back() const { return m_passes[size() - 1]; }
  void push_back(const Pass& pass) { m_passes.push_back(pass); }

  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Pass;
    using difference_type = std::ptrdiff_t;
    using pointer = const Pass*;
    using reference = const Pass&;
    Iterator() = default;
    Iterator(const TurningPasses& passes, std::size_t i) : m_of(&passes), m_i(i) {}
    const Pass& operator*() const { return (*m_of)[m_i]; }
    Iterator& operator++() {
      ++m_i;
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++m_i;
      return before;
    }
    bool operator==(const Iterator&) const = default;

   private:
    const TurningPasses* m_of = nullptr;
    std::size_t m_i = 0;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  PagedArray<Pass> m_passes;
};

}  // namespace handwheel
