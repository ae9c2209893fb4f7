// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

#include <string_view>
#include <vector>

namespace handwheel {

// The bodies of a document, in the order in which they were added. An immutable value: a version shares all bodies that
// did not change, and costs a pointer for each.
class BodySet {
 public:
  static constexpr std::size_t kMost = 2'000;
  // Of the triangles of all bodies together, which a document may have; sets do not check it.
  static constexpr std::size_t kMostTriangles = 20'000'000;

  BodySet() : m_bodies(std::make_shared<const std::vector<BodyPointer>>()) {}

  std::size_t size() const { return m_bodies->size(); }
  bool empty() const { return m_bodies->empty(); }
  auto begin() const { return m_bodies->begin(); }  // of BodyPointer, none of them null
  auto end() const { return m_bodies->end(); }

  BodyPointer withId(BodyId id) const;                // null when there is none; O(log n)
  BodyPointer withName(std::string_view name) const;  // null when there is none; O(n)
  // A number that no body has, nor had.
  BodyId freeId() const { return m_freeId; }
  std::size_t triangleCount() const;  // of all bodies; O(n)

  // With this body, instead of the one with its number if there is one; and without the one with this number. O(n).
  BodySet with(BodyPointer body) const;
  BodySet without(BodyId id) const;
  // With numbers below this one counted as used.
  BodySet withFreeId(BodyId least) const;
  // With this as the free number, for undo: that of an earlier version, in which there were these bodies.
  BodySet withRestoredFreeId(BodyId id) const;

  // The same bodies; what numbers were used before does not count.
  bool operator==(const BodySet& other) const;

 private:
  std::shared_ptr<const std::vector<BodyPointer>> m_bodies;  // by rising number
  BodyId m_freeId = 1;
};

}  // namespace handwheel
