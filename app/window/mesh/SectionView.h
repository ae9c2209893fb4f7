// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "document/Property.h"
#include "mesh/measure/Section.h"
#include "window/JobRunner.h"

namespace handwheel {

class MeshLayer;
class Viewport;
struct MeshTab;

// Shows the section of the mesh by the clipping plane. The outline is shown in the viewport, its length and area in a
// panel. It follows plane and mesh; the mesh is cut on a worker thread, so neither has to wait.
class SectionView : public QObject {
  Q_OBJECT

 public:
  SectionView(Viewport& viewport, MeshLayer& layer, QThreadPool& pool, QObject* parent = nullptr);

  void setDocument(MeshTab* document);
  // Length, and area of a closed outline; none without a plane.
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
