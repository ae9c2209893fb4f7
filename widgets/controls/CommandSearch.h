// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace handwheel {

// The searchable texts of a command.
struct CommandText {
  QString id;        // id of the action: English, in camel case ("saveAs")
  QString title;     // displayed text
  QString path;      // menu path
  QString hint;      // tooltip
  QString shortcut;  // displayed text
};

// Finds commands by a search text. Case and accents are ignored.
class CommandSearch {
 public:
  void setCommands(const std::vector<CommandText>& commands);

  // Returns the indices of the commands that match, best first. First are commands whose title begins with the query,
  // second titles with words that begin with the query's letters ("sa" for "Save as"), third titles that contain the
  // query, and fourth titles that contain its letters in order. Last are commands for which each word of the query
  // begins a word of id, menus, shortcut or tooltip. Equal matches are sorted by recent use, then by length of the
  // title. recent: ids of the recently used commands, the last one first. For an empty query, returns the recent
  // commands, then all others in order.
  std::vector<int> find(const QString& query, const QStringList& recent) const;

 private:
  struct Entry {
    QString id;
    QString title;         // case-folded and without accents, like the other texts
    QString englishTitle;  // the id as words
    QStringList words;     // words of all texts
  };
  static int rank(const Entry& entry, const QString& query);

  std::vector<Entry> m_entries;
};

}  // namespace handwheel
