// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/GlobeRegistration.h"

#include "globe/cli/InflateCommand.h"
#include "globe/document/GlobeKind.h"
#include "globe/window/GlobeUi.h"

namespace handwheel::test {

KindRegistration globeRegistration(const QString& sample) {
  const auto window = [sample](const WindowContext& parts) { return std::make_unique<GlobeUi>(parts, sample); };
  return {{std::make_unique<GlobeKind>(), window}, {inflateCommand()}};
}

std::vector<KindRegistration> kindsWithGlobe(const QString& sample) {
  std::vector<KindRegistration> all = builtInKinds();
  all.insert(all.begin(), globeRegistration(sample));
  return all;
}

}  // namespace handwheel::test
