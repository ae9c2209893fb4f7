// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/LayerProps.h"
#include "viewport/overlay/ColourScale.h"
#include "viewport/surface/SurfaceGeometry.h"
#include "viewport/surface/SurfaceStyle.h"

#include <vtkActor.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>
#include <deque>
#include <optional>

namespace handwheel {

// The VTK actors of the blocks of a mesh, and of a simplified version. The blocks are added and updated one by one.
class MeshBlocks {
 public:
  explicit MeshBlocks(LayerProps& props);

  void clear();
  // Queues the new geometry of a block. The block shows its former geometry until takeOne() uploads the new one.
  void enqueue(std::size_t block, SurfaceGeometry geometry);
  // Uploads one block from the queue, so that no frame uploads more than one. Returns the number of its triangles, or 0
  // if no block was waiting.
  std::size_t takeOne();
  void setCoarse(std::optional<SurfaceGeometry> geometry);
  // Sets whether the simplified version, if there is one, is shown instead of the blocks.
  void setCoarseShown(bool reduced);

  void setStyle(const SurfaceStyle& style);
  // Sets the position of the geometry in the drawing.
  void setOffset(const Vec3& offset);
  // Sets the colours of geometry with values; nothing if the values are not shown. The colours are applied block by
  // block in takeOne(), because each block must be uploaded again.
  void setColourScale(const std::optional<ColourScale>& scale);
  int builtCount() const { return m_built; }

 private:
  vtkSmartPointer<vtkActor> makeActor(const SurfaceGeometry& geometry);
  void style(vtkActor* actor) const;
  void colour(vtkActor* actor) const;
  std::size_t colourOne();
  void updateVisibility();

  struct Pending {
    std::size_t block;
    SurfaceGeometry geometry;
  };

  LayerProps& m_props;
  std::vector<vtkSmartPointer<vtkActor>> m_blocks;
  vtkSmartPointer<vtkActor> m_coarse;
  std::deque<Pending> m_queue;
  std::deque<std::size_t> m_toColour;               // numbers of the blocks to be coloured
  vtkSmartPointer<vtkScalarsToColors> m_colourMap;  // null: values are not shown
  SurfaceStyle m_style;
  Vec3 m_offset = Vec3::Zero();
  bool m_reduced = false;
  int m_built = 0;
};

}  // namespace handwheel
