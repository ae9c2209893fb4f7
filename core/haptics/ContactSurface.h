// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "haptics/ContactPart.h"
#include "haptics/SlotSet.h"

#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// The triangles that a tip can touch, found by box on the servo thread. A value: a copy is a snapshot, costs next to
// nothing and may be read on another thread while this one is edited. Edits take time in proportion to what they
// change: the hierarchy made at first stays as it is, removed triangles are marked in it, and added ones stand in
// smaller hierarchies beside it, which are merged as they grow (Bentley and Saxe, "Decomposable searching problems I",
// 1980).
class ContactSurface {
 public:
  ContactSurface() = default;
  // The number of a triangle is its place in the span. O(n log n). Empty once cancelled.
  ContactSurface(std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress = {});

  // With numbers of their own, which need not follow each other but should: memory goes with the largest.
  explicit ContactSurface(std::vector<ContactTriangle> triangles, Progress progress = {});

  // Removes triangles by their numbers (unknown ones are ignored), then adds or replaces some. O(k log² n) for k of
  // them, over many edits.
  void update(std::span<const std::uint32_t> removed, std::span<const ContactTriangle> added);

  // The diagonal of the box around all that was ever in it, mm: the scale of its tolerances.
  double diagonal() const { return m_bounds.isEmpty() ? 0.0 : m_bounds.diagonal().norm(); }
  const Box& bounds() const { return m_bounds; }  // of all that was ever in it
  // How far a proxy stays off the surface, mm. Far from the origin coordinates are coarser than the model's size says.
  double skin() const;
  bool empty() const { return m_layers.empty(); }
  // Changes with each edit; the same for copies, and for them alone. (One that was moved from is not to be touched.)
  std::uint64_t version() const { return m_version; }
  // Whether both came from one by edits, and not from different models.
  bool isVersionOf(const ContactSurface& other) const {
    return empty() == other.empty() && (empty() || m_layers.front().part == other.m_layers.front().part);
  }

  // Calls visit(const ContactTriangle&) for each triangle whose box meets the box, until it returns false. Returns
  // false when a visit did. Neither allocates nor locks.
  template <class Visit>
  bool forEachInBox(const Box& box, Visit visit) const {
    for (const Layer& layer : m_layers) {
      const ContactPart& part = *layer.part;
      const bool all = part.forEachInBox(
          box, [&](std::size_t slot) { return layer.dead.contains(slot) || visit(part.triangle(slot)); });
      if (!all) return false;
    }
    return true;
  }

 private:
  // Removed triangles are marked, so that the part can be shared.
  struct Layer {
    std::shared_ptr<const ContactPart> part;
    SlotSet dead;
    std::uint32_t serial = 0;
  };
  // Where a triangle stands; layers are told apart by serial because they move when others are merged.
  struct Place {
    std::uint32_t serial = kNone;
    std::uint32_t slot = 0;
  };

  void add(std::vector<ContactTriangle> triangles, Progress progress = {});
  void remove(std::uint32_t id);
  Layer* layerOf(std::uint32_t serial);

  std::vector<Layer> m_layers;  // the first is the largest
  PagedArray<Place> m_places;   // by number of triangle
  Box m_bounds;
  std::uint32_t m_nextSerial = 0;
  std::uint64_t m_version = 0;
};

}  // namespace handwheel
