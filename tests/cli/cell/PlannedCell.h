// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../Program.h"

#include <nlohmann/json.hpp>

namespace handwheel {

inline nlohmann::json jsonOf(const QByteArray& text) {
  return nlohmann::json::parse(text.toStdString());
}

// A cell of a built-in robot between two configurations, with a box between them. The box is on the straight line.
class PlannedCell {
 public:
  PlannedCell() {
    run({"configuration", "irb120", "--add", "left", "--joints", "joint_1=1.2,joint_2=0.5", "-o", "cell.handwheel"});
    run({"configuration", "cell.handwheel", "--add", "right", "--joints", "joint_1=-1.2,joint_2=0.5", "-o",
         "cell.handwheel"});
    run({"configuration", "cell.handwheel", "--add", "up", "--joints", "joint_2=-0.6,joint_3=-0.6", "-o",
         "cell.handwheel"});
    run({"body", "cell.handwheel", "--add", "box:100,200,800", "--at", "450,0,400", "-o", "cell.handwheel"});
  }
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
  Fixture m_fixture;
};

}  // namespace handwheel
