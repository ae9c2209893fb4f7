// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstddef>
#include <memory>
#include <vector>

namespace handwheel {

// Sparse set of indices with copy-on-write pages. The indices are below a fixed number, and nearly all of them are
// absent. Copies share pages until one of them is changed. So a copy, and also an empty set, costs one pointer per 4096
// indices. Reading different copies on different threads is safe.
class PagedIndexSet {
 public:
  explicit PagedIndexSet(std::size_t count = 0) : m_pages((count + kPageSize - 1) / kPageSize) {}

  bool contains(std::size_t i) const {
    const Page* page = m_pages[i / kPageSize].get();
    return page && page->test(i % kPageSize);
  }

  void insert(std::size_t i) {
    std::shared_ptr<Page>& page = m_pages[i / kPageSize];
    page = page ? std::make_shared<Page>(*page) : std::make_shared<Page>();
    page->set(i % kPageSize);
  }

 private:
  static constexpr std::size_t kPageSize = 4096;
  using Page = std::bitset<kPageSize>;

  std::vector<std::shared_ptr<Page>> m_pages;  // null: the page has no indices
};

}  // namespace handwheel
