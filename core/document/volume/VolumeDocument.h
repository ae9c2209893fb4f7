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
  // opened: a file whose content is a VolumeSnapshot.
  explicit VolumeDocument(OpenedFile opened, QObject* parent = nullptr);

  const std::shared_ptr<const VolumeSnapshot>& volume() const { return m_volume; }

  // Image from which the volume was made; null: none.
  const std::shared_ptr<const Scan>& scan() const { return m_scan; }
  // Segment of the scan.
  const Segment& segment() const { return m_segment; }

  SnapshotPointer snapshot() const override { return completed(m_volume); }
  // Holes that were drilled in an exercise; null: none.
  const std::shared_ptr<const TriedHoles>& tried() const { return m_tried; }
  // Returns true if the document is work on an exercise of drilling. The work gets no marks if a tool other than the
  // drill changes the volume; a mask does not change it.
  bool isToBeDrilled() const { return static_cast<bool>(file().assigned); }
  std::uint32_t tryCount() const { return triesCounted(m_tried.get(), m_volume->holes); }
  // Adds a drilled hole to the tries. Undo does not remove it.
  void addTried(const DrillRecord& hole, double forbidden);

  // Returns the content of the document with this volume, and with the current scan, segment and tries.
  std::shared_ptr<const VolumeSnapshot> completed(const std::shared_ptr<const VolumeSnapshot>& volume) const;
  // Returns the properties. Those of a layer are "layer.1.name", "layer.1.on" and "layer.1.strength", with 1 for the
  // lowest.
  std::vector<Property> properties() const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

  // Provides the precomputed change of a layer's strength, or of whether it is on, so that setting the property takes
  // no time. null: none. The change is kept until the next call, and is not used for another volume or share.
  void prepare(std::shared_ptr<const PreparedShare> share) { m_prepared = std::move(share); }

 private:
  friend class VolumeEdit;
  friend class SegmentEdit;

  // The scan, segment and tries of this snapshot are those of its creation, as edits of the volume do not update them.
  std::shared_ptr<const VolumeSnapshot> m_volume;
  std::shared_ptr<const Scan> m_scan;
  Segment m_segment;
  std::shared_ptr<const TriedHoles> m_tried;
  std::shared_ptr<const PreparedShare> m_prepared;
};

}  // namespace handwheel
