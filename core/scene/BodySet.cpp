// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/BodySet.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace handwheel {

namespace {

bool isBefore(const BodyPointer& body, BodyId id) {
  return body->id < id;
}

}  // namespace

BodyPointer BodySet::withId(BodyId id) const {
  const auto found = std::lower_bound(begin(), end(), id, isBefore);
  return found != end() && (*found)->id == id ? *found : nullptr;
}

BodyPointer BodySet::withName(std::string_view name) const {
  const auto found = std::find_if(begin(), end(), [&](const BodyPointer& body) { return body->name == name; });
  return found != end() ? *found : nullptr;
}

BodySet BodySet::with(BodyPointer body) const {
  assert(body && body->id > 0 && body->geometry);
  std::vector<BodyPointer> bodies = *m_bodies;
  const auto at = std::lower_bound(bodies.begin(), bodies.end(), body->id, isBefore);
  BodySet next = *this;
  next.m_freeId = std::max(m_freeId, body->id + 1);
  if (at != bodies.end() && (*at)->id == body->id)
    *at = std::move(body);
  else
    bodies.insert(at, std::move(body));
  next.m_bodies = std::make_shared<const std::vector<BodyPointer>>(std::move(bodies));
  return next;
}

BodySet BodySet::without(BodyId id) const {
  std::vector<BodyPointer> bodies = *m_bodies;
  std::erase_if(bodies, [id](const BodyPointer& body) { return body->id == id; });
  BodySet next = *this;
  next.m_bodies = std::make_shared<const std::vector<BodyPointer>>(std::move(bodies));
  return next;
}

BodySet BodySet::withFreeId(BodyId least) const {
  BodySet next = *this;
  next.m_freeId = std::max(m_freeId, least);
  return next;
}

std::size_t BodySet::triangleCount() const {
  return std::accumulate(begin(), end(), std::size_t{0}, [](std::size_t sum, const BodyPointer& body) {
    return sum + body->geometry->surface()->triangles.size();
  });
}

BodySet BodySet::withRestoredFreeId(BodyId id) const {
  assert(empty() || m_bodies->back()->id < id);
  BodySet next = *this;
  next.m_freeId = id;
  return next;
}

bool BodySet::operator==(const BodySet& other) const {
  return m_bodies == other.m_bodies ||
         std::equal(begin(), end(), other.begin(), other.end(),
                    [](const BodyPointer& a, const BodyPointer& b) { return a == b || *a == *b; });
}

}  // namespace handwheel
