// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

namespace handwheel {

// A translator that forms English plurals of source texts ("%n hole(s)", "%n body(ies)"). It must be installed before
// any other translator: Qt asks the one installed last first, so this one is asked only if there is no translation.
class EnglishPlurals : public QTranslator {
 public:
  using QTranslator::QTranslator;

  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
};

}  // namespace handwheel
