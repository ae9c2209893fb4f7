// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

namespace handwheel {

// Writes the "(s)" of source texts with a number ("%n hole(s)") as English wants it. Installed before any other
// translator, so that it only speaks where no translation is at hand.
class EnglishPlurals : public QTranslator {
 public:
  using QTranslator::QTranslator;

  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
};

}  // namespace handwheel
