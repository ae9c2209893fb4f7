// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../Program.h"
#include "../Shapes.h"
#include "BuildPaths.h"

#include <QTest>
#include <csignal>

// Helpers for tests of batch repair: folders of files, and a running batch.
namespace handwheel {

// Returns an open tube that keeps the program busy for a second or more, also on a fast machine.
inline QByteArray largeTube() {
  static const QByteArray tube = [] {
    constexpr int n = 300;
    const auto at = [](int x, int y) {
      const double u = 2 * M_PI * x / n;
      return std::array<double, 3>{std::cos(u), std::sin(u), 0.01 * y};
    };
    return grid(n, n, at, [](int, int) { return false; }).off();
  }();
  return tube;
}

inline void putInto(const Fixture& fixture, const QString& name, const QByteArray& content) {
  QVERIFY(QDir(fixture.path()).mkpath(QFileInfo(name).path()));
  fixture.put(name, content);
}

// Adds good files. One of them has a hole, and two of them are in a subfolder.
inline void putGoodFiles(const Fixture& fixture) {
  putInto(fixture, "in/a.off", openCube().off());
  putInto(fixture, "in/sub/b.off", cube().off());
  putInto(fixture, "in/sub/c.off", tetrahedron().off());
}

// Returns a text such as "a.off closed" for each file in the order of the report.
inline QStringList states(const nlohmann::json& report) {
  QStringList list;
  for (const nlohmann::json& file : report.at("files")) {
    list << QString::fromStdString(file.at("input").get<std::string>() + " " + file.at("state").get<std::string>());
  }
  return list;
}

inline QByteArray lineWith(const Ran& ran, const QByteArray& words) {
  for (const QByteArray& line : ran.out.split('\n')) {
    if (line.contains(words)) return line;
  }
  return {};
}

inline QByteArray contentOf(pid_t process, const char* name) {
  QFile file(QString("/proc/%1/%2").arg(process).arg(name));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Returns the state and the parent of a process from /proc/PID/stat. They follow the program's name, which may contain
// any characters.
inline QList<QByteArray> stateAndParent(pid_t process) {
  const QByteArray stat = contentOf(process, "stat");
  return stat.mid(stat.lastIndexOf(')') + 2).split(' ').mid(0, 2);
}
inline pid_t parentOf(pid_t process) {
  return stateAndParent(process).value(1).toInt();
}
// Returns true if the process has ended, even if its parent has not collected its exit status yet.
inline bool isGone(pid_t process) {
  const QByteArray state = stateAndParent(process).value(0);
  return state.isEmpty() || state == "Z";
}

// A running batch.
class Batch {
 public:
  Batch(const Fixture& fixture, const QStringList& words) {
    m_process.setWorkingDirectory(fixture.path());
    auto environment = QProcessEnvironment::systemEnvironment();
    // With this option, a signal ends a program with sanitizers as it ends one without them.
    environment.insert("ASAN_OPTIONS", environment.value("ASAN_OPTIONS") + ":handle_segv=0");
    m_process.setProcessEnvironment(environment);
    m_process.start(test::programPath(), QStringList{"repair"} + words);
    if (!m_process.waitForStarted()) qFatal("the program does not start");
  }
  // Returns the processes that repair a file: child processes that already execute the program.
  QList<pid_t> children() const {
    QList<pid_t> found;
    for (const QString& name : QDir("/proc").entryList(QDir::Dirs)) {
      const pid_t process = name.toInt();
      if (process == 0 || parentOf(process) != m_process.processId()) continue;
      if (contentOf(process, "cmdline").contains("--json")) found << process;
    }
    return found;
  }
  // Returns the process that repairs a file of this name; returns 0 if there is none at present.
  pid_t childFor(const QByteArray& name) const {
    for (pid_t child : children()) {
      if (contentOf(child, "cmdline").contains(name)) return child;
    }
    return 0;
  }
  void send(int signal) { ::kill(static_cast<pid_t>(m_process.processId()), signal); }
  Ran finish() {
    if (!m_process.waitForFinished(kLongestRun)) return {};
    const int code = m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
    return {code, m_process.readAllStandardOutput(), m_process.readAllStandardError()};
  }

 private:
  QProcess m_process;
};

inline bool tellsOf(const Fixture& fixture, const char* file) {
  const QByteArray report = fixture.content("out/repair-report.json");
  return report.contains(file);
}

}  // namespace handwheel
