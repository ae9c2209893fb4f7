// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/CommandSearch.h"

#include <QRegularExpression>
#include <algorithm>
#include <tuple>

namespace handwheel {

namespace {

constexpr int kNoMatch = 100;

// Converts to lower case without accents: "Öffnen" is found by "offnen", "schließen" by "schliessen".
QString folded(const QString& text) {
  QString result;
  for (QChar c : text.normalized(QString::NormalizationForm_KD).toCaseFolded()) {
    if (!c.isMark()) result += c;
  }
  return result.replace(QChar(0xdf), QStringLiteral("ss"));
}

QStringList wordsOf(const QString& text) {
  static const QRegularExpression kBetween(QStringLiteral(R"([^\w+]+)"),
                                           QRegularExpression::UseUnicodePropertiesOption);
  return text.split(kBetween, Qt::SkipEmptyParts);
}

// Converts "saveAs" to "save as".
QString spacedOut(const QString& id) {
  QString words;
  for (QChar c : id) {
    if (c.isUpper()) words += QLatin1Char(' ');
    words += c;
  }
  return folded(words);
}

// Returns true if the letters can be taken from the beginnings of words, in order: "se" or "shed" of "shaded with
// edges".
bool beginWords(QStringView letters, const QStringList& words, qsizetype from = 0) {
  if (letters.isEmpty()) return true;
  for (qsizetype i = from; i < words.size(); ++i) {
    const QString& word = words[i];
    qsizetype common = 0;
    while (common < std::min(letters.size(), word.size()) && letters[common] == word[common]) ++common;
    for (; common > 0; --common) {
      if (beginWords(letters.mid(common), words, i + 1)) return true;
    }
  }
  return false;
}

bool holdsInOrder(const QString& text, const QString& letters) {
  qsizetype at = 0;
  for (QChar c : letters) {
    at = text.indexOf(c, at) + 1;
    if (at == 0) return false;
  }
  return true;
}

bool eachBeginsAWord(const QStringList& query, const QStringList& words) {
  return std::all_of(query.begin(), query.end(), [&](const QString& part) {
    return std::any_of(words.begin(), words.end(), [&](const QString& word) { return word.startsWith(part); });
  });
}

int rankInTitle(const QString& title, const QString& query, const QString& letters) {
  if (title.startsWith(query)) return 0;
  if (beginWords(letters, wordsOf(title))) return 1;
  if (title.contains(query)) return 2;
  return holdsInOrder(title, letters) ? 3 : kNoMatch;
}

}  // namespace

void CommandSearch::setCommands(const std::vector<CommandText>& commands) {
  m_entries.clear();
  for (const CommandText& c : commands) {
    const QString rest = folded(QStringList{c.title, c.path, c.hint}.join(QLatin1Char(' ')));
    QStringList words = wordsOf(rest) + wordsOf(spacedOut(c.id));
    words << folded(c.shortcut);
    m_entries.push_back({c.id, folded(c.title), spacedOut(c.id), words});
  }
}

int CommandSearch::rank(const Entry& entry, const QString& query) {
  const QString letters = QString(query).remove(QLatin1Char(' '));
  const int best = std::min(rankInTitle(entry.title, query, letters), rankInTitle(entry.englishTitle, query, letters));
  if (best != kNoMatch) return best;
  return eachBeginsAWord(query.split(QLatin1Char(' ')), entry.words) ? 4 : kNoMatch;
}

std::vector<int> CommandSearch::find(const QString& query, const QStringList& recent) const {
  const QString wanted = folded(query.simplified());
  struct Match {
    int command, rank;
    qsizetype age, length;
    auto key() const { return std::tuple(rank, age, length, command); }
  };
  std::vector<Match> matches;
  for (std::size_t i = 0; i < m_entries.size(); ++i) {
    const Entry& entry = m_entries[i];
    const int r = wanted.isEmpty() ? 0 : rank(entry, wanted);
    if (r == kNoMatch) continue;
    const qsizetype known = recent.indexOf(entry.id);
    const qsizetype age = known < 0 ? recent.size() : known;
    matches.push_back({static_cast<int>(i), r, age, wanted.isEmpty() ? 0 : entry.title.size()});
  }
  std::sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) { return a.key() < b.key(); });
  std::vector<int> commands;
  for (const Match& match : matches) commands.push_back(match.command);
  return commands;
}

}  // namespace handwheel
