// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"
#include "scene/Body.h"
#include "window/kinds/KindUi.h"

#include <map>

namespace handwheel {

// The surfaces of bodies, prepared for curves on them. A worker does so when they are first asked for. Window thread.
class PartSurfaces : public QObject {
  Q_OBJECT

 public:
  PartSurfaces(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {}

  // Null while it is being prepared; then prepared() follows.
  std::shared_ptr<const PartSurface> of(const BodyPointer& body);
  void clear();

 signals:
  void prepared();

 private:
  struct Entry {
    GeometryPointer geometry;
    std::shared_ptr<const PartSurface> surface;  // null: under way
  };
  JobRunner& m_jobs;
  std::map<BodyId, Entry> m_entries;
};

}  // namespace handwheel
