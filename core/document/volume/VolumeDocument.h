// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/volume/VolumeSnapshot.h"
#include "volume/segment/Segment.h"

namespace handwheel {

struct PreparedShare;

// Document of a volume: material in voxels.
class VolumeDocument : public Document {
  Q_OBJECT

 public:
  // opened: the content is a VolumeSnapshot.
  explicit VolumeDocument(OpenedFile opened, QObject* parent = nullptr);

  const std::shared_ptr<const VolumeSnapshot>& volume() const { return m_volume; }

  // The image that it was made from; null: none.
  const std::shared_ptr<const Scan>& scan() const { return m_scan; }
  // What is chosen of it.
  const Segment& segment() const { return m_segment; }

  SnapshotPointer snapshot() const override { return completed(m_volume); }
  // The holes that were drilled in work on an exercise; null: none.
  const std::shared_ptr<const TriedHoles>& tried() const { return m_tried; }
  // Whether it is work on an exercise, which measures what the drill takes: all marks are lost when anything else
  // changes the volume. A mask changes nothing.
  bool isToBeDrilled() const { return static_cast<bool>(file().assigned); }
  std::uint32_t tryCount() const { return triesCounted(m_tried.get(), m_volume->holes); }
  // Adds one that was drilled. No undo step: what was tried stays tried.
  void addTried(const DrillRecord& hole, double forbidden);

  // The value that the document has when its volume is this one: with the scan, the segment and the tries of now.
  std::shared_ptr<const VolumeSnapshot> completed(const std::shared_ptr<const VolumeSnapshot>& volume) const;
  // Layers have "layer.1.name", "layer.1.on" and "layer.1.strength", the lowest being 1.
  std::vector<Property> properties() const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

  // Gives what the share of a layer becomes in the present volume, so that setting the property takes no time. Null:
  // nothing is known. It is kept until the next call; what is of another volume or share is not used.
  void prepare(std::shared_ptr<const PreparedShare> share) { m_prepared = std::move(share); }

 private:
  friend class VolumeEdit;
  friend class SegmentEdit;

  // Its scan, segment and tries are those of the time when it was made: edits of the volume are apart from them.
  std::shared_ptr<const VolumeSnapshot> m_volume;
  std::shared_ptr<const Scan> m_scan;
  Segment m_segment;
  std::shared_ptr<const TriedHoles> m_tried;
  std::shared_ptr<const PreparedShare> m_prepared;
};

}  // namespace handwheel
