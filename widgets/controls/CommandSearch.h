// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace handwheel {

// A command as it can be found.
struct CommandText {
  QString id;        // English, in camel case: "saveAs"
  QString title;     // as shown
  QString path;      // menus
  QString hint;      // tooltip
  QString shortcut;  // as shown
};

// Finds commands by what is typed. Case and accents do not matter.
class CommandSearch {
 public:
  void setCommands(const std::vector<CommandText>& commands);

  // Numbers of the commands that match, best first: those whose title begins with the query, then those where the
  // query's letters begin words of the title ("sa" for "Save as"), then those that hold it, then those that hold its
  // letters in order; last, those where all its words begin words of id, menus, shortcut or tooltip. Among equals the
  // recently used (ids, last first) come first, then shorter titles. Without a query: the recent ones, then all in
  // order.
  std::vector<int> find(const QString& query, const QStringList& recent) const;

 private:
  struct Entry {
    QString id;
    QString title;         // folded, as the others
    QString englishTitle;  // the id as words
    QStringList words;     // of all texts
  };
  static int rank(const Entry& entry, const QString& query);

  std::vector<Entry> m_entries;
};

}  // namespace handwheel
