// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace handwheel {

// The searchable texts of a command.
struct CommandText {
  QString id;        // English, in camel case: "saveAs"
  QString title;     // displayed text
  QString path;      // menus
  QString hint;      // tooltip
  QString shortcut;  // displayed text
};

// Finds commands by a search text. Case and accents are ignored.
class CommandSearch {
 public:
  void setCommands(const std::vector<CommandText>& commands);

  // Returns the indices of the commands that match, best first: those whose title begins with the query, then those
  // where the query's letters begin words of the title ("sa" for "Save as"), then those that contain it, then those
  // that contain its letters in order; last, those where all its words begin words of id, menus, shortcut or tooltip.
  // Equal matches are sorted by recent use (ids, last first), then by length of the title. Without a query: the recent
  // ones, then all in order.
  std::vector<int> find(const QString& query, const QStringList& recent) const;

 private:
  struct Entry {
    QString id;
    QString title;         // case-folded and without accents, as the others
    QString englishTitle;  // the id as words
    QStringList words;     // words of all texts
  };
  static int rank(const Entry& entry, const QString& query);

  std::vector<Entry> m_entries;
};

}  // namespace handwheel
