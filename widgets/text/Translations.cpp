// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/Translations.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <algorithm>

namespace handwheel {

namespace {

QStringView withoutCountry(QStringView code) {
  const auto end = std::find_if(code.begin(), code.end(), [](QChar c) { return c == u'_' || c == u'-'; });
  return code.first(end - code.begin());
}

}  // namespace

QList<Language> windowLanguages() {
  return {{QStringLiteral("en"), QStringLiteral("English")},
          {QStringLiteral("de"), QStringLiteral("Deutsch")},
          {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
}

QString languageFor(const QString& setting, const QStringList& wanted) {
  const QList<Language> all = windowLanguages();
  for (const Language& language : all)
    if (language.code == setting) return setting;
  for (const QString& code : wanted)
    for (const Language& language : all)
      if (withoutCountry(language.code) == withoutCountry(code)) return language.code;
  return all.front().code;
}

Translations::Translations(const QString& setting) : m_language(languageFor(setting, QLocale::system().uiLanguages())) {
  // A user with the language of the system keeps the numbers of the own country.
  const QLocale locale(m_language);
  if (m_language == setting && locale.language() != QLocale::system().language()) QLocale::setDefault(locale);

  // The translator installed last is asked first.
  QCoreApplication::installTranslator(&m_plurals);
  if (m_qt.load(QStringLiteral("qtbase_") + m_language, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&m_qt);
  if (m_own.load(QStringLiteral(":/translations/handwheel_") + m_language)) QCoreApplication::installTranslator(&m_own);
}

Translations::~Translations() {
  QLocale::setDefault(m_localeBefore);
}

}  // namespace handwheel
