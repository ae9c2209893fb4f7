// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "document/Property.h"
#include "mesh/Section.h"
#include "window/JobRunner.h"

namespace handwheel {

class Viewport;
struct OpenMesh;

// Where the clipping plane cuts the mesh in view: the outline in the viewport, and its length and area. Follows plane
// and mesh; both wait for nothing, as the mesh is cut on a worker.
class SectionView : public QObject {
  Q_OBJECT

 public:
  SectionView(Viewport& viewport, QThreadPool& pool, QObject* parent = nullptr);

  void setDocument(OpenMesh* document);
  // After the viewport was given the mesh anew.
  void redraw();
  // Length, and of a closed outline the area; none without a plane.
  std::vector<Property> figures() const;

 signals:
  void changed();  // the figures

 private:
  void cut();
  void show(const std::optional<Section>& section);

  Viewport& m_viewport;
  JobRunner m_cutting;
  OpenMesh* m_document = nullptr;
  std::optional<Section> m_section;
};

}  // namespace handwheel
