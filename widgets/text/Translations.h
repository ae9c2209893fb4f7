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
  QString name;  // name of the language in the language itself
};

// Returns the languages of the user interface; English, the language of the source texts, is first.
QList<Language> windowLanguages();

// Returns the language code for a setting. For the setting "system", returns the first available one of the wanted
// languages, or English if none is available. wanted: language codes in the form of QLocale::uiLanguages().
QString languageFor(const QString& setting, const QStringList& wanted);

// Installs the translators and the locale of a language for its lifetime. It must be created before the first widget,
// so a change of the setting takes effect at the next start. The command line creates no such object and is always in
// English.
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
