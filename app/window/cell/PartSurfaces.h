// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"
#include "scene/Body.h"
#include "window/kinds/KindUi.h"

#include <map>

namespace handwheel {

// The surfaces of bodies, prepared for curves on them. A worker prepares each surface at its first use. The functions
// must be called on the window thread.
class PartSurfaces : public QObject {
  Q_OBJECT

 public:
  PartSurfaces(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {}

  // Returns the surface of a body; null while it is being prepared. prepared() is emitted afterwards.
  std::shared_ptr<const PartSurface> of(const BodyPointer& body);
  void clear();

 signals:
  void prepared();

 private:
  struct Entry {
    GeometryPointer geometry;
    std::shared_ptr<const PartSurface> surface;  // Null: being prepared
  };
  JobRunner& m_jobs;
  std::map<BodyId, Entry> m_entries;
};

}  // namespace handwheel
