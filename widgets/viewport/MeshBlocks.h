// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Lighting.h"
#include "viewport/SurfaceGeometry.h"
#include "viewport/ViewportTypes.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>
#include <deque>
#include <optional>

namespace handwheel {

// The model on the graphics card, in blocks that come and change one by one, and a coarse stand-in for it.
class MeshBlocks {
 public:
  explicit MeshBlocks(vtkRenderer* renderer);

  void clear();
  // Queues the geometry; the block shows its former state until then.
  void enqueue(std::size_t block, SurfaceGeometry geometry);
  // Takes one block from the queue, so that the next frame uploads no more than that. False when none was waiting.
  bool takeOne();
  void setCoarse(std::optional<SurfaceGeometry> geometry);
  // Shows the stand-in instead of the blocks, if there is one.
  void setReduced(bool reduced);

  void setShading(Shading shading);
  void setColours(const SceneColours& colours);
  void setPixelRatio(double ratio);
  int builtCount() const { return m_built; }

 private:
  vtkSmartPointer<vtkActor> makeActor(const SurfaceGeometry& geometry);
  void style(vtkActor* actor) const;
  void styleAll();
  void updateVisibility();

  struct Pending {
    std::size_t block;
    SurfaceGeometry geometry;
  };

  vtkRenderer* m_renderer;
  std::vector<vtkSmartPointer<vtkActor>> m_blocks;
  vtkSmartPointer<vtkActor> m_coarse;
  std::deque<Pending> m_queue;
  SceneColours m_colours;
  Shading m_shading = Shading::Shaded;
  double m_pixelRatio = 1.0;
  bool m_reduced = false;
  int m_built = 0;
};

}  // namespace handwheel
