// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/volume/VolumeSnapshot.h"

namespace handwheel {

// Document of a volume: material in voxels.
class VolumeDocument : public Document {
  Q_OBJECT

 public:
  // opened: the content is a VolumeSnapshot.
  explicit VolumeDocument(OpenedFile opened, QObject* parent = nullptr);

  const std::shared_ptr<const VolumeSnapshot>& volume() const { return m_volume; }

  SnapshotPointer snapshot() const override { return m_volume; }
  std::vector<Property> properties() const override;

 private:
  friend class VolumeEdit;

  std::shared_ptr<const VolumeSnapshot> m_volume;
};

}  // namespace handwheel
