// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "viewport/PartShape.h"
#include "viewport/SurfaceStyle.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <deque>
#include <map>
#include <set>

class vtkRenderer;

namespace handwheel {

// Rigid parts on the graphics card. Parts of one soup share their geometry; a part that only moved gets another matrix.
// A part whose soup changed shows its former shape until the new one has been made.
class PartActors {
 public:
  using Soup = std::shared_ptr<const TriangleSoup>;

  explicit PartActors(vtkRenderer* renderer, double opacity = 1.0);

  // The parts from now on, told apart by name.
  void set(const std::vector<DisplayPart>& parts);
  // The soups whose shape is still to be made.
  std::vector<Soup> missing() const;
  // Takes what was made, to be built block by block as takeOne() is called. False when no part waits for this soup.
  bool setShape(const Soup& soup, PartShape& made);
  // Builds one block, so that the next frame uploads no more than that. Returns its triangles; 0 when none was waiting.
  std::size_t takeOne();

  void setStyle(const SurfaceStyle& style);
  // The point that stands at the origin of the drawing.
  void setOrigin(const Vec3& origin);
  // The parts of this name are tinted with the accent; empty: none.
  void setHighlighted(const std::string& name);

  // The parts that others of the same names are proposed for: seen through, for two opaque surfaces in one place make
  // stripes.
  void setFaded(const std::vector<DisplayPart>& proposed);

  bool isEmpty() const { return m_parts.empty(); }
  const Box& bounds() const { return m_bounds; }
  // Some thousand points that tell how far the parts reach in any direction.
  std::vector<Vec3> outline() const;
  // Those whose search structure is there.
  const std::vector<PickPart>& pickable() const { return m_pickable; }
  int builtCount() const { return m_built; }

 private:
  struct Shape {
    PartOutline outline;
    Vec3 origin = Vec3::Zero();
    bool isMade = false;
    std::vector<vtkSmartPointer<vtkPolyData>> blocks;
    std::shared_ptr<const PickIndex> index;
  };
  using ShapePointer = std::shared_ptr<Shape>;

  struct Part {
    DisplayPart description;
    ShapePointer wanted;
    ShapePointer awaited;  // an earlier shape that may be under way, and is better than what is shown; else null
    ShapePointer shown;    // null as long as there is nothing to show
    std::vector<vtkSmartPointer<vtkActor>> actors;
  };

  ShapePointer shapeFor(const Soup& soup, std::size_t scanned);
  void want(Part& part, ShapePointer shape);
  void show(Part& part, const ShapePointer& shape);
  void addActor(Part& part, vtkPolyData* block);
  void remove(Part& part);
  void place(const Part& part) const;
  void style(const Part& part) const;
  void updateSummary();

  vtkRenderer* m_renderer;
  const double m_opacity;
  std::vector<Part> m_parts;
  std::map<Soup, std::weak_ptr<Shape>> m_shapes;
  std::deque<std::pair<ShapePointer, SurfaceGeometry>> m_queue;
  std::vector<PickPart> m_pickable;
  Box m_bounds;
  SurfaceStyle m_style;
  Vec3 m_origin = Vec3::Zero();
  std::set<std::string> m_faded;
  std::string m_highlighted;  // a name
  int m_built = 0;
};

}  // namespace handwheel
