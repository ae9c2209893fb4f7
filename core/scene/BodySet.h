// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

#include <string_view>
#include <vector>

namespace handwheel {

// The bodies of a document, in the order in which they were added. The set is an immutable value. Its versions share
// all bodies that did not change, and need a pointer for each body.
class BodySet {
 public:
  static constexpr std::size_t kMost = 2'000;
  // Limit of the number of triangles of all bodies of a document together. BodySet does not check it.
  static constexpr std::size_t kMostTriangles = 20'000'000;

  BodySet() : m_bodies(std::make_shared<const std::vector<BodyPointer>>()) {}

  std::size_t size() const { return m_bodies->size(); }
  bool empty() const { return m_bodies->empty(); }
  auto begin() const { return m_bodies->begin(); }  // Iterates over BodyPointer, never null
  auto end() const { return m_bodies->end(); }

  BodyPointer withId(BodyId id) const;                // Null if there is none; O(log n)
  BodyPointer withName(std::string_view name) const;  // Null if there is none; O(n)
  // Returns a number that no body has or has had.
  BodyId freeId() const { return m_freeId; }
  std::size_t triangleCount() const;  // Number of triangles of all bodies; O(n)

  // Return the set with a body added, or with a body removed. An added body replaces the body with the same number.
  // O(n).
  BodySet with(BodyPointer body) const;
  BodySet without(BodyId id) const;
  // Returns the set with all numbers below `least` counted as used.
  BodySet withFreeId(BodyId least) const;
  // Returns the set with this free number, for undo. It must be the number of an earlier version with the same bodies.
  BodySet withRestoredFreeId(BodyId id) const;

  // Compares the bodies only; formerly used numbers do not count.
  bool operator==(const BodySet& other) const;

 private:
  std::shared_ptr<const std::vector<BodyPointer>> m_bodies;  // Bodies by rising number
  BodyId m_freeId = 1;
};

}  // namespace handwheel
