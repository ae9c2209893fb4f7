// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "text/EnglishPlurals.h"

#include <QList>
#include <QLocale>
#include <QStringList>
#include <QTranslator>

namespace handwheel {

// A language of the user interface.
struct Language {
  QString code;  // "de", "zh_CN"
  QString name;  // in the language itself
};

// Returns the languages of the user interface; English, the language of the source texts, is first.
QList<Language> windowLanguages();

// Returns the language code for a setting. A setting of "system" gives the first available one of the wanted languages,
// else English. The wanted ones are written as in QLocale::uiLanguages.
QString languageFor(const QString& setting, const QStringList& wanted);

// Installs the translators and the locale of a language for its lifetime. To be created before the first widget, so a
// change of the setting takes effect at the next start. The command line is always English and creates none.
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
  QTranslator m_qt;  // the texts of Qt's own dialogs, if installed
  QTranslator m_own;
};

}  // namespace handwheel
