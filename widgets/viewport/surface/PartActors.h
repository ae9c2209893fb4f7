// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "viewport/LayerProps.h"
#include "viewport/ViewLayer.h"
#include "viewport/surface/PartShape.h"
#include "viewport/surface/SurfaceStyle.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <deque>
#include <map>
#include <optional>
#include <set>

namespace handwheel {

// The VTK actors of rigid parts. Parts with the same soup share their geometry, and a part that only moves gets another
// matrix. A part with a new soup shows its former shape until the new shape has been built. The parts of a group are
// always shown as they were together at one call of set(): while they change faster than they can be built, some calls
// are left out.
class PartActors {
 public:
  using Soup = std::shared_ptr<const TriangleSoup>;

  explicit PartActors(LayerProps& props, double opacity = 1.0);

  // Sets the parts, which are identified by name.
  void set(const std::vector<DisplayPart>& parts);
  // Returns the soups whose shape is still to be built: those of the next states to be shown, the longest awaited
  // first, and then those of later states.
  std::vector<Soup> missing() const;
  // Takes a finished shape; takeOne() then uploads it block by block. Returns false if no part waits for this soup.
  bool setShape(const Soup& soup, PartShape& made);
  // Uploads one block, so that no frame uploads more than one. Returns the number of its triangles, or 0 if no block
  // was waiting.
  std::size_t takeOne();

  void setStyle(const SurfaceStyle& style);
  // Sets the model point at the origin of the drawing.
  void setOrigin(const Vec3& origin);
  // Tints the part with this name, and the parts of its group, with the accent colour; empty: no part.
  void setHighlighted(const std::string& name);

  // Tints the parts of these names more strongly. isCovered: true if all other parts are drawn translucently, so that
  // the selected ones are visible. Returns false if nothing changes.
  bool setSelected(const std::set<std::string>& names, bool isCovered);

  // Draws the parts with the names of the proposed ones translucently, because two coincident opaque surfaces cause
  // z-fighting. Returns false if these parts are unchanged.
  bool setFaded(const std::vector<DisplayPart>& proposed);

  // Draws the parts of this group translucently, such as pieces that were cut off from a workpiece; empty: no group.
  void setFaintGroup(const std::string& group);

  bool isEmpty() const { return m_parts.empty(); }
  // Returns true if some part has been uploaded, in its present or a former shape.
  bool isAnyShown() const;
  const Box& bounds() const { return m_bounds; }
  // Returns some thousand points to estimate the extent of the parts in any direction.
  std::vector<Vec3> outline() const;
  // Returns the first part along a ray. Its element is the number of the part, which stays the same while a part with
  // its name exists. A part whose search structure is not ready is not found.
  std::optional<LayerHit> firstHit(const Vec3& origin, const Vec3& direction) const;
  // Returns the name of a part; the result is empty if there is no such part.
  std::string nameOf(std::uint64_t number) const;
  int builtCount() const { return m_built; }

 private:
  struct Shape {
    Soup soup;
    PartOutline outline;
    Vec3 origin = Vec3::Zero();
    std::size_t blockCount = 0;  // number of blocks; 0: not built yet
    std::vector<vtkSmartPointer<vtkPolyData>> blocks;
    bool isComplete() const { return blockCount > 0 && blocks.size() == blockCount; }
    std::shared_ptr<const FaceHierarchy> faces;
  };
  using ShapePointer = std::shared_ptr<Shape>;

  struct Part {
    DisplayPart description;
    std::uint64_t number = 0;
    ShapePointer wanted;
    ShapePointer next;   // its shape in the state that is shown next, the wanted or an older one; null: in none
    ShapePointer shown;  // the shown shape; null: no shape is ready
    std::vector<vtkSmartPointer<vtkActor>> actors;
    std::uint64_t nextSince = 0;  // number of the call of set() with the next state
    std::uint64_t goneSince = 0;  // number of the call that removed the part; 0: it is there
    bool isIn(const std::string& group) const { return !group.empty() && description.group == group; }
  };

  ShapePointer shapeFor(const Soup& soup, std::size_t scanned);
  void showAlone(Part& part);
  void showGroup(const std::string& group);
  bool isUpToDate(const std::string& group) const;
  bool isNextComplete(const std::string& group) const;
  void show(Part& part, const ShapePointer& shape);
  void addActor(Part& part, vtkPolyData* block);
  void remove(Part& part);
  void place(const Part& part) const;
  bool isHighlighted(const Part& part) const;
  void style(const Part& part) const;
  void updateBounds();

  LayerProps& m_props;
  const double m_opacity;
  std::vector<Part> m_parts;
  std::vector<Part> m_leaving;  // removed parts, which stay in view until the changes made with them can be shown
  std::map<std::string, std::uint64_t> m_next;  // groups that will change: number of the call with their next state
  std::map<Soup, std::weak_ptr<Shape>> m_shapes;
  std::deque<std::pair<ShapePointer, SurfaceGeometry>> m_queue;
  std::uint64_t m_lastNumber = 0;
  std::uint64_t m_changes = 0;  // number of calls of set()
  Box m_bounds;
  SurfaceStyle m_style;
  Vec3 m_origin = Vec3::Zero();
  std::set<std::string> m_faded;
  std::string m_faintGroup;
  std::string m_highlighted;       // name of the highlighted part
  std::string m_highlightedGroup;  // group of that part
  std::set<std::string> m_selected;
  bool m_isCovered = false;  // all parts except the selected ones are drawn translucently
  int m_built = 0;
};

}  // namespace handwheel
