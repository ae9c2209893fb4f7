// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

class VolumeDocument;

// Why tools other than the drill are not to change a volume; English, context "Tool". Null: they may.
const char* shapingObstacle(const VolumeDocument& document);

}  // namespace handwheel
