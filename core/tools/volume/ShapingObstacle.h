// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

class VolumeDocument;

// Returns the reason why only the drill may change a volume. Returns null if all tools may. It is English text,
// translated in the context "Tool".
const char* shapingObstacle(const VolumeDocument& document);

}  // namespace handwheel
