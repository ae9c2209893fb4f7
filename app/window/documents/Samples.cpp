// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/Samples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace handwheel {

QString samplePath(const QString& name) {
  for (const QString& folder : {QCoreApplication::applicationDirPath() + QStringLiteral("/../share/handwheel/samples"),
                                QStringLiteral(HANDWHEEL_SOURCE_SAMPLES)}) {
    for (const QString& below : {QStringLiteral("."), QStringLiteral("exercises")}) {
      const QFileInfo file(QDir(folder + QLatin1Char('/') + below), name);
      if (file.exists()) return file.canonicalFilePath();
    }
  }
  return {};
}

bool isSample(const QFileInfo& file) {
  const QString sample = samplePath(file.fileName());
  return !sample.isEmpty() && file == QFileInfo(sample);
}

}  // namespace handwheel
