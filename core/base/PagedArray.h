// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/SoleOwner.h"

#include <cassert>
#include <cstddef>
#include <memory>
#include <vector>

namespace handwheel {

// A copy-on-write array in pages that copies share. Copying costs one pointer per 4096 elements; a write to a shared
// page copies only that page. So a snapshot of a mesh is cheap, and two versions can be compared page by page. Reading
// different copies on different threads is safe. A copy must be written by one thread at a time.
template <class T>
class PagedArray {
 public:
  static constexpr std::size_t kPageSize = 4096;

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }

  const T& operator[](std::size_t i) const {
    assert(i < m_size);
    return (*m_pages[i / kPageSize])[i % kPageSize];
  }

  void set(std::size_t i, const T& value) {
    assert(i < m_size);
    writable(i / kPageSize)[i % kPageSize] = value;
  }

  void push_back(const T& value) {
    if (m_size % kPageSize == 0) {
      m_pages.push_back(std::make_shared<Page>());
      m_pages.back()->reserve(kPageSize);
    }
    writable(m_pages.size() - 1).push_back(value);
    ++m_size;
  }

  void truncate(std::size_t size) {
    assert(size <= m_size);
    m_pages.resize((size + kPageSize - 1) / kPageSize);
    if (size % kPageSize != 0) writable(m_pages.size() - 1).resize(size % kPageSize);
    m_size = size;
  }

  // Returns true if both versions share the page, so that none of its elements differ.
  bool sharesPage(const PagedArray& other, std::size_t page) const {
    return page < m_pages.size() && page < other.m_pages.size() && m_pages[page] == other.m_pages[page];
  }
  std::size_t pageCount() const { return m_pages.size(); }

 private:
  using Page = std::vector<T>;

  Page& writable(std::size_t page) {
    auto& p = m_pages[page];
    if (!isSoleOwner(p)) {
      auto copy = std::make_shared<Page>();
      copy->reserve(kPageSize);
      copy->assign(p->begin(), p->end());
      p = std::move(copy);
    }
    return *p;
  }

  std::vector<std::shared_ptr<Page>> m_pages;
  std::size_t m_size = 0;
};

}  // namespace handwheel
