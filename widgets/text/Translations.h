// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "text/EnglishPlurals.h"

#include <QList>
#include <QLocale>
#include <QStringList>
#include <QTranslator>

namespace handwheel {

struct Language {
  QString code;  // "de", "zh_CN"
  QString name;  // in the language itself
};

// The languages of the window; English, in which the sources are written, is the first.
QList<Language> windowLanguages();

// The code of the language that a setting means: its own, or with "system" the first of the wanted ones that there is,
// else English. The wanted ones are written as in QLocale::uiLanguages.
QString languageFor(const QString& setting, const QStringList& wanted);

// Makes the window speak a language, and write numbers as is usual in it, for as long as this lives. Made before the
// first widget, so a change of the setting shows at the next start. The command line speaks English and makes none.
class Translations {
 public:
  explicit Translations(const QString& setting);
  ~Translations();
  Translations(const Translations&) = delete;
  Translations& operator=(const Translations&) = delete;

  QString language() const { return m_language; }

 private:
  QString m_language;
  QLocale m_localeBefore;
  EnglishPlurals m_plurals;
  QTranslator m_qt;  // the texts of Qt's own dialogs, where the system has them
  QTranslator m_own;
};

}  // namespace handwheel
