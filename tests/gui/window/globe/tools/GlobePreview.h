// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "globe/document/GlobeSurface.h"
#include "tools/Tool.h"

namespace handwheel::test {

// The preview of a globe tool, shown instead of the document.
struct GlobePreview : KindPreview {
  explicit GlobePreview(GlobeSurface s) : surface(std::move(s)) {}
  GlobeSurface surface;
};

}  // namespace handwheel::test
