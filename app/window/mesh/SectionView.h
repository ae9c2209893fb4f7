// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "document/Property.h"
#include "mesh/measure/Section.h"
#include "window/JobRunner.h"

namespace handwheel {

class MeshLayer;
class Viewport;
struct MeshTab;

// Shows the section of the mesh by the clipping plane. The outline is shown in the viewport, its length and area in a
// panel. The section follows the plane and the mesh. It is computed on a worker thread, so the window does not have to
// wait.
class SectionView : public QObject {
  Q_OBJECT

 public:
  SectionView(Viewport& viewport, MeshLayer& layer, QThreadPool& pool, QObject* parent = nullptr);

  void setDocument(MeshTab* document);
  // Returns the length of the outline and, if it is closed, its area. The result is empty if there is no clipping
  // plane.
  std::vector<Property> statistics() const;

 signals:
  void changed();  // the statistics have changed

 private:
  void cut();
  void show(const std::optional<Section>& section);

  Viewport& m_viewport;
  MeshLayer& m_layer;
  JobRunner m_cutting;
  MeshTab* m_document = nullptr;
  std::optional<Section> m_section;
};

}  // namespace handwheel
