// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/volume/VolumeSnapshot.h"

namespace handwheel {

// An edit that replaces the content of a volume. Versions share equal blocks and pieces, so the edit holds only the
// changed ones.
class VolumeEdit : public Edit {
 public:
  // changedBlocks: the number of blocks that differ from the document's, from which the size of the edit is computed.
  // property: the only property that changes; empty: several may change.
  VolumeEdit(std::shared_ptr<const VolumeSnapshot> volume, std::size_t changedBlocks, std::string property = {})
      : m_volume(std::move(volume)), m_changedBlocks(changedBlocks), m_property(std::move(property)) {}

  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const VolumeSnapshot> m_volume;
  std::size_t m_changedBlocks;
  std::string m_property;
};

}  // namespace handwheel
