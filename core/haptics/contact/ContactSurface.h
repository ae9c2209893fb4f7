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

// The triangles that the device tip can touch, with box queries. The queries are for the servo thread. A value type: a
// copy is a snapshot, is cheap and may be read on another thread while this one is edited. Edits take time proportional
// to what they change: the initial hierarchy stays as it is, removed triangles are marked in it, and added ones are
// stored in smaller hierarchies, which are merged as they grow (Bentley and Saxe, "Decomposable searching problems I",
// 1980).
class ContactSurface {
 public:
  ContactSurface() = default;
  // The id of a triangle is its index in the span. O(n log n). Empty if cancelled.
  ContactSurface(std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress = {});

  // The triangles have ids of their own. These need not be consecutive but should be: memory is proportional to the
  // largest.
  explicit ContactSurface(std::vector<ContactTriangle> triangles, Progress progress = {});

  // Combines the surfaces of rigid bodies at their poses: the proxy slides from body to body. They share the
  // hierarchies, which stay in their own frames, so a body is moved in O(number of bodies). Ids are those in the
  // surfaces. before: the previous surface of these bodies, if this is to count as a version of it. Not to be updated.
  struct Placed;
  explicit ContactSurface(std::span<const Placed> bodies, const ContactSurface* before = nullptr);

  // Removes triangles by id (unknown ids are ignored), then adds or replaces some. O(k log² n) for k triangles,
  // amortised over many edits.
  void update(std::span<const std::uint32_t> removed, std::span<const ContactTriangle> added);

  // Returns the diagonal (mm) of the bounding box of all triangles ever added. Tolerances are relative to it.
  double diagonal() const { return m_bounds.isEmpty() ? 0.0 : m_bounds.diagonal().norm(); }
  const Box& bounds() const { return m_bounds; }  // box of all triangles ever added
  // Returns the distance that a proxy keeps from the surface, mm. It is larger far from the origin, where coordinates
  // are coarser.
  double skin() const;
  bool empty() const { return m_layers.empty(); }
  // Returns a version number that changes with each edit; only copies have the same. (A moved-from surface must not be
  // used.)
  std::uint64_t version() const { return m_version; }
  // Returns true if both were derived from the same surface by edits, and not from different models.
  bool isVersionOf(const ContactSurface& other) const { return m_origin == other.m_origin; }

  // Calls visit(const ContactTriangle&) for each triangle whose box meets the box (for placed bodies: at least for each
  // triangle that meets it itself), until it returns false. Returns false when a visit did. Neither allocates nor
  // locks.
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
    Box bounds;       // bounds of the placed layer; may be larger
    double rounding;  // mm: rounding error of a corner that is transformed to the pose or back
  };
  // A hierarchy, with marks for removed triangles, so that it can be shared.
  struct Layer {
    std::shared_ptr<const ContactHierarchy> part;
    PagedIndexSet dead;
    std::uint32_t serial = 0;
    std::shared_ptr<const Placement> placement = {};  // null: the identity
  };
  // Location of a stored triangle. Layers are identified by serial number because they move when others are merged.
  struct Location {
    std::uint32_t serial = kNone;
    std::uint32_t slot = 0;
  };

  // Visits the triangles of a placed layer: all that meet the box, and some more whose own boxes do. Corners that are
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
  PagedArray<Location> m_locations;  // by triangle id
  Box m_bounds;
  std::uint32_t m_nextSerial = 0;
  std::uint64_t m_version = 0;
  std::uint64_t m_origin = 0;  // number of its first version that had triangles
};

// A surface in the frame of a body, and the pose of the body.
struct ContactSurface::Placed {
  ContactSurface surface;
  Pose pose = Pose::Identity();
};

}  // namespace handwheel
