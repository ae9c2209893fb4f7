// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../Program.h"

#include <nlohmann/json.hpp>

namespace handwheel {

inline nlohmann::json jsonOf(const QByteArray& text) {
  return nlohmann::json::parse(text.toStdString());
}

// A cell with a built-in robot, configurations and a box. The box obstructs the straight motion between the
// configurations "left" and "right".
class PlannedCell {
 public:
  PlannedCell() { put("cell.handwheel", made()); }
  Ran run(const QStringList& words) const { return m_fixture.run(words); }
  QByteArray read(const QString& name) const { return m_fixture.content(name); }
  // Returns the heading and rows of a table of motions, without remarks.
  QList<QByteArray> rowsOf(const QString& name) const {
    QList<QByteArray> lines = read(name).split('\n');
    lines.removeIf([](const QByteArray& line) { return line.startsWith('#'); });
    return lines;
  }
  void put(const QString& name, const QByteArray& content) const { m_fixture.put(name, content); }

 private:
  // Returns the content of the cell file. The program is run to make it at the first call only.
  static QByteArray made() {
    static const QByteArray file = [] {
      const Fixture fixture;
      for (const QStringList& words :
           {QStringList{"configuration", "irb120", "--add", "left", "--joints", "joint_1=1.2,joint_2=0.5"},
            QStringList{"configuration", "cell.handwheel", "--add", "right", "--joints", "joint_1=-1.2,joint_2=0.5"},
            QStringList{"configuration", "cell.handwheel", "--add", "up", "--joints", "joint_2=-0.6,joint_3=-0.6"},
            QStringList{"body", "cell.handwheel", "--add", "box:100,200,800", "--at", "450,0,400"}}) {
        fixture.run(words + QStringList{"-o", "cell.handwheel"});
      }
      return fixture.content("cell.handwheel");
    }();
    return file;
  }

  Fixture m_fixture;
};

}  // namespace handwheel
