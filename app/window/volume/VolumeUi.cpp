// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/VolumeUi.h"

#include "document/volume/VolumeDocument.h"
#include "theme/Theme.h"
#include "window/documents/DocumentTab.h"

#include <QLocale>

namespace handwheel {

VolumeUi::VolumeUi(const WindowContext& window) : RigidPartsUi(window, {"Volume"}) {}

NextStep VolumeUi::nextStep() {
  if (!document()) return {};
  const auto& volume = static_cast<const VolumeDocument&>(document()->document).volume()->volume;
  return {panelIcon(), themeColours(currentTheme()).accent, tr("Volume"),
          tr("%1 mm³ in voxels of %2 mm. Its surface is closed.")
              .arg(QLocale().toString(volume.material(), 'g', 6), QLocale().toString(volume.voxel(), 'g', 4)),
          panelActions()};
}

QString VolumeUi::openedText(const DocumentTab& opened) const {
  return tr("Opened %1: a volume").arg(opened.document.name());
}

}  // namespace handwheel
