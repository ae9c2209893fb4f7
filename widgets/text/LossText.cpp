// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/LossText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct LossWords {
  Q_DECLARE_TR_FUNCTIONS(RepairText)
};

QString lostAttributeName(LostAttribute attribute) {
  switch (attribute) {
    case LostAttribute::Colour:
      return LossWords::tr("colours");
    case LostAttribute::Normals:
      return LossWords::tr("normals");
    case LostAttribute::TextureCoordinates:
      return LossWords::tr("texture coordinates");
    case LostAttribute::Materials:
      return LossWords::tr("materials");
    case LostAttribute::Groups:
      return LossWords::tr("groups");
    case LostAttribute::Lines:
      return LossWords::tr("lines");
    case LostAttribute::Points:
      return LossWords::tr("isolated points");
    case LostAttribute::Curves:
      return LossWords::tr("curves");
    case LostAttribute::ExactSurfaces:
      return LossWords::tr("exact surfaces");
    case LostAttribute::Other:
      return LossWords::tr("further data");
  }
  return {};
}

// Returns names for display. pattern: the format of a name that comes from the file.
QStringList lostNamesIn(const DocumentFile& file, const QString& pattern) {
  QStringList names;
  for (const LostAttribute attribute : file.lost) {
    if (attribute == LostAttribute::Other && !file.lostOther.empty()) {
      for (const std::string& name : file.lostOther)
        names << (name.empty() ? lostAttributeName(attribute) : pattern.arg(QString::fromStdString(name)));
    } else {
      names << lostAttributeName(attribute);
    }
  }
  return names;
}

}  // namespace

QStringList lostNames(const DocumentFile& file) {
  return lostNamesIn(file, QStringLiteral("%1"));
}

QString lostText(const DocumentFile& file) {
  return lostNamesIn(file, LossWords::tr("“%1”")).join(QStringLiteral(", "));
}

}  // namespace handwheel
