// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/volume/VolumeSnapshot.h"
#include "volume/segment/Segment.h"

namespace handwheel {

// Document of a volume: material in voxels.
class VolumeDocument : public Document {
  Q_OBJECT

 public:
  // opened: the content is a VolumeSnapshot.
  explicit VolumeDocument(OpenedFile opened, QObject* parent = nullptr);

  const std::shared_ptr<const VolumeSnapshot>& volume() const { return m_volume; }

  // The image that was opened; null: none was, as in a document that was saved.
  const std::shared_ptr<const Scan>& scan() const { return m_scan; }
  // What is chosen of it; not saved.
  const Segment& segment() const { return m_segment; }

  SnapshotPointer snapshot() const override { return m_volume; }
  std::vector<Property> properties() const override;

 private:
  friend class VolumeEdit;
  friend class SegmentEdit;

  std::shared_ptr<const VolumeSnapshot> m_volume;
  std::shared_ptr<const Scan> m_scan;
  Segment m_segment;
};

}  // namespace handwheel
