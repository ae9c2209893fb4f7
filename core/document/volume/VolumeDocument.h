// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/volume/VolumeSnapshot.h"
#include "volume/segment/Segment.h"

namespace handwheel {

struct PreparedShare;

// A document of a volume: material in voxels.
class VolumeDocument : public Document {
  Q_OBJECT

 public:
  // opened: the content is a VolumeSnapshot.
  explicit VolumeDocument(OpenedFile opened, QObject* parent = nullptr);

  const std::shared_ptr<const VolumeSnapshot>& volume() const { return m_volume; }

  // Image that the volume was made from; null: none.
  const std::shared_ptr<const Scan>& scan() const { return m_scan; }
  // Segment of the scan.
  const Segment& segment() const { return m_segment; }

  SnapshotPointer snapshot() const override { return completed(m_volume); }
  // Holes that were drilled in an exercise; null: none.
  const std::shared_ptr<const TriedHoles>& tried() const { return m_tried; }
  // Returns true if the document is work on an exercise, which measures the drilled material: all marks are lost if any
  // other tool changes the volume. A mask does not change it.
  bool isToBeDrilled() const { return static_cast<bool>(file().assigned); }
  std::uint32_t tryCount() const { return triesCounted(m_tried.get(), m_volume->holes); }
  // Adds a drilled hole to the tries. This is no undo step: tries are permanent.
  void addTried(const DrillRecord& hole, double forbidden);

  // Returns the value of the document for this volume, with the present scan, segment and tries.
  std::shared_ptr<const VolumeSnapshot> completed(const std::shared_ptr<const VolumeSnapshot>& volume) const;
  // Layers have "layer.1.name", "layer.1.on" and "layer.1.strength", the lowest being 1.
  std::vector<Property> properties() const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

  // Provides the precomputed change of a layer's share, so that setting the property takes no time. Null: none. Kept
  // until the next call; ignored for another volume or share.
  void prepare(std::shared_ptr<const PreparedShare> share) { m_prepared = std::move(share); }

 private:
  friend class VolumeEdit;
  friend class SegmentEdit;

  // Scan, segment and tries in it are those of its creation, as edits of the volume do not include them.
  std::shared_ptr<const VolumeSnapshot> m_volume;
  std::shared_ptr<const Scan> m_scan;
  Segment m_segment;
  std::shared_ptr<const TriedHoles> m_tried;
  std::shared_ptr<const PreparedShare> m_prepared;
};

}  // namespace handwheel
