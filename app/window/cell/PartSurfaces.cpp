// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PartSurfaces.h"

#include "window/JobRunner.h"

namespace handwheel {

std::shared_ptr<const PartSurface> PartSurfaces::of(const BodyPointer& body) {
  Entry& entry = m_entries[body->id];
  if (entry.geometry == body->geometry) return entry.surface;
  entry = {body->geometry, nullptr};
  Job job;
  job.name = tr("Finding the edges of %1").arg(QString::fromStdString(body->name));
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.isUnasked = true;
  job.work = [this, id = body->id, geometry = body->geometry](Progress) -> Job::Finish {
    auto surface = std::make_shared<const PartSurface>(*geometry->surface());
    return [this, id, geometry, surface] {
      const auto found = m_entries.find(id);
      if (found == m_entries.end() || found->second.geometry != geometry) return;
      found->second.surface = surface;
      emit prepared();
    };
  };
  m_jobs.start(std::move(job));
  return nullptr;
}

void PartSurfaces::clear() {
  m_jobs.cancelOf(this);
  m_entries.clear();
}

}  // namespace handwheel
