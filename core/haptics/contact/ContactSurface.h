// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "haptics/contact/ContactHierarchy.h"
#include "haptics/contact/PagedIndexSet.h"

#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// The triangles that the device tip can touch, with box queries. The queries are for the servo thread. ContactSurface
// is a value type: a copy is a cheap snapshot, and may be read on another thread while the original is edited. Edits
// take time proportional to the number of triangles that they change. The initial hierarchy is never modified; removed
// triangles are marked in it, and added triangles are stored in smaller hierarchies, which are merged as they grow
// (Bentley and Saxe, "Decomposable searching problems I", 1980).
class ContactSurface {
 public:
  ContactSurface() = default;
  // The id of a triangle is its index in the span. O(n log n). The surface is empty if the construction was cancelled.
  ContactSurface(std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress = {});

  // Creates a surface from triangles with given ids. The ids should be nearly consecutive, because memory is
  // proportional to the largest id.
  explicit ContactSurface(std::vector<ContactTriangle> triangles, Progress progress = {});

  // Combines the surfaces of rigid bodies at their poses, so that the proxy slides from body to body. The new surface
  // shares the hierarchies of the bodies, which stay in the frames of the bodies, so that a body is moved in O(number
  // of bodies). The ids are those in the surfaces of the bodies. before: the previous surface of the same bodies, if
  // the new surface is to count as a version of it. update() must not be called on the new surface.
  struct Placed;
  explicit ContactSurface(std::span<const Placed> bodies, const ContactSurface* before = nullptr);

  // Removes triangles by id (unknown ids are ignored), and then adds or replaces triangles. O(k log² n) for k
  // triangles, amortised over many edits.
  void update(std::span<const std::uint32_t> removed, std::span<const ContactTriangle> added);

  // Returns the diagonal of the bounding box of all triangles ever added, mm. Tolerances are relative to it.
  double diagonal() const { return m_bounds.isEmpty() ? 0.0 : m_bounds.diagonal().norm(); }
  const Box& bounds() const { return m_bounds; }  // bounding box of all triangles ever added
  // Returns the distance that a proxy keeps from the surface, mm. It is larger far from the origin, where coordinates
  // are coarser.
  double skin() const;
  bool empty() const { return m_layers.empty(); }
  // Returns a version number that changes with each edit. Only copies have the same number. A moved-from surface must
  // not be used.
  std::uint64_t version() const { return m_version; }
  // Returns true if the two surfaces were derived from the same surface by edits.
  bool isVersionOf(const ContactSurface& other) const { return m_origin == other.m_origin; }

  // Calls visit(const ContactTriangle&) for each triangle whose bounding box meets the box, until visit returns false.
  // In placed bodies, some of these triangles may be skipped if they do not meet the box themselves. Returns false if
  // visit did. Neither allocates nor locks.
  template <class Visit>
  bool forEachInBox(const Box& box, Visit visit) const {
    for (const Layer& layer : m_layers) {
      const ContactHierarchy& part = *layer.part;
      const bool all =
          layer.placement ? forEachPlaced(layer, box, visit) : part.forEachInBox(box, [&](std::size_t slot) {
            return layer.dead.contains(slot) || visit(part.triangle(slot));
          });
      if (!all) return false;
    }
    return true;
  }

 private:
  struct Placement {
    Pose pose, inverse;
    Box bounds;       // bounding box of the placed layer; may be larger
    double rounding;  // mm, rounding error of a corner that is transformed to the pose or back
  };
  // A hierarchy that can be shared, with marks for the triangles that are removed.
  struct Layer {
    std::shared_ptr<const ContactHierarchy> part;
    PagedIndexSet dead;
    std::uint32_t serial = 0;
    std::shared_ptr<const Placement> placement = {};  // null: the identity
  };
  // Location of a stored triangle. Layers are identified by serial number, because their indices change when layers are
  // merged.
  struct Location {
    std::uint32_t serial = kNone;
    std::uint32_t slot = 0;
  };

  // Visits all triangles of a placed layer that meet the box, and some whose bounding boxes meet it. Corners that are
  // equal in the part stay equal.
  template <class Visit>
  static bool forEachPlaced(const Layer& layer, const Box& box, Visit& visit) {
    const Placement& placement = *layer.placement;
    if (!placement.bounds.intersects(box)) return true;
    const Vec3 rounding = Vec3::Constant(placement.rounding);
    const Box own = box.transformed(placement.inverse);
    return layer.part->forEachInBox(Box(own.min() - rounding, own.max() + rounding), [&](std::size_t slot) {
      if (layer.dead.contains(slot)) return true;
      ContactTriangle t = layer.part->triangle(slot);
      for (Vec3& corner : t.corners) corner = placement.pose * corner;
      return !ContactHierarchy::meets(t.corners, box) || visit(t);
    });
  }

  void add(std::vector<ContactTriangle> triangles, Progress progress = {});
  void remove(std::uint32_t id);
  Layer* layerOf(std::uint32_t serial);

  std::vector<Layer> m_layers;       // the first is the largest
  PagedArray<Location> m_locations;  // indexed by triangle id
  Box m_bounds;
  std::uint32_t m_nextSerial = 0;
  std::uint64_t m_version = 0;
  std::uint64_t m_origin = 0;  // number of the first version that had triangles
};

// A surface in the frame of a body, and the pose of the body.
struct ContactSurface::Placed {
  ContactSurface surface;
  Pose pose = Pose::Identity();
};

}  // namespace handwheel
